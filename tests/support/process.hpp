// SPDX-License-Identifier: MIT
// Runs another program from a test: OpenGL drivers read their environment once a process.
#pragma once

#include <sys/types.h>

#include <optional>
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

// A program that runs beside the test, with the test's own outputs; ended with it.
class RunningProcess {
 public:
  explicit RunningProcess(const std::vector<std::string>& command,
                          const std::vector<std::string>& environment = {});
  RunningProcess(const RunningProcess&) = delete;
  RunningProcess& operator=(const RunningProcess&) = delete;
  ~RunningProcess();

  pid_t id() const { return id_; }
  // Its status as in ProcessResult, once it has ended. Does not wait.
  std::optional<int> ended();

 private:
  pid_t id_;
  std::optional<int> status_;
};

}  // namespace vides::test
