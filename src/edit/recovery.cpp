// SPDX-License-Identifier: MIT
// Files and locks of unsaved work.
#include "edit/recovery.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>

#include "edit/encoded_path.hpp"
#include "flight/limits.hpp"
#include "io/json_reader.hpp"
#include "io/read_file.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

// The document's path stands in the flight itself, in a member that readers keep and don't
// understand: so the file is written at once or not at all. A path is any bytes: it is encoded.
constexpr std::string_view kPathMember = "x_vides_unsaved_path";

// What the member's JSON text says; empty where it isn't a path.
std::string pathIn(std::string_view json) {
  if (json.size() < 2 || json.front() != '"') return {};
  return decodedPath(json.substr(1, json.size() - 2)).value_or("");
}

// Names are kept as JSON text; by hand they may be written with escapes.
bool isPath(const ExtraMembers::value_type& member) {
  const std::string_view name = member.first;
  return decodeJsonString(name.substr(1, name.size() - 2)) == kPathMember;
}

std::string takePath(Flight& flight) {
  if (!flight.extras.flight) return {};
  ExtraMembers members = *flight.extras.flight;
  const auto found = std::find_if(members.begin(), members.end(), isPath);
  if (found == members.end()) return {};
  std::string path = pathIn(found->second);
  members.erase(found);
  flight.extras.flight =
      members.empty() ? nullptr : std::make_shared<const ExtraMembers>(std::move(members));
  return path;
}

std::int64_t writtenAt(const fs::path& file) {
  struct stat s {};
  return ::stat(file.c_str(), &s) == 0 ? s.st_mtim.tv_sec : 0;
}

}  // namespace

Flight withUnsavedPath(Flight flight, const std::string& path) {
  ExtraMembers members;
  if (flight.extras.flight) members = *flight.extras.flight;
  std::erase_if(members, isPath);  // where the flight was itself opened from such a file
  members.emplace_back(fmt::format("\"{}\"", kPathMember), '"' + encodedPath(path) + '"');
  flight.extras.flight = std::make_shared<const ExtraMembers>(std::move(members));
  return flight;
}

std::optional<UnsavedWork> readUnsavedWork(std::string_view text) {
  auto flight = readVid(text);
  if (!flight) return std::nullopt;
  UnsavedWork work;
  work.flight = std::move(*flight);
  work.path = takePath(work.flight);
  return work;
}

RecoveryFile::RecoveryFile(fs::path folder) : folder_(std::move(folder)) {}

RecoveryFile::~RecoveryFile() {
  if (lock_ < 0) return;
  // Only an empty lock goes with us.
  std::error_code error;
  if (!fs::exists(file_, error)) fs::remove(fs::path(file_).replace_extension(".lock"), error);
  ::close(lock_);
}

// Where the lock was removed between its opening and its locking, somebody else cleared it away.
bool RecoveryFile::lock(const fs::path& lockFile, bool ours) {
  const int flags = O_RDWR | O_CLOEXEC | (ours ? O_CREAT | O_EXCL : 0);
  const int descriptor = ::open(lockFile.c_str(), flags, 0600);
  if (descriptor < 0) return false;
  struct stat s {};
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 || ::fstat(descriptor, &s) != 0 ||
      s.st_nlink == 0) {
    ::close(descriptor);
    return false;
  }
  lock_ = descriptor;
  file_ = fs::path(lockFile).replace_extension(".vid");
  return true;
}

bool RecoveryFile::begin() {
  std::error_code error;
  fs::create_directories(folder_, error);
  const std::string name = fmt::format("{}-{}", std::time(nullptr), ::getpid());
  for (int attempt = 0; attempt < 100; ++attempt) {
    if (lock(folder_ / fmt::format("{}-{}.lock", name, attempt), true)) return true;
  }
  return false;
}

std::optional<Problem> RecoveryFile::write(const Flight& flight, const std::string& path) {
  // Without a lock (the folder can't be written) the file itself tells why.
  if (lock_ < 0 && !begin()) file_ = folder_ / fmt::format("{}.vid", ::getpid());
  return saveVid(withUnsavedPath(flight, path), file_.string());
}

void RecoveryFile::remove() {
  if (file_.empty()) return;
  std::error_code error;
  fs::remove(file_, error);
  fs::remove(fs::path(file_).replace_extension(".lock"), error);
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
  file_.clear();
}

std::optional<UnsavedWork> RecoveryFile::read() const {
  if (file_.empty()) return std::nullopt;
  const std::int64_t time = writtenAt(file_);
  const auto text = readRegularFile(file_.string(), limits::kFileSize);
  auto work = text ? readUnsavedWork(*text) : std::nullopt;
  if (work) work->time = time;
  return work;
}

std::vector<std::unique_ptr<RecoveryFile>> RecoveryFile::abandoned(const fs::path& folder) {
  std::vector<std::unique_ptr<RecoveryFile>> found;
  std::error_code error;
  for (fs::directory_iterator each(folder, error); !error && each != fs::directory_iterator();
       each.increment(error)) {
    if (each->path().extension() != ".lock") continue;
    auto file = std::make_unique<RecoveryFile>(folder);
    if (!file->lock(each->path(), false)) continue;
    std::error_code unknown;
    if (fs::exists(file->file_, unknown)) found.push_back(std::move(file));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::make_pair(writtenAt(a->file_), a->file_) >
           std::make_pair(writtenAt(b->file_), b->file_);
  });
  return found;
}

}  // namespace vides
