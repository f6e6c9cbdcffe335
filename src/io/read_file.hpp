// SPDX-License-Identifier: MIT
// Reads a whole file, but never more than is allowed.
#pragma once

#include <cstddef>
#include <string>

#include <tl/expected.hpp>

#include "flight/problem.hpp"

namespace vides {

// kUnreadable with the system's reason, or kTooLarge: where the size is known before, nothing is
// read.
tl::expected<std::string, Problem> readFile(const std::string& path, std::size_t mostBytes);
// The same of what is a file and nothing else: for an editor, which a pipe must not keep waiting
// for its other end, and a device not feed without end.
tl::expected<std::string, Problem> readRegularFile(const std::string& path, std::size_t mostBytes);
// From an open file, from its position on; it stays open.
tl::expected<std::string, Problem> readDescriptor(int descriptor, std::size_t mostBytes);

}  // namespace vides
