// SPDX-License-Identifier: MIT
// Runs a fuzz target over files without libFuzzer: fuzz_NAME_replay FOLDER...
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include "support/files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  int count = 0;
  for (int i = 1; i < argc; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      const std::string text = vides::test::readAll(entry.path());
      std::fprintf(stderr, "%s\n", entry.path().c_str());  // the last one is the culprit
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
      ++count;
    }
  }
  if (count == 0) std::fprintf(stderr, "no files\n");
  return count > 0 ? 0 : 1;
}
