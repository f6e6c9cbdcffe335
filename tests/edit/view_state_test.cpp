// SPDX-License-Identifier: MIT
// Turning, panning, sizing and framing the view, in both projections.
#include "edit/view_state.hpp"

#include <gtest/gtest.h>

#include <random>

namespace vides {
namespace {

const PixelRectangle kPixels{100, 50, 640, 480};

Vec2 seen(const EditorView& view, const Vec3& p) {
  return *viewProjection(view, kPixels).project(p);
}

class ViewStateTest : public testing::TestWithParam<ProjectionType> {
 protected:
  EditorView view() const {
    EditorView v;
    v.target = {0.2, -0.1, 0.3};
    v.size = 1.7;
    v.type = GetParam();
    return v;
  }
};

TEST_P(ViewStateTest, TurningKeepsThePivotWhereItIsSeen) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Vec3 pivot{unit(random), unit(random), unit(random)};
    const EditorView turned = turnedAbout(view(), pivot, 300 * unit(random), 80 * unit(random));
    const Vec2 a = seen(view(), pivot), b = seen(turned, pivot);
    EXPECT_NEAR(glm::length(a - b), 0.0, 1e-6);
    EXPECT_LE(std::abs(turned.turn), 180.0);
    EXPECT_LE(std::abs(turned.tilt), 90.0);
  }
}

TEST_P(ViewStateTest, PanMovesTheTargetsPlaneWithThePointer) {
  const Vec2 by{37.0, -21.0};
  const EditorView moved = panned(view(), kPixels, by);
  const Vec2 a = seen(view(), view().target), b = seen(moved, view().target);
  EXPECT_NEAR(b.x - a.x, by.x, 1e-6);
  EXPECT_NEAR(b.y - a.y, by.y, 1e-6);
}

TEST_P(ViewStateTest, SizeKeepsWhatLiesUnderThePointer) {
  const Vec2 pointer{500.0, 180.0};
  // The point of the target's plane under the pointer.
  const Vec2 middle{kPixels.x + 0.5 * kPixels.width, kPixels.y + 0.5 * kPixels.height};
  const Vec3 point = panned(view(), kPixels, middle - pointer).target;
  ASSERT_NEAR(glm::length(seen(view(), point) - pointer), 0.0, 1e-6);
  for (const double steps : {1.0, 3.0, -2.0, 100.0, -100.0}) {
    const EditorView sized = sizedTowards(view(), kPixels, pointer, steps);
    EXPECT_NEAR(glm::length(seen(sized, point) - pointer), 0.0, 1e-6) << steps;
    EXPECT_GE(sized.size, kMinViewSize);
    EXPECT_LE(sized.size, kMaxViewSize);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, ViewStateTest,
                         testing::Values(ProjectionType::Parallel, ProjectionType::Perspective));

TEST(ViewState, NamedViewsLookAlongTheirAxes) {
  const auto towards = [](const char* name) {
    EditorView v;
    v.turn = namedView(name)->turn;
    v.tilt = namedView(name)->tilt;
    return viewProjection(v, kPixels).viewingDirection();
  };
  EXPECT_NEAR(glm::length(towards("front") - Vec3(0, 0, -1)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(towards("side") - Vec3(-1, 0, 0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(towards("top") - Vec3(0, -1, 0)), 0.0, 1e-12);
  EXPECT_FALSE(namedView("bottom"));
}

TEST(ViewState, OppositeLooksTheOtherWay) {
  EditorView v;
  const Vec3 before = viewProjection(v, kPixels).viewingDirection();
  const Vec3 after = viewProjection(opposite(v, Vec3(0.0)), kPixels).viewingDirection();
  EXPECT_NEAR(glm::length(before + after), 0.0, 1e-12);
}

TEST(ViewState, FramedPointsLieInside) {
  const Vec3 low{0.5, 0.4, -0.2}, high{0.9, 0.9, 0.4};
  const EditorView v = framed({}, low, high);
  for (const Vec3& p : {low, high, Vec3(low.x, high.y, low.z)}) {
    const Vec2 pixel = seen(v, p);
    EXPECT_GT(pixel.x, kPixels.x);
    EXPECT_LT(pixel.x, kPixels.x + kPixels.width);
    EXPECT_GT(pixel.y, kPixels.y);
    EXPECT_LT(pixel.y, kPixels.y + kPixels.height);
  }
  EXPECT_EQ(framed({}, low, low).target, low);
}

}  // namespace
}  // namespace vides
