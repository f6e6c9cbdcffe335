// SPDX-License-Identifier: MIT
// Unsaved work on the disk: a file for each running editor, which the next start offers where the
// editor ended without removing it.
//
// NAME.vid is the flight; NAME.lock beside it is locked for as long as the editor runs, and by the
// system no longer, however the editor ends. The name is unique to a start of the program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flight/flight.hpp"
#include "flight/problem.hpp"

namespace vides {

// What such a file holds.
struct UnsavedWork {
  Flight flight;
  std::string path;       // of the document; empty where it was never saved
  std::int64_t time = 0;  // of the writing, seconds since 1970
};

// The flight as it is written there: with the path in a member of its own.
Flight withUnsavedPath(Flight flight, const std::string& path);
// From the text of such a file, but for the time: the flight and the path. Nothing where the text
// isn't a `.vid`. A member that doesn't hold a path counts as none: the flight is worth more than
// its place.
std::optional<UnsavedWork> readUnsavedWork(std::string_view text);

class RecoveryFile {
 public:
  // Writes nothing yet. The folder is made when something is written.
  explicit RecoveryFile(std::filesystem::path folder);
  // Unlocks; what is written stays.
  ~RecoveryFile();
  RecoveryFile(const RecoveryFile&) = delete;
  RecoveryFile& operator=(const RecoveryFile&) = delete;

  // Replaces what was written before.
  std::optional<Problem> write(const Flight& flight, const std::string& path);
  // Nothing is left.
  void remove();
  // Nothing where it isn't there or can't be read.
  std::optional<UnsavedWork> read() const;
  // Where it is, once something is written.
  const std::filesystem::path& file() const { return file_; }

  // The files of editors that are gone, the newest first; locked from now on, so that no other
  // editor offers them too. Locks without a file are removed.
  static std::vector<std::unique_ptr<RecoveryFile>> abandoned(const std::filesystem::path& folder);

 private:
  bool lock(const std::filesystem::path& lockFile, bool ours);
  bool begin();

  std::filesystem::path folder_, file_;
  int lock_ = -1;  // descriptor
};

}  // namespace vides
