// SPDX-License-Identifier: MIT
// The editor in its window: sleeps until something happens, and then draws a display frame.
#pragma once

#include <exception>
#include <string>

#include "app/editor.hpp"
#include "app/recovery_keeper.hpp"
#include "app/user_files.hpp"
#include "host/host.hpp"

namespace vides {

// An exception on the way loses nothing: unsaved work is written at once, the user is told in the
// window and on standard error, and the editor goes on; unless it happens again and again. All
// functions belong to the host's thread.
class WindowLoop {
 public:
  // Display frames that fail one after the other before it gives up.
  static constexpr int kMostFailures = 3;

  enum class State { kGoesOn, kQuit, kGivenUp };

  // They outlive it.
  WindowLoop(Host& host, Editor& editor, UserFiles& userFiles, RecoveryKeeper& recovery);
  WindowLoop(const WindowLoop&) = delete;
  WindowLoop& operator=(const WindowLoop&) = delete;

  // Waits for the next display frame, or for the host's wake(), and draws it. kGivenUp: what can be
  // kept is kept, standard error knows why.
  State step();

 private:
  State stepOrThrow();
  State failed(const std::string& why);
  void dress(const FrameOutcome& outcome);

  Host& host_;
  Editor& editor_;
  UserFiles& userFiles_;
  RecoveryKeeper& recovery_;
  double due_ = 0.0;  // when the next display frame is wanted; the first at once
  double last_ = -1.0;
  int failures_ = 0;
  // What the window shows besides the picture, told to it only where it changes.
  std::string title_;
  CursorShape cursor_ = CursorShape::kArrow;
};

}  // namespace vides
