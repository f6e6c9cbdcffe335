// SPDX-License-Identifier: MIT
// When the setup and the recently opened files are read and written.
#include "app/user_files.hpp"

#include "edit/recent_files.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

constexpr double kQuietSeconds = 1.0;

// How the viewport is turned is no change by itself: it is kept when the window closes.
Setup withoutView(Setup setup) {
  const Setup builtIn;
  setup.turn = builtIn.turn;
  setup.tilt = builtIn.tilt;
  setup.size = builtIn.size;
  setup.perspective = builtIn.perspective;
  return setup;
}

}  // namespace

UserFiles::UserFiles(BackgroundWriter& writer, fs::path configFolder, fs::path stateFolder)
    : writer_(writer),
      setupFile_(configFolder.empty() ? "" : (configFolder / "setup.json").string()),
      recentFile_(stateFolder.empty() ? "" : (stateFolder / "recent.json").string()) {}

std::optional<Text> UserFiles::load(Session& session) {
  std::optional<Text> trouble;
  std::error_code error;
  if (!setupFile_.empty() && fs::exists(setupFile_, error)) {
    const ReadSetup setup = readSetupFile(setupFile_);
    broken_ = !setup;
    if (setup) {
      session.setSetup(*setup);
    } else {
      trouble = Text("output.setup-replaced", {setupFile_, setup.error().front()});
    }
  }
  saved_ = seen_ = session.setup();
  if (!recentFile_.empty()) session.setRecentFiles(readRecentFilesFile(recentFile_));
  recent_ = session.recentFiles();
  return trouble;
}

void UserFiles::postSetup(const Setup& setup) {
  saved_ = setup;
  if (setupFile_.empty()) return;
  const bool keepsBroken = std::exchange(broken_, false);
  writer_.post("setup", [setup, keepsBroken, file = setupFile_] {
    std::error_code ignored;
    if (keepsBroken) fs::rename(file, file + ".broken", ignored);
    // Nobody can be told here, and nothing of the user's work is lost.
    static_cast<void>(saveSetup(setup, file));
  });
}

std::optional<double> UserFiles::follow(const Session& session, double now) {
  if (session.recentFiles() != recent_) {
    recent_ = session.recentFiles();
    if (!recentFile_.empty()) {
      writer_.post("recent", [files = recent_, file = recentFile_] {
        static_cast<void>(saveRecentFiles(files, Session::kRecentFiles, file));
      });
    }
  }
  const Setup setup = session.setup();
  if (!(withoutView(setup) == withoutView(seen_))) {
    seen_ = setup;
    changedAt_ = now;
  }
  if (withoutView(setup) == withoutView(saved_)) return std::nullopt;
  const double left = changedAt_ + kQuietSeconds - now;
  if (left > 0.0) return left;
  postSetup(setup);
  return std::nullopt;
}

void UserFiles::close(const Session& session) {
  if (!(session.setup() == saved_)) postSetup(session.setup());
  writer_.finish();
}

}  // namespace vides
