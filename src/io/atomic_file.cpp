// SPDX-License-Identifier: MIT
// Temporary file, flush, rename, flush of the folder.
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "io/leftovers.hpp"
#include "io/temporary_files.hpp"

namespace vides {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 16;
constexpr int kMostLinks = 40;  // as the kernel
constexpr int kMostNames = 100;
constexpr const char* kAccessList = "system.posix_acl_access";

// Repeats a call that a signal interrupted.
template <class Call>
auto retry(Call call) {
  while (true) {
    const auto result = call();
    if (result >= 0 || errno != EINTR) return result;
  }
}

// The folder (with its slash, or empty for the current one) and the name in it.
std::pair<std::string, std::string> split(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == path.npos) return {"", path};
  return {path.substr(0, slash + 1), path.substr(slash + 1)};
}

std::string folderOf(const std::string& path) {
  const std::string folder = split(path).first;
  return folder.empty() ? "." : folder;
}

// Whether the path names an open file of a process. /dev/stdout leads to one; the file behind it is
// where somebody else is writing, too, and must not be replaced.
bool namesOpenFile(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(realpath(folderOf(path).c_str(), nullptr),
                                                         &std::free);
  return real && std::string_view(real.get()).starts_with("/proc/");
}

// The number of an open file of this process, -1 if it is none.
int openFileNumber(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(realpath(folderOf(path).c_str(), nullptr),
                                                         &std::free);
  const std::string own = fmt::format("/proc/{}/fd", getpid());
  if (!real || own != real.get()) return -1;
  const std::string name = split(path).second;
  if (name.empty() || name.size() > 9 || name.find_first_not_of("0123456789") != name.npos) {
    return -1;
  }
  return std::stoi(name);
}

// Where a path leads through symbolic links, also where the last one's target doesn't exist.
// Stops at the open files of processes. Empty with errno set if it leads nowhere.
std::string followLinks(std::string path) {
  for (int i = 0; i < kMostLinks; ++i) {
    struct stat status {};
    if (namesOpenFile(path) || lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) {
      return path;
    }
    char link[PATH_MAX];
    const ssize_t length = readlink(path.c_str(), link, sizeof link);
    if (length < 0) return {};
    const std::string next(link, static_cast<std::size_t>(length));
    path = next.starts_with('/') ? next : split(path).first + next;
  }
  errno = ELOOP;
  return {};
}

// How an open file is reached by a name, which it may not have.
std::string openFilePath(int file) { return fmt::format("/proc/self/fd/{}", file); }

}  // namespace

std::string FileError::reason() const {
  const char* text = strerrordesc_np(number);  // never translated
  return text != nullptr ? text : fmt::format("error {}", number);
}

std::string missingFolder(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::path(file).parent_path();
  fs::path at;
  for (const fs::path& part : folder) {
    at /= part;
    if (!fs::exists(at, error)) return at.string();
  }
  return {};
}

Problem problemOf(const FileError& error) {
  Problem problem;
  problem.code = ProblemCode::kUnwritable;
  problem.found = error.reason();
  // Of a long path it is one folder that is wrong.
  if (error.number == ENOENT) {
    if (const std::string folder = missingFolder(error.path); !folder.empty()) {
      problem.found += ": " + folder;
    }
  }
  return problem;
}

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  buffer_.reserve(kBufferSize);
  open();
}

AtomicFile::~AtomicFile() { discard(); }

bool AtomicFile::fail(int number) {
  if (!error_) error_ = FileError{number, path_};
  return false;
}

void AtomicFile::open() {
  if (path_.find('\0') != path_.npos) {
    fail(EINVAL);  // what the system sees of such a name is another one
    return;
  }
  const std::string path = followLinks(path_);
  if (path.empty()) {
    fail(path_.empty() ? ENOENT : errno);
    return;
  }
  struct stat status {};
  const bool there = stat(path.c_str(), &status) == 0;
  if (!there && errno != ENOENT) {
    fail(errno);
  } else if (there && S_ISDIR(status.st_mode)) {
    fail(EISDIR);
  } else if (there && (!S_ISREG(status.st_mode) || namesOpenFile(path))) {
    openDirectly(path);
  } else if (there && faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
    fail(errno);  // a write-protected file isn't replaced behind its owner's back
  } else {
    // Nobody may look into the file before it has its permissions.
    replaces_ = there;
    openTemporary(path, there ? 0600 : 0666);
    if (there && !error_) keepPermissions(path);
  }
}

void AtomicFile::openDirectly(const std::string& path) {
  direct_ = true;
  const int number = openFileNumber(path);
  // A copy of the open file shares its position; opened anew, it would be written from its start.
  file_ = number >= 0
              ? fcntl(number, F_DUPFD_CLOEXEC, 0)
              : retry([&] { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY); });
  if (file_ < 0) fail(errno);
}

