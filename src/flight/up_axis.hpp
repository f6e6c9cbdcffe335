// SPDX-License-Identifier: MIT
// The axis of a scene file that points up, and the turn that brings it there (3-vid-format,
// scene[].up).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "math/vector.hpp"

namespace vides {

enum class UpAxis : std::uint8_t { kY, kMinusY, kZ, kMinusZ, kX, kMinusX };
// In the order in which they are offered.
inline constexpr std::array kUpAxes{UpAxis::kY,      UpAxis::kMinusY, UpAxis::kZ,
                                    UpAxis::kMinusZ, UpAxis::kX,      UpAxis::kMinusX};

// "y", "-y", "z", "-z", "x", "-x": as files, commands and lists name it.
constexpr std::string_view name(UpAxis axis) {
  switch (axis) {
    case UpAxis::kY:
      break;
    case UpAxis::kMinusY:
      return "-y";
    case UpAxis::kZ:
      return "z";
    case UpAxis::kMinusZ:
      return "-z";
    case UpAxis::kX:
      return "x";
    case UpAxis::kMinusX:
      return "-x";
  }
  return "y";
}
// The axis of that name; nothing where there is none.
std::optional<UpAxis> upAxis(std::string_view name);

// U(up): the shortest turn that takes the axis to +y; for -y half a turn about x. A permutation of
// the axes with signs, so that it rounds nothing.
Mat3 uprightTurn(UpAxis axis);

}  // namespace vides
