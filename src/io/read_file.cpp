// SPDX-License-Identifier: MIT
// Reads files through POSIX calls, so that every error has its reason.
#include "io/read_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace vides {
namespace {

Problem unreadable(int error) {
  Problem problem;
  problem.code = ProblemCode::kUnreadable;
  problem.found = strerrordesc_np(error);
  return problem;
}

Problem tooLarge(std::size_t mostBytes) {
  Problem problem;
  problem.code = ProblemCode::kTooLarge;
  problem.expected.max = static_cast<double>(mostBytes);
  return problem;
}

}  // namespace

tl::expected<std::string, Problem> readDescriptor(int descriptor, std::size_t mostBytes) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return tl::unexpected(unreadable(errno));
  std::size_t expected = std::size_t{1} << 16;
  if (S_ISREG(status.st_mode)) {
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > mostBytes) return tl::unexpected(tooLarge(mostBytes));
    expected = size + 1;  // one more, so that the end is seen without growing
  }
  // A pipe has no size, and a file may grow while it is read: go on to the end or to the limit.
  std::string text;
  std::size_t used = 0;
  while (true) {
    if (used == text.size()) {
      text.resize(std::min(std::max(expected, 2 * used), mostBytes + 1));
    }
    const ssize_t got = ::read(descriptor, text.data() + used, text.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return tl::unexpected(unreadable(errno));
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
    if (used > mostBytes) return tl::unexpected(tooLarge(mostBytes));
  }
  text.resize(used);
  return text;
}

namespace {

int openForReading(const std::string& path, int flags) {
  // What the system sees of such a name is another one.
  if (path.find('\0') != path.npos) {
    errno = EINVAL;
    return -1;
  }
  int descriptor = -1;
  do {
    descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | flags);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

}  // namespace

tl::expected<std::string, Problem> readFile(const std::string& path, std::size_t mostBytes) {
  const int descriptor = openForReading(path, 0);
  if (descriptor < 0) return tl::unexpected(unreadable(errno));
  auto text = readDescriptor(descriptor, mostBytes);
  ::close(descriptor);
  return text;
}

tl::expected<std::string, Problem> readRegularFile(const std::string& path, std::size_t mostBytes) {
  const int descriptor = openForReading(path, O_NONBLOCK);
  if (descriptor < 0) return tl::unexpected(unreadable(errno));
  struct stat status {};
  tl::expected<std::string, Problem> text;
  if (fstat(descriptor, &status) != 0) {
    text = tl::unexpected(unreadable(errno));
  } else if (S_ISDIR(status.st_mode)) {
    text = tl::unexpected(unreadable(EISDIR));
  } else if (!S_ISREG(status.st_mode)) {
    Problem problem = unreadable(0);
    problem.found = "Not a regular file";
    text = tl::unexpected(std::move(problem));
  } else {
    text = readDescriptor(descriptor, mostBytes);
  }
  ::close(descriptor);
  return text;
}

}  // namespace vides
