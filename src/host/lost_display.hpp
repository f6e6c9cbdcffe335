// SPDX-License-Identifier: MIT
// The end of the X server under a window of GLFW's, which GLFW doesn't tell of.
#pragma once

#include <functional>
#include <thread>

namespace vides {

// From construction to destruction, with GLFW started on this thread. When the connection breaks,
// `last` is called, if it is this thread that notices, and the process ends with status 1. Without
// X (a GLFW for Wayland), or with an Xlib before 1.7, it does nothing.
class LostDisplay {
 public:
  explicit LostDisplay(std::function<void()> last);
  LostDisplay(const LostDisplay&) = delete;
  LostDisplay& operator=(const LostDisplay&) = delete;
  ~LostDisplay();

 private:
  [[noreturn]] void end();

  std::function<void()> last_;
  std::thread::id thread_ = std::this_thread::get_id();
  void* display_ = nullptr;  // Xlib's
};

}  // namespace vides
