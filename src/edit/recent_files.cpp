// SPDX-License-Identifier: MIT
// The file of recently opened flights: {"format": "vides-recent", "version": 1, "files": […]}.
//
// A path that isn't UTF-8 is encoded, its first slash, too ("%2Fhome/…"): so it is told from all
// others, which are whole paths and begin with one.
#include "edit/recent_files.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "edit/encoded_path.hpp"
#include "flight/utf8.hpp"
#include "io/atomic_file.hpp"
#include "io/read_file.hpp"
#include "io/vid_values.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;
constexpr CountRange kAny{0, 1000};
constexpr std::string_view kSlash = "%2F";

Expectation expectList() { return expectKind(Expected::kArray); }

}  // namespace

std::vector<std::string> readRecentFiles(std::string_view text) {
  VidValues v(text);
  std::vector<std::string> files;
  bool ours = false;
  v.document([&] {
    v.members([&](const std::string& name) {
      if (name == "format") {
        ours = v.text("vides-recent");
        return true;
      }
      if (name != "files") return false;
      v.array(expectList, kAny, [&](std::size_t) {
        std::string file;
        if (!v.path(file)) return;
        const auto decoded = file.starts_with(kSlash) ? decodedPath(file) : std::nullopt;
        std::string path = decoded.value_or(file);
        if (path.starts_with('/')) files.push_back(std::move(path));
      });
      return true;
    });
  });
  return ours && v.problems().empty() ? files : std::vector<std::string>();
}

std::vector<std::string> readRecentFilesFile(const std::string& path) {
  const auto text = readRegularFile(path, kMostBytes);
  return text ? readRecentFiles(*text) : std::vector<std::string>();
}

std::string writeRecentFiles(const std::vector<std::string>& files) {
  std::string out = "{\n  \"format\": \"vides-recent\",\n  \"version\": 1,\n  \"files\": [";
  bool first = true;
  for (const std::string& file : files) {
    // What isn't whole leads nowhere in the next run.
    if (!file.starts_with('/') || file.find('\0') != file.npos) continue;
    out += std::exchange(first, false) ? "\n    " : ",\n    ";
    appendJsonString(out,
                     codePoints(file) ? file : std::string(kSlash) + encodedPath(file.substr(1)));
  }
  return out += first ? "]\n}\n" : "\n  ]\n}\n";
}

std::optional<Problem> saveRecentFiles(std::vector<std::string> files, std::size_t most,
                                       const std::string& path) {
  for (std::string& other : readRecentFilesFile(path)) {
    if (std::find(files.begin(), files.end(), other) == files.end()) {
      files.push_back(std::move(other));
    }
  }
  if (files.size() > most) files.resize(most);
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
  AtomicFile file(path);
  file.write(writeRecentFiles(files));
  if (const auto done = file.commit(); !done) return problemOf(done.error());
  return std::nullopt;
}

}  // namespace vides
