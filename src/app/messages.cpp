// SPDX-License-Identifier: MIT
// One write a message, so that those of programs side by side don't mix.
#include "app/messages.hpp"

#include <unistd.h>

#include <string>

#include "flight/printable.hpp"

namespace vides {
namespace {

void put(std::string_view message) {
  const std::string line = printable(message) + '\n';
  // Where standard error can't be written, there is nobody left to tell.
  [[maybe_unused]] const auto ignored = write(STDERR_FILENO, line.data(), line.size());
}

}  // namespace

void tell(std::string_view message) { put("vides: " + std::string(message)); }

void tellLine(std::string_view line) { put(line); }

}  // namespace vides
