// SPDX-License-Identifier: MIT
// The document's file on the disk.
#include "edit/disk_file.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <string_view>

#include "edit/file_obstacle.hpp"
#include "flight/limits.hpp"
#include "io/read_file.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

// FNV-1a: tells another content from ours; nobody makes collisions here.
constexpr std::uint64_t kHashStart = 14695981039346656037u;
std::uint64_t hashed(std::uint64_t hash, std::string_view text) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

}  // namespace

fs::path resolvedPath(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return path.lexically_normal();
  fs::path whole = fs::weakly_canonical(absolute, error);
  return error ? absolute.lexically_normal() : whole;
}

std::optional<DiskFile::Stamp> DiskFile::stampOf(const std::string& path) {
  struct stat s {};
  if (::stat(path.c_str(), &s) != 0) return std::nullopt;
  return Stamp{s.st_mtim.tv_sec, s.st_mtim.tv_nsec, s.st_size, s.st_ino, s.st_dev};
}

tl::expected<Flight, std::vector<Problem>> DiskFile::open(const std::string& path) {
  // Before it is read: a change that comes between is noticed later.
  const std::optional<Stamp> stamp = stampOf(path);
  auto text = readRegularFile(path, limits::kFileSize);
  if (!text) return tl::unexpected(std::vector<Problem>{text.error()});
  auto flight = readVid(*text);
  if (!flight) return tl::unexpected(flight.error());
  path_ = resolvedPath(path).string();
  stamp_ = stamp;
  hash_ = hashed(kHashStart, *text);
  return std::move(*flight);
}

std::optional<Problem> DiskFile::save(const Flight& flight, const std::string& path) {
  if (auto why = obstacleToWriting(path)) return why;
  std::uint64_t hash = kHashStart;
  const auto seen = [&](std::string_view text) { hash = hashed(hash, text); };
  if (auto problem = saveVid(flight, path, seen)) return problem;
  path_ = resolvedPath(path).string();
  stamp_ = stampOf(path);
  hash_ = hash;
  return std::nullopt;
}

DiskState DiskFile::compare() {
  if (path_.empty()) return DiskState::kSame;
  const std::optional<Stamp> stamp = stampOf(path_);
  if (!stamp) return DiskState::kDeleted;
  if (stamp == stamp_) return DiskState::kSame;
  const auto text = readRegularFile(path_, limits::kFileSize);
  if (!text || hashed(kHashStart, *text) != hash_) return DiskState::kChanged;
  stamp_ = stamp;
  return DiskState::kSame;
}

std::string scenePath(const std::string& flightPath, const std::string& file) {
  const fs::path path(file);
  if (path.is_absolute() || flightPath.empty()) return path.lexically_normal().string();
  return (fs::path(flightPath).parent_path() / path).lexically_normal().string();
}

void moveScenePaths(Flight& flight, const std::string& from, const std::string& to) {
  const fs::path folder = to.empty() ? fs::path() : resolvedPath(fs::path(to)).parent_path();
  for (SceneFile& scene : flight.scene) {
    const fs::path file = resolvedPath(scenePath(from, scene.file));
    if (folder.empty()) {
      scene.file = file.generic_string();
      continue;
    }
    const fs::path relative = file.lexically_relative(folder);
    scene.file = relative.empty() ? file.generic_string() : relative.generic_string();
  }
}

}  // namespace vides
