// SPDX-License-Identifier: MIT
// The `.vid` file of a document: reading, saving, and whether another program touched it since.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "flight/flight.hpp"
#include "flight/problem.hpp"

namespace vides {

// Where a path leads, as far as it exists: whole, without symbolic links, "." and "..". A relative
// one stays so where the working directory is gone. Refuses nothing, not even an empty path.
std::filesystem::path resolvedPath(const std::filesystem::path& path);

enum class DiskState { kSame, kChanged, kDeleted };

class DiskFile {
 public:
  DiskFile() = default;  // of a document that was never saved
  const std::string& path() const { return path_; }

  // Reads a flight; the document's file is this one from then on where it succeeds.
  tl::expected<Flight, std::vector<Problem>> open(const std::string& path);
  // Reads it again.
  tl::expected<Flight, std::vector<Problem>> reopen() { return open(path_); }
  // Saves whole or not at all. The document's file is this one from then on where it succeeds.
  std::optional<Problem> save(const Flight& flight, const std::string& path);

  // The file compared with what was last read or written here: by its size and times, and by its
  // content where those differ. kSame without a path.
  DiskState compare();

 private:
  struct Stamp {
    std::int64_t seconds = 0, nanoseconds = 0, size = 0;
    std::uint64_t inode = 0, device = 0;
    bool operator==(const Stamp&) const = default;
  };
  static std::optional<Stamp> stampOf(const std::string& path);

  std::string path_;
  std::optional<Stamp> stamp_;
  std::uint64_t hash_ = 0;  // of the content
};

// The paths of the scene files of a flight whose `.vid` moves from one file to another: relative to
// the new folder, absolute where `to` is empty. An empty `from` is a flight that was never saved.
void moveScenePaths(Flight& flight, const std::string& from, const std::string& to);
// Where a scene file of a flight lies.
std::string scenePath(const std::string& flightPath, const std::string& file);

}  // namespace vides
