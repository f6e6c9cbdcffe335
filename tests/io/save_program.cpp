// SPDX-License-Identifier: MIT
// Writes a file whole or not at all, for tests that interrupt it: save_program PATH BYTES LETTER
// [pause]. Ends with 0, or with 1 and the reason on standard error. With `pause` it stops when half
// is written, says so on standard output, and waits for a signal.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "io/atomic_file.hpp"
#include "io/temporary_files.hpp"

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const std::string text(std::stoul(argv[2]), argv[3][0]);
  vides::removeTemporaryFilesOnSignals();
  vides::AtomicFile file(argv[1]);
  const std::string_view all = text;
  file.write(all.substr(0, all.size() / 2));
  if (argc > 4) {
    std::puts("half");
    std::fflush(stdout);
    pause();
  }
  file.write(all.substr(all.size() / 2));
  const auto saved = file.commit();
  if (saved) return 0;
  fmt::print(stderr, "{}: {}\n", saved.error().path, saved.error().reason());
  return 1;
}
