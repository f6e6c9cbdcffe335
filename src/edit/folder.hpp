// SPDX-License-Identifier: MIT
// What is in a folder, as the file chooser lists it.
#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace vides {

struct FolderEntry {
  std::string name;
  bool folder = false;
  std::uintmax_t bytes = 0;                 // of a file
  std::optional<std::time_t> changed = {};  // when; absent where the system doesn't say
  bool operator==(const FolderEntry&) const = default;
};

// Folders stay before files, whichever way they are sorted; what is equal goes by name.
struct FolderOrder {
  enum class By { kName, kSize, kDate };
  By by = By::kName;
  bool descending = false;
  bool operator==(const FolderOrder&) const = default;
};
// By name without regard to case. Folders have no size: sorted by it, they go by name.
void sortEntries(std::vector<FolderEntry>& entries, const FolderOrder& order);

// Whether a file's name fits a filter: patterns with * and ?, blanks, commas or semicolons between
// them, one of which has to fit, in any case of letters (of ASCII). A word without * and ? fits
// where it occurs; no pattern at all fits every name.
bool fitsFilter(std::string_view name, std::string_view filter);

// Folders first, then the files that fit the filter, in this order. What begins with a dot is left
// out, unless the filter begins with one. Error: the system's words.
tl::expected<std::vector<FolderEntry>, std::string> readFolder(const std::filesystem::path& folder,
                                                               std::string_view filter,
                                                               const FolderOrder& order = {});

// A typed name in a folder: absolute paths and "~/" stand for themselves; without "." and "..".
std::filesystem::path typedPath(const std::filesystem::path& folder, std::string_view typed);

// A path's last part, as files are told of.
std::string fileName(const std::string& path);

// The user's own folder; empty where the system names none.
std::filesystem::path homeFolder();

// Where vides keeps its setup ($XDG_CONFIG_HOME/vides) and what it remembers from run to run
// ($XDG_STATE_HOME/vides), as the XDG base directory specification has it; they need not exist.
// Empty where neither the variable nor the home names an absolute folder.
std::filesystem::path configFolder();
std::filesystem::path stateFolder();

}  // namespace vides
