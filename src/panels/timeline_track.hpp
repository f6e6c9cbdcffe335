// SPDX-License-Identifier: MIT
// The timeline's scale: frames to pixels and back.
#pragma once

#include <cmath>
#include <cstdint>

#include "math/whole.hpp"

namespace vides {

// More than any flight has frames.
inline constexpr std::int64_t kMostFrames = std::int64_t{1} << 40;

struct TimelineTrack {
  float left = 0.0f, right = 0.0f;
  double firstFrame = 0.0;  // at the left end
  double framesPerPixel = 1.0;
  std::int64_t frames = 1;
  float x(double frame) const {
    return left + static_cast<float>((frame - firstFrame) / framesPerPixel);
  }
  double frame(float px) const {
    return firstFrame + static_cast<double>(px - left) * framesPerPixel;
  }
  std::int64_t nearest(float px) const { return wholeWithin(std::round(frame(px)), 0, frames - 1); }
  bool sees(float px) const { return px >= left - 1.0f && px <= right + 1.0f; }
};

}  // namespace vides
