// SPDX-License-Identifier: MIT
// Runs another program from a test.
#include "support/process.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>

namespace vides::test {
namespace {

std::string readAll(int descriptor) {
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t count = 0; (count = read(descriptor, part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  return text;
}

[[noreturn]] void become(const std::vector<std::string>& command,
                         const std::vector<std::string>& environment) {
  for (const std::string& entry : environment) {
    const std::size_t equals = entry.find('=');
    if (equals == std::string::npos) {
      unsetenv(entry.c_str());
    } else {
      setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
    }
  }
  std::vector<char*> arguments;
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  std::perror(arguments[0]);
  _exit(127);
}

int statusOf(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ProcessResult runProcess(const std::vector<std::string>& command,
                         const std::vector<std::string>& environment) {
  ProcessResult result;
  // Errors through a file without a name: two pipes read in turn could block each other.
  std::FILE* const errors = std::tmpfile();
  std::array<int, 2> ends{};
  if (errors == nullptr || pipe(ends.data()) != 0) return result;
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    dup2(fileno(errors), STDERR_FILENO);
    close(ends[0]);
    close(ends[1]);
    become(command, environment);
  }
  close(ends[1]);
  result.output = readAll(ends[0]);
  close(ends[0]);
  int status = 0;
  if (child > 0 && waitpid(child, &status, 0) == child) {
    result.status = statusOf(status);
  }
  std::rewind(errors);
  lseek(fileno(errors), 0, SEEK_SET);
  result.errors = readAll(fileno(errors));
  std::fclose(errors);
  return result;
}

RunningProcess::RunningProcess(const std::vector<std::string>& command,
                               const std::vector<std::string>& environment)
    : id_(fork()) {
  if (id_ < 0) std::abort();
  if (id_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // also when the test crashes
    become(command, environment);
  }
}

RunningProcess::~RunningProcess() {
  if (ended()) return;
  kill(id_, SIGKILL);
  waitpid(id_, nullptr, 0);
}

std::optional<int> RunningProcess::ended() {
  int status = 0;
  if (!status_ && waitpid(id_, &status, WNOHANG) == id_) status_ = statusOf(status);
  return status_;
}

}  // namespace vides::test
