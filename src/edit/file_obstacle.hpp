// SPDX-License-Identifier: MIT
// Why an editor doesn't even begin to write a file.
#pragma once

#include <optional>
#include <string>

#include "flight/problem.hpp"

namespace vides {

// A pipe or a socket would keep the window waiting for somebody who reads. Nothing of other files.
std::optional<Problem> obstacleToWriting(const std::string& path);

}  // namespace vides
