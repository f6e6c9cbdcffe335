// SPDX-License-Identifier: MIT
// Keeps the window's unsaved work on the disk, and offers what an editor before it has left.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/background_writer.hpp"
#include "edit/recovery.hpp"
#include "edit/session.hpp"

namespace vides {

class RecoveryKeeper {
 public:
  // In an empty folder nothing is kept.
  RecoveryKeeper(BackgroundWriter& writer, std::filesystem::path folder);

  // When the window opens: asks about the newest work that was left, then about the next, until
  // some is taken.
  void offer(Session& session);
  // After a display frame: takes answers, and has an edit written two seconds after it. The
  // seconds until it wants to be called again.
  std::optional<double> follow(Session& session, double now);
  // Has what is unsaved on the disk before it returns. Whether there is anything.
  bool keepNow(const Session& session);
  // When the window closes as it should: nothing is left.
  void close();

 private:
  void askNext(Session& session);
  void write(const Session& session);
  void takeAnswer(Session& session);

  BackgroundWriter& writer_;
  std::filesystem::path folder_;
  std::shared_ptr<RecoveryFile> own_;  // used by the writer's jobs only, once one is posted
  std::vector<std::unique_ptr<RecoveryFile>> left_;  // asked about: the first
  bool written_ = false;                             // there is (or will be) something in own_
  std::optional<Flight> kept_;                       // as written
  std::string keptPath_;
  std::optional<double> dueAt_;
};

}  // namespace vides
