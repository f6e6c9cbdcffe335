// SPDX-License-Identifier: MIT
// Paths, which are any bytes, inside JSON, which is UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vides {

// What isn't plain ASCII is written as %XX. Needs no escapes within quotes.
std::string encodedPath(const std::string& path);
// Nothing where encodedPath() can't have written it.
std::optional<std::string> decodedPath(std::string_view text);

}  // namespace vides
