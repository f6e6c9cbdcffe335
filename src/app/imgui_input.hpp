// SPDX-License-Identifier: MIT
// Feeds what the user did to Dear ImGui, in portions that it can tell apart.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "input/input_event.hpp"

struct ImGuiIO;

namespace vides {

// Dear ImGui sees only the state at each display frame: a press and its release, or two keys, in
// one frame would be lost. Events wait here; a portion is a movement, or one other.
class ImguiInput {
 public:
  // The map of keys; once per context.
  static void announce(ImGuiIO& io);

  void add(const std::vector<InputEvent>& events);
  bool waiting() const { return !events_.empty(); }
  // The next portion goes into `io`; each of its events is given to `seen` first, and goes no
  // further where that is true. Texts are `folded` as the fields need it.
  void feed(ImGuiIO& io, const std::function<bool(const InputEvent&)>& seen,
            const std::function<std::string(std::string_view)>& folded);
  // Nothing is pressed any more: the window lost its focus, or its picture.
  void release(ImGuiIO& io);

 private:
  std::deque<InputEvent> events_;
};

}  // namespace vides
