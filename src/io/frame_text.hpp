// SPDX-License-Identifier: MIT
// What a frame format is made of: a head, a text per frame, a foot. One file per format.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

#include "evaluate/section.hpp"
#include "io/frame_format.hpp"
#include "io/number_text.hpp"

namespace vides {

// Room for the text of one frame: at most 15 numbers, and the names of the members around them.
inline constexpr std::size_t kMostFrameBytes = 16 * kMostNumberBytes;

class FrameText {
 public:
  virtual ~FrameText() = default;
  virtual std::string head() const { return {}; }
  // Writes from `out` on and returns the end. Called for the frames in order.
  virtual char* write(const Frame& frame, char* out) = 0;
  virtual std::string foot() const { return {}; }

  // Whether a frame's text depends on the frames before: then those before the first one that is
  // written are shown to follow().
  virtual bool depends() const { return false; }
  virtual void follow(const Frame& /*frame*/) {}
};

template <std::size_t Size>
char* appendText(char* out, const char (&text)[Size]) {
  return std::copy_n(text, Size - 1, out);
}

}  // namespace vides
