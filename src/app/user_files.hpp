// SPDX-License-Identifier: MIT
// What the window keeps from one run to the next: the user's setup and the recently opened files.
//
// Scripts, pictures and tests don't use this: their editor is always the built-in one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/background_writer.hpp"
#include "edit/session.hpp"

namespace vides {

class UserFiles {
 public:
  // The folders may be empty: then nothing is read or kept there.
  UserFiles(BackgroundWriter& writer, std::filesystem::path configFolder,
            std::filesystem::path stateFolder);

  // When the window opens. What is wrong with the setup, which is then as built in; to be said once
  // the flight is there.
  std::optional<Text> load(Session& session);
  // After a display frame: has changes written, a second after the last one. The seconds until it
  // wants to be called again.
  std::optional<double> follow(const Session& session, double now);
  // When the window closes. Returns when all is written.
  void close(const Session& session);

 private:
  void postSetup(const Setup& setup);

  BackgroundWriter& writer_;
  std::string setupFile_, recentFile_;
  bool broken_ = false;  // the user's setup: kept beside the new one
  Setup saved_;          // as it is on the disk, or will be
  Setup seen_;
  double changedAt_ = 0.0;
  std::vector<std::string> recent_;
};

}  // namespace vides
