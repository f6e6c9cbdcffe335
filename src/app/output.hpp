// SPDX-License-Identifier: MIT
// Where results go: standard output, or a file that appears whole or not at all.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "io/atomic_file.hpp"

namespace vides {

class Output {
 public:
  // "-" is standard output.
  explicit Output(const std::string& name = "-");

  // Buffered. False after an error: writing more is of no use. A closed pipe ends the program
  // without a word, as SIGPIPE does, also where SIGPIPE was ignored by whoever started it.
  bool write(std::string_view text);
  // Call once, when all is written. Tells what went wrong and returns whether nothing did.
  bool finish();

 private:
  bool flush();

  std::string name_;
  std::unique_ptr<AtomicFile> file_;  // null: standard output
  std::string buffer_;
  int error_ = 0;  // errno of standard output
};

// Whether both names lead to the same existing file.
bool sameFile(const std::string& a, const std::string& b);

}  // namespace vides
