// SPDX-License-Identifier: MIT
// Files that appear whole or not at all.
//
// What is written goes to a temporary file in the target's folder; commit() brings it to the disk
// and puts it in the target's place. Until then the target is untouched, and without commit(), or
// after an error, nothing is left behind. Symbolic links are followed: the file they lead to is
// replaced. A file that is replaced keeps its permissions (and owner, where the system lets us), a
// new one gets those of the umask. What isn't a regular file (/dev/stdout, a pipe, /dev/null) is
// written directly.
//
// The temporary file has no name where the file system can do without (O_TMPFILE): only for the
// moment between its getting one and its renaming over the target does a killed program leave it.
// On other file systems it has one from the start. Signals that can be caught remove it
// (io/temporary_files.hpp); after others the next saver in the folder does (io/leftovers.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "flight/problem.hpp"

namespace vides {

// What the system refused.
struct FileError {
  int number = 0;    // errno
  std::string path;  // as the caller named it
  std::string reason() const;
};
// The system's reason, and the folder that is missing where it is that.
Problem problemOf(const FileError& error);
// The first folder on the way to a file that isn't there; empty where all are.
std::string missingFolder(const std::string& file);

class AtomicFile {
 public:
  // Opens the temporary file. An error is kept, and told by commit().
  explicit AtomicFile(std::string path);
  // Discards what hasn't been committed.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  // Buffered. False after an error: writing more is of no use.
  bool write(std::string_view text);
  // The first error so far.
  const std::optional<FileError>& error() const { return error_; }
  // Whether the target is written directly, and so not whole or not at all.
  bool direct() const { return direct_; }

  // Call once. After an error the target is as it was; only where the folder couldn't be brought to
  // the disk is it the new file already, which may not outlive a power failure.
  tl::expected<void, FileError> commit();
  void discard();

 private:
  void open();
  void openDirectly(const std::string& path);
  void openTemporary(const std::string& path, unsigned mode);
  bool openUnnamed(unsigned mode);
  void openNamed(unsigned mode);
  bool nameTemporary();
  void forgetTemporary();
  bool link();
  void keepPermissions(const std::string& path);
  bool fail(int number);
  bool flush();
  bool writeOut(std::string_view text);
  bool closeFile();

  std::string path_;
  std::string target_;     // name in the folder
  std::string temporary_;  // name in the folder; empty if there is none
  bool direct_ = false;
  bool unnamed_ = false;   // the temporary file, until it is linked
  bool replaces_ = false;  // there was a file when it was opened
  int folder_ = -1;
  int file_ = -1;
  int slot_ = -1;  // in the list of temporary files
  std::string buffer_;
  std::optional<FileError> error_;
};

}  // namespace vides
