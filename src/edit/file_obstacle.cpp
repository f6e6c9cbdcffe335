// SPDX-License-Identifier: MIT
// Why an editor doesn't even begin to write a file.
#include "edit/file_obstacle.hpp"

#include <sys/stat.h>

namespace vides {

std::optional<Problem> obstacleToWriting(const std::string& path) {
  struct stat s {};
  if (::stat(path.c_str(), &s) != 0 || !(S_ISFIFO(s.st_mode) || S_ISSOCK(s.st_mode))) {
    return std::nullopt;
  }
  Problem problem;
  problem.code = ProblemCode::kUnwritable;
  problem.found = "Not a regular file";
  return problem;
}

}  // namespace vides
