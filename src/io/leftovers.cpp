// SPDX-License-Identifier: MIT
// A saver holds a lock on its temporary file, which the system takes back when it dies.
#include "io/leftovers.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <memory>
#include <string_view>

namespace vides {
namespace {

constexpr std::string_view kBegin = ".vides-";
constexpr std::size_t kDigits = 16;

bool isTemporaryName(std::string_view name) {
  return name.size() == kBegin.size() + kDigits && name.starts_with(kBegin) &&
         name.find_first_not_of("0123456789abcdef", kBegin.size()) == name.npos;
}

// Whether the name still leads to the open file.
bool names(int folder, const char* name, int file) {
  struct stat open {};
  struct stat found {};
  return fstat(file, &open) == 0 && fstatat(folder, name, &found, AT_SYMLINK_NOFOLLOW) == 0 &&
         open.st_dev == found.st_dev && open.st_ino == found.st_ino && S_ISREG(open.st_mode);
}

void clearOne(int folder, const char* name) {
  const int flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  const int file = openat(folder, name, flags);
  if (file < 0) return;
  // Locked by us its saver, were it only beginning, takes another one.
  if (flock(file, LOCK_EX | LOCK_NB) == 0 && names(folder, name, file)) unlinkat(folder, name, 0);
  close(file);
}

// A file system without locks is as good as locked: nobody can clear anything there, either.
bool lock(int file) {
  int result = -1;
  do {
    result = flock(file, LOCK_EX | LOCK_NB);
  } while (result != 0 && errno == EINTR);
  return result == 0 || errno != EWOULDBLOCK;
}

}  // namespace

std::string temporaryName() {
  std::uint64_t number = 0;
  ssize_t got = -1;
  do {
    got = getrandom(&number, sizeof number, 0);
  } while (got < 0 && errno == EINTR);
  if (got != sizeof number) return {};
  return fmt::format("{}{:016x}", kBegin, number);
}

void lockTemporary(int file) { lock(file); }

bool lockNamedTemporary(int file) {
  struct stat status {};
  return lock(file) && (fstat(file, &status) != 0 || status.st_nlink > 0);
}

void clearLeftovers(int folder) noexcept {
  // A descriptor of its own: reading a folder moves its position.
  const int own = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (own < 0) return;
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(fdopendir(own), &closedir);
  if (!entries) {
    close(own);
    return;
  }
  while (const dirent* const entry = readdir(entries.get())) {
    if (isTemporaryName(entry->d_name)) clearOne(folder, entry->d_name);
  }
}

}  // namespace vides
