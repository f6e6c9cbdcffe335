// SPDX-License-Identifier: MIT
// Writing to a descriptor: short writes, interruptions, closed pipes.
#include "app/output.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "app/messages.hpp"
#include "io/problem_text.hpp"

namespace vides {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

// 0, or errno.
int writeAll(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

void endAsClosedPipesDo() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
}

}  // namespace

Output::Output(const std::string& name) : name_(name) {
  if (name != "-") file_ = std::make_unique<AtomicFile>(name);
}

bool Output::write(std::string_view text) {
  if (file_) return file_->write(text);
  buffer_ += text;
  return buffer_.size() < kBufferBytes ? error_ == 0 : flush();
}

bool Output::flush() {
  if (error_ != 0) return false;
  error_ = writeAll(STDOUT_FILENO, buffer_);
  if (error_ == EPIPE) endAsClosedPipesDo();
  buffer_.clear();
  return error_ == 0;
}

bool Output::finish() {
  if (file_) {
    const auto saved = file_->commit();
    if (!saved && saved.error().number == EPIPE) endAsClosedPipesDo();
    if (!saved) tell(problemLine(name_, problemOf(saved.error())));
    return saved.has_value();
  }
  if (!flush()) {
    tell(problemLine("standard output", problemOf(FileError{error_, "standard output"})));
    return false;
  }
  return true;
}

bool sameFile(const std::string& a, const std::string& b) {
  struct stat first, second;
  return stat(a.c_str(), &first) == 0 && stat(b.c_str(), &second) == 0 &&
         first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

}  // namespace vides
