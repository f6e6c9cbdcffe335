// SPDX-License-Identifier: MIT
// Reading folders for the file chooser.
#include "edit/folder.hpp"

#include <fnmatch.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <tuple>
#include <utility>

namespace vides {
namespace {

namespace fs = std::filesystem;

// Letters of ASCII only: names are bytes to us.
std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

// Relative paths in the variable are to be ignored.
fs::path ownFolder(const char* variable, const char* inHome) {
  const char* const chosen = std::getenv(variable);
  if (chosen != nullptr && fs::path(chosen).is_absolute()) return fs::path(chosen) / "vides";
  const fs::path home = homeFolder();
  return home.is_absolute() ? home / inHome / "vides" : fs::path();
}

}  // namespace

bool fitsFilter(std::string_view name, std::string_view filter) {
  constexpr std::string_view kBetween = " \t,;";
  const std::string low = lowered(name);
  bool any = false;
  for (std::size_t from = 0; (from = filter.find_first_not_of(kBetween, from)) != filter.npos;) {
    const std::size_t to = std::min(filter.find_first_of(kBetween, from), filter.size());
    std::string pattern = lowered(filter.substr(from, to - from));
    if (pattern.find_first_of("*?") == std::string::npos) pattern = "*" + pattern + "*";
    // A bracket and a backslash stand for themselves.
    std::string plain;
    for (const char letter : pattern) {
      if (letter == '[' || letter == '\\') plain += '\\';
      plain += letter;
    }
    if (fnmatch(plain.c_str(), low.c_str(), 0) == 0) return true;
    any = true;
    from = to;
  }
  return !any;
}

void sortEntries(std::vector<FolderEntry>& entries, const FolderOrder& order) {
  using By = FolderOrder::By;
  const auto byName = [](const FolderEntry& a, const FolderEntry& b) {
    return std::make_tuple(lowered(a.name), std::string_view(a.name)) <
           std::make_tuple(lowered(b.name), std::string_view(b.name));
  };
  const auto before = [&](const FolderEntry& a, const FolderEntry& b) {
    if (order.by == By::kSize && a.bytes != b.bytes) return a.bytes < b.bytes;
    if (order.by == By::kDate && a.changed != b.changed) return a.changed < b.changed;
    return byName(a, b);
  };
  std::sort(entries.begin(), entries.end(), [&](const FolderEntry& a, const FolderEntry& b) {
    if (a.folder != b.folder) return a.folder;
    if (a.folder && order.by == By::kSize) return byName(a, b);
    return order.descending ? before(b, a) : before(a, b);
  });
}

tl::expected<std::vector<FolderEntry>, std::string> readFolder(const fs::path& folder,
                                                               std::string_view filter,
                                                               const FolderOrder& order) {
  const bool hidden = filter.starts_with('.');
  std::error_code error;
  std::vector<FolderEntry> entries;
  fs::directory_iterator each(folder, error);
  // The next entry can fail as well, on a disk that goes away.
  for (; !error && each != fs::directory_iterator(); each.increment(error)) {
    const std::string name = each->path().filename().string();
    if (name.starts_with('.') && !hidden) continue;
    struct stat found {};
    // A link to nothing is listed all the same.
    const bool known = stat(each->path().c_str(), &found) == 0;
    FolderEntry entry{name, known && S_ISDIR(found.st_mode)};
    if (!entry.folder && !fitsFilter(name, filter)) continue;
    if (known) {
      if (!entry.folder) entry.bytes = static_cast<std::uintmax_t>(found.st_size);
      entry.changed = found.st_mtim.tv_sec;
    }
    entries.push_back(std::move(entry));
  }
  if (error) return tl::unexpected(error.message());
  sortEntries(entries, order);
  return entries;
}

fs::path typedPath(const fs::path& folder, std::string_view typed) {
  if (typed == "~") return homeFolder();
  if (typed.starts_with("~/")) return (homeFolder() / typed.substr(2)).lexically_normal();
  return (folder / typed).lexically_normal();
}

std::string fileName(const std::string& path) { return fs::path(path).filename().string(); }

fs::path configFolder() { return ownFolder("XDG_CONFIG_HOME", ".config"); }
fs::path stateFolder() { return ownFolder("XDG_STATE_HOME", ".local/state"); }

fs::path homeFolder() {
  const char* const home = std::getenv("HOME");
  return home != nullptr ? fs::path(home) : fs::path();
}

}  // namespace vides
