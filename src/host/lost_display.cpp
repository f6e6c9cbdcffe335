// SPDX-License-Identifier: MIT
// The end of the server under a window of GLFW's.
#include "host/lost_display.hpp"

#include <dlfcn.h>
#include <signal.h>

#include <cerrno>
#include <cstdlib>
#include <exception>
#include <utility>
#include <vector>

namespace vides {
namespace {

// Xlib's and libwayland's, by their names in the libraries that GLFW has loaded: one of them isn't
// there, and the program needs neither headers nor libraries. A display is only handed on.
using DisplayOf = void* (*)();
using WaylandCall = int (*)(void*);
using SetErrorHandler = int (*(*)(int (*)(void*)))(void*);
using SetExitHandler = void (*)(void*, void (*)(void*, void*), void*);

// Those of all windows: GLFW has one connection a process, and so is this list.
std::vector<LostDisplay*>& watches() {
  static std::vector<LostDisplay*> all;
  return all;
}

template <typename Function>
Function loaded(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

LostDisplay::LostDisplay(std::function<void()> last) : last_(std::move(last)) {
  watches().push_back(this);
  if (const auto waylandOf = loaded<DisplayOf>("glfwGetWaylandDisplay")) {
    wayland_ = waylandOf();
    waylandError_ = loaded<WaylandCall>("wl_display_get_error");
    waylandFlush_ = loaded<WaylandCall>("wl_display_flush");
  }
  const auto displayOf = loaded<DisplayOf>("glfwGetX11Display");
  const auto setError = loaded<SetErrorHandler>("XSetIOErrorHandler");
  const auto setExit = loaded<SetExitHandler>("XSetIOErrorExitHandler");
  if (displayOf == nullptr || setError == nullptr || setExit == nullptr) return;
  display_ = displayOf();
  if (display_ == nullptr) return;
  // A request to a server that is gone must come back as an error: the signal would end the
  // program without a word.
  signal(SIGPIPE, SIG_IGN);
  // The first is to tell the user, and does so in Xlib's own words unless there is another; then
  // comes the second, which by itself is exit().
  setError([](void*) { return 0; });
  setExit(
      display_, [](void*, void*) { end(); }, nullptr);
}

LostDisplay::~LostDisplay() {
  std::erase(watches(), this);
  if (display_ == nullptr || !watches().empty()) return;
  loaded<SetExitHandler>("XSetIOErrorExitHandler")(display_, nullptr, nullptr);
}

// An error that was read is told by the connection itself. Where writing failed before, GLFW reads
// no more, and the error is never seen: but writing goes on failing.
void LostDisplay::check() {
  if (wayland_ == nullptr || waylandError_ == nullptr || waylandFlush_ == nullptr) return;
  const bool lost =
      waylandError_(wayland_) != 0 || (waylandFlush_(wayland_) < 0 && errno != EAGAIN);
  if (lost) end();
}

void LostDisplay::end() {
  for (LostDisplay* const watch : watches()) watch->say();
  // Without the destructors of what uses the display.
  std::_Exit(1);
}

// Another thread, of a driver say, must not touch what belongs to this one. Whoever throws here
// would do so through Xlib.
void LostDisplay::say() {
  if (std::this_thread::get_id() != thread_) return;
  try {
    if (const auto last = std::exchange(last_, nullptr)) last();
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace vides
