// SPDX-License-Identifier: MIT
// Focal lengths and fields of view against values worked by hand.
#include "math/lens.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vides {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(Lens, FocalLengthIsLinearInTheZoom) {
  const Lens lens;
  EXPECT_DOUBLE_EQ(lens.focalLength(1.0), 12.0);
  EXPECT_DOUBLE_EQ(lens.focalLength(100.0), 210.0);
  EXPECT_DOUBLE_EQ(lens.focalLength(50.5), 111.0);
  EXPECT_DOUBLE_EQ(lens.focalLength(2.0), 14.0);
}

TEST(Lens, FieldOfView) {
  // 36 mm sensor: 18 mm focal length sees 90 degrees, 50 mm 39.5978 degrees.
  const Lens lens{36.0, 18.0, 50.0};
  EXPECT_NEAR(lens.horizontalFieldOfView(1.0), 90.0 * kDegree, 1e-15);
  EXPECT_NEAR(lens.horizontalFieldOfView(100.0), 39.5977527090499 * kDegree, 1e-12);
  // A square picture sees as much up and down; 2:1 sees 2 atan(1/2) = 53.130102 degrees.
  EXPECT_NEAR(lens.verticalFieldOfView(1.0, 400, 400), 90.0 * kDegree, 1e-15);
  EXPECT_NEAR(lens.verticalFieldOfView(1.0, 800, 400), 53.130102354156 * kDegree, 1e-12);
  EXPECT_NEAR(lens.verticalFieldOfView(1.0, 400, 800), 126.869897645844 * kDegree, 1e-12);
}

}  // namespace
}  // namespace vides