void AtomicFile::openTemporary(const std::string& path, unsigned mode) {
  target_ = split(path).second;
  const std::string folder = folderOf(path);
  folder_ = retry([&] { return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
  if (folder_ < 0 && errno == EACCES) {
    // A folder that may be written but not listed: then its own flush is left out.
    folder_ = retry([&] { return ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC); });
  }
  if (folder_ < 0) {
    fail(errno);
    return;
  }
  if (!openUnnamed(mode)) openNamed(mode);
}

// Without a name nothing is left of it, however the program ends. Only where it can get one later.
bool AtomicFile::openUnnamed(unsigned mode) {
  file_ = retry([&] { return openat(folder_, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, mode); });
  if (file_ < 0) return false;
  struct stat status {};
  if (stat(openFilePath(file_).c_str(), &status) == 0) {
    lockTemporary(file_);
    return unnamed_ = true;
  }
  ::close(std::exchange(file_, -1));
  return false;
}

void AtomicFile::openNamed(unsigned mode) {
  for (int i = 0; i < kMostNames; ++i) {
    if (!nameTemporary()) return;
    file_ = retry([&] {
      return openat(folder_, temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    });
    const int error = errno;
    if (file_ >= 0 && lockNamedTemporary(file_)) return;
    if (file_ >= 0) ::close(std::exchange(file_, -1));
    if (file_ < 0 && error != EEXIST) {
      forgetTemporary();
      fail(error);
      return;
    }
    forgetTemporary();
  }
  fail(EEXIST);
}

// Remembered before it exists: a signal in between finds nothing to remove.
bool AtomicFile::nameTemporary() {
  temporary_ = temporaryName();
  if (temporary_.empty()) return fail(errno);
  slot_ = rememberTemporaryFile(folder_, temporary_);
  return true;
}

void AtomicFile::forgetTemporary() {
  temporary_.clear();
  forgetTemporaryFile(std::exchange(slot_, -1));
}

// Gives the temporary file the owner, the access list and the mode of the file at `path`. Where the
// first two can't be had, its group gets no more than what others have.
void AtomicFile::keepPermissions(const std::string& path) {
  struct stat old {};
  struct stat mine {};
  if (stat(path.c_str(), &old) != 0 || fstat(file_, &mine) != 0) {
    fail(errno);
    return;
  }
  bool kept = (old.st_uid == mine.st_uid && old.st_gid == mine.st_gid) ||
              fchown(file_, old.st_uid, old.st_gid) == 0 ||
              fchown(file_, static_cast<uid_t>(-1), old.st_gid) == 0;
  char list[4096];
  const ssize_t size = getxattr(path.c_str(), kAccessList, list, sizeof list);
  if (size > 0 && fsetxattr(file_, kAccessList, list, static_cast<std::size_t>(size), 0) != 0) {
    kept = false;
  }
  mode_t mode = old.st_mode & 07777;
  if (!kept) mode = (mode & 0707) | (mode & 07) << 3;
  if (fchmod(file_, mode) != 0) fail(errno);
}

bool AtomicFile::write(std::string_view text) {
  if (error_ || file_ < 0) return false;
  if (buffer_.size() + text.size() <= kBufferSize) {
    buffer_ += text;
    return true;
  }
  return flush() && writeOut(text);
}

bool AtomicFile::flush() {
  const bool good = writeOut(buffer_);
  buffer_.clear();
  return good;
}

bool AtomicFile::writeOut(std::string_view text) {
  while (!error_ && !text.empty()) {
    const ssize_t written = retry([&] { return ::write(file_, text.data(), text.size()); });
    if (written < 0) return fail(errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return !error_;
}

bool AtomicFile::closeFile() {
  // Whatever it returns, the descriptor is gone; after EINTR the data is where fsync put it.
  if (::close(std::exchange(file_, -1)) != 0 && errno != EINTR) return fail(errno);
  return true;
}

// Gives a file without a name the target's, if that is free, else a temporary one.
bool AtomicFile::link() {
  const std::string file = openFilePath(file_);
  const auto linkAs = [&](const std::string& name) {
    return linkat(AT_FDCWD, file.c_str(), folder_, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (!replaces_ && linkAs(target_)) return true;
  for (int i = 0; i < kMostNames; ++i) {
    if (!nameTemporary()) return false;
    if (linkAs(temporary_)) return true;
    const int error = errno;
    forgetTemporary();
    if (error != EEXIST) return fail(error);
  }
  return fail(EEXIST);
}

tl::expected<void, FileError> AtomicFile::commit() {
  if (!error_) flush();
  if (!error_ && !direct_ && retry([&] { return fsync(file_); }) != 0) fail(errno);
  if (!error_ && unnamed_) link();
  // Still open, and so still locked, until it has its name.
  if (!error_ && !temporary_.empty()) {
    if (renameat(folder_, temporary_.c_str(), folder_, target_.c_str()) != 0) {
      fail(errno);
    } else {
      forgetTemporary();
    }
  }
  if (!error_) closeFile();
  if (!error_ && !direct_) {
    clearLeftovers(folder_);
    // EBADF: the folder may not be listed. EINVAL: the file system has no such thing.
    if (retry([&] { return fsync(folder_); }) != 0 && errno != EBADF && errno != EINVAL) {
      fail(errno);
    }
  }
  discard();
  if (error_) return tl::unexpected(*error_);
  return {};
}

void AtomicFile::discard() {
  buffer_.clear();
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  if (!temporary_.empty()) unlinkat(folder_, temporary_.c_str(), 0);
  forgetTemporary();
  if (folder_ >= 0) ::close(std::exchange(folder_, -1));
}

}  // namespace vides
