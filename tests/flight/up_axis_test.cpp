// SPDX-License-Identifier: MIT
// The turns that bring an axis of a scene file upright.
#include "flight/up_axis.hpp"

#include <gtest/gtest.h>

#include <glm/matrix.hpp>

namespace vides {
namespace {

Vec3 wayOf(UpAxis axis) {
  switch (axis) {
    case UpAxis::kY:
      return {0, 1, 0};
    case UpAxis::kMinusY:
      return {0, -1, 0};
    case UpAxis::kZ:
      return {0, 0, 1};
    case UpAxis::kMinusZ:
      return {0, 0, -1};
    case UpAxis::kX:
      return {1, 0, 0};
    case UpAxis::kMinusX:
      return {-1, 0, 0};
  }
  return {};
}

TEST(UpAxis, NamesAreThoseOfFiles) {
  for (const UpAxis axis : kUpAxes) EXPECT_EQ(upAxis(name(axis)), axis);
  EXPECT_EQ(upAxis("+y"), std::nullopt);
  EXPECT_EQ(upAxis("Y"), std::nullopt);
  EXPECT_EQ(upAxis(""), std::nullopt);
}

TEST(UpAxis, TheShortestTurnTakesItToY) {
  for (const UpAxis axis : kUpAxes) {
    const Mat3 turn = uprightTurn(axis);
    const Vec3 up = wayOf(axis);
    EXPECT_EQ(turn * up, Vec3(0, 1, 0)) << name(axis);
    EXPECT_EQ(glm::determinant(turn), 1.0) << name(axis);
    EXPECT_EQ(glm::transpose(turn) * turn, Mat3(1.0)) << name(axis);
    // What is perpendicular to the way keeps its place.
    const Vec3 across = glm::cross(up, Vec3(0, 1, 0));
    EXPECT_EQ(turn * across, across) << name(axis);
  }
  EXPECT_EQ(uprightTurn(UpAxis::kMinusY) * Vec3(1, 2, 3), Vec3(1, -2, -3));
  EXPECT_EQ(uprightTurn(UpAxis::kZ) * Vec3(1, 2, 3), Vec3(1, 3, -2));
  EXPECT_EQ(uprightTurn(UpAxis::kX) * Vec3(1, 2, 3), Vec3(-2, 1, 3));
}

TEST(UpAxis, NothingIsRounded) {
  const Vec3 odd(0.1, 1e-300, 123456789.123456789);
  for (const UpAxis axis : kUpAxes) {
    const Mat3 turn = uprightTurn(axis);
    EXPECT_EQ(glm::transpose(turn) * (turn * odd), odd) << name(axis);
  }
}

}  // namespace
}  // namespace vides
