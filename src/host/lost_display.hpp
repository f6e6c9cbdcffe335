// SPDX-License-Identifier: MIT
// The end of the X server or the Wayland compositor under a window of GLFW's, which GLFW doesn't
// tell of.
//
// Debian has GLFW 3.3 twice, for X11 (libglfw3) and for Wayland (libglfw3-wayland), one in the
// other's place: the same program can meet either. Xlib ends the process from within whatever call
// notices, unless it is told not to. Under Wayland every call goes on doing nothing; GLFW takes it
// for a wish to close the window, again and again, which can't be answered any more.
#pragma once

#include <functional>
#include <thread>

namespace vides {

// From construction to destruction, with GLFW started on this thread. When the connection breaks,
// `last` is called (of every watch of this thread, the oldest first), if it is this thread that
// notices, and the process ends with status 1. With an Xlib before 1.7 it does nothing.
class LostDisplay {
 public:
  explicit LostDisplay(std::function<void()> last);
  LostDisplay(const LostDisplay&) = delete;
  LostDisplay& operator=(const LostDisplay&) = delete;
  ~LostDisplay();

  // To be called after GLFW has handled events: under Wayland the connection has to be asked.
  void check();

 private:
  [[noreturn]] static void end();
  void say();

  std::function<void()> last_;
  std::thread::id thread_ = std::this_thread::get_id();
  void* display_ = nullptr;  // Xlib's
  void* wayland_ = nullptr;  // libwayland-client's
  int (*waylandError_)(void*) = nullptr;
  int (*waylandFlush_)(void*) = nullptr;
};

}  // namespace vides
