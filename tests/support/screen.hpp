// SPDX-License-Identifier: MIT
// A screen in memory (Xvfb) for tests that open a real window.
#pragma once

#include <sys/types.h>

namespace vides::test {

// Runs from construction to destruction; DISPLAY names it meanwhile. 1280 × 800 pixels, 24 bits, no
// window manager: a window stands at 0, 0. Aborts where Xvfb cannot be started.
class Screen {
 public:
  Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen();

 private:
  pid_t server_ = -1;
};

}  // namespace vides::test
