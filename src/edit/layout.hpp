// SPDX-License-Identifier: MIT
// Where the window's columns end and what of it is folded: a part of the setup.
#pragma once

#include "flight/limits.hpp"

namespace vides {

// Pixels at content scale 1.
inline constexpr Range kLeftWidth{220, 480};
inline constexpr Range kRightWidth{220, 2000};  // what the camera sees may become large
inline constexpr Range kTimelineHeight{104, 400};

// In pixels at content scale 1.
struct Layout {
  float left = 292.0f;
  float right = 264.0f;
  float timeline = 150.0f;
  bool leftShown = true;
  bool rightShown = true;
  bool timelineShown = true;
  bool bare = false;  // nothing but the viewport's picture; not of the setup
  bool operator==(const Layout&) const = default;
};

}  // namespace vides
