// SPDX-License-Identifier: MIT
// What other programs on an X screen do to a window: ask it to close, drop files on it.
#pragma once

#include <functional>
#include <string>

#include "render/picture.hpp"

namespace vides::test {

// A connection of its own to the screen that DISPLAY names. Aborts where there is none.
class XPeer {
 public:
  XPeer();
  XPeer(const XPeer&) = delete;
  XPeer& operator=(const XPeer&) = delete;
  ~XPeer();

  // The screen's dots per inch, as a desktop sets them; for windows opened later.
  void setDotsPerInch(int dots);
  // What the screen shows of a window, opaque.
  Picture screenshot(unsigned long window);
  // As a click on the window manager's close button.
  void requestClose(unsigned long window);
  // Drops files at 10, 10, as a file manager does: `uris` a line each ("file:///a%20b").
  // `letWindowWork` is called again and again until the window has fetched them; returns false if
  // that does not happen in 30 s.
  bool drop(unsigned long window, const std::string& uris,
            const std::function<void()>& letWindowWork);

 private:
  struct Connection;
  Connection* connection_;
};

}  // namespace vides::test
