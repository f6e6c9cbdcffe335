// SPDX-License-Identifier: MIT
// The list of recently opened flights, kept from one run to the next.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flight/problem.hpp"

namespace vides {

// Whole paths, the newest first. Nothing where the text is no such list: it isn't worth a message.
std::vector<std::string> readRecentFiles(std::string_view text);
std::vector<std::string> readRecentFilesFile(const std::string& path);
std::string writeRecentFiles(const std::vector<std::string>& files);

// Puts these before what the file holds by now (another editor may have written it), at most
// `most`; folders on the way are made.
std::optional<Problem> saveRecentFiles(std::vector<std::string> files, std::size_t most,
                                       const std::string& path);

}  // namespace vides
