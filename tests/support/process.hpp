// SPDX-License-Identifier: MIT
// Runs another program from a test: OpenGL drivers read their environment once a process.
#pragma once

#include <string>
#include <vector>

namespace vides::test {

struct ProcessResult {
  int status = -1;     // exit status; 128 + n where signal n ended it
  std::string output;  // standard output
  std::string errors;  // standard error
};

// `environment` ("NAME=VALUE", or "NAME" to unset) is applied on top of the test's own.
ProcessResult runProcess(const std::vector<std::string>& command,
                         const std::vector<std::string>& environment = {});

}  // namespace vides::test
