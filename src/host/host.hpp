// SPDX-License-Identifier: MIT
// The seam between the editor and what it runs in: a window, or a context without one.
//
// All sizes and places are in pixels of the picture. A host, its OpenGL context and everything made
// with its table belong to one thread (a window's to the main thread); only wake() may be called
// from others. Several hosts may exist in a thread: beginDrawing() makes its own context current.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "input/input_event.hpp"
#include "render/gl_functions.hpp"

namespace vides {

// What a window system has of its own. For the rest (move, forbidden) the editor hides the cursor
// and draws its own.
enum class CursorShape { kArrow, kText, kCross, kHand, kHorizontal, kVertical, kHidden };

class Host {
 public:
  Host() = default;
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
  virtual ~Host() = default;

  // OpenGL for this host's context, filled when it was opened.
  virtual const Gl& gl() const = 0;
  // Makes the context current on this thread, unless it is: also after other hosts, and other code
  // that uses the same library.
  virtual void makeCurrent() = 0;

  virtual PixelSize size() const = 0;
  // How much larger than at 96 dots an inch widgets are drawn; > 0.
  virtual double contentScale() const = 0;

  // Makes the context current, whatever other code has made current meanwhile by whatever library,
  // and binds what to draw into, the viewport being all of it. False
  // where there is nothing to draw into (0 × 0): then neither draw nor swap.
  virtual bool beginDrawing() = 0;
  // The framebuffer that beginDrawing() bound, to return to after drawing elsewhere.
  virtual GLuint framebuffer() const = 0;
  // Shows what was drawn since beginDrawing(). May wait for the screen.
  virtual void swap() = 0;

  // What happened since the last call, oldest first. Does not wait.
  virtual std::vector<InputEvent> takeEvents() = 0;
  // Returns when there are events to take, after wake(), or when the time is over; at once if there
  // are some already. May return early.
  virtual void waitForEvents(std::chrono::duration<double> atMost) = 0;
  // Ends a wait, the current one or the next. From any thread.
  virtual void wake() = 0;

  // Seconds since the host was opened; never runs backwards.
  virtual double time() const = 0;

  // UTF-8; empty where the clipboard holds no text.
  virtual std::string clipboard() const = 0;
  virtual void setClipboard(const std::string& text) = 0;
  virtual void setCursor(CursorShape shape) = 0;
  virtual void setTitle(const std::string& title) = 0;
  virtual bool fullScreen() const = 0;
  virtual void setFullScreen(bool on) = 0;

  // What is still to be done when the display is lost (its server has ended). It is called in the
  // middle of some function of this host, on the thread that uses it, and must use neither the host
  // nor OpenGL any more. When it returns the process ends with status 1: no library that draws
  // there survives. An empty function takes it back: before what it uses goes. What is drawn into
  // memory has no display to lose.
  // NOLINTNEXTLINE(performance-unnecessary-value-param): those that can lose one keep it
  virtual void onLost(std::function<void()> /*last*/) {}
};

}  // namespace vides
