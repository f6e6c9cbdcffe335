// SPDX-License-Identifier: MIT
// Writes a file whole or not at all, for tests that interrupt it: save_program PATH BYTES LETTER
// [pause|again]. Ends with 0, or with 1 and the reason on standard error. With `pause` it stops
// when half is written, says so on standard output, and waits for a signal; with `again` it saves
// again and again, the next letter each time.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <string_view>

#include "io/atomic_file.hpp"
#include "io/temporary_files.hpp"

namespace {

int save(const std::string& path, std::string_view text, bool pauses) {
  vides::AtomicFile file(path);
  file.write(text.substr(0, text.size() / 2));
  if (pauses) {
    std::puts("half");
    std::fflush(stdout);
    pause();
  }
  file.write(text.substr(text.size() / 2));
  const auto saved = file.commit();
  if (saved) return 0;
  fmt::print(stderr, "{}: {}\n", saved.error().path, saved.error().reason());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const std::size_t bytes = std::stoul(argv[2]);
  char letter = argv[3][0];
  const std::string_view how = argc > 4 ? argv[4] : "";
  vides::removeTemporaryFilesOnSignals();
  while (true) {
    const int status = save(argv[1], std::string(bytes, letter), how == "pause");
    if (how != "again" || status != 0) return status;
    letter = letter == 'z' ? 'a' : static_cast<char>(letter + 1);
  }
}
