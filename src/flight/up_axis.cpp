// SPDX-License-Identifier: MIT
// Names of up axes, and their turns.
#include "flight/up_axis.hpp"

#include <algorithm>

namespace vides {

std::optional<UpAxis> upAxis(std::string_view wanted) {
  const auto* const found =
      std::ranges::find_if(kUpAxes, [&](UpAxis axis) { return name(axis) == wanted; });
  return found == kUpAxes.end() ? std::nullopt : std::optional(*found);
}

Mat3 uprightTurn(UpAxis axis) {
  // Where x, y and z of the file go.
  constexpr Vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);
  switch (axis) {
    case UpAxis::kY:
      break;
    case UpAxis::kMinusY:
      return {kX, -kY, -kZ};
    case UpAxis::kZ:
      return {kX, -kZ, kY};
    case UpAxis::kMinusZ:
      return {kX, kZ, -kY};
    case UpAxis::kX:
      return {kY, -kX, kZ};
    case UpAxis::kMinusX:
      return {-kY, kX, kZ};
  }
  return {kX, kY, kZ};
}

}  // namespace vides
