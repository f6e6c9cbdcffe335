// SPDX-License-Identifier: MIT
// Points to pixels and back; the editor's named views; what fits.
#include "math/view_projection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "math/random_view.hpp"

namespace vides {
namespace {

using test::Random;
using test::randomView;

constexpr PixelRectangle kSquare{0, 0, 600, 600};

ViewProjection named(double turn, double tilt, ProjectionType type = ProjectionType::Parallel) {
  return viewProjection(EditorView{turn, tilt, 1.0, Vec3{0.0}, type}, kSquare);
}

TEST(ViewProjection, RayPassesThroughWhatIsSeenThere) {
  Random random(61);
  for (int i = 0; i < 10000; ++i) {
    const ViewProjection view = randomView(random);
    const Vec3 point = 2.0 * random.inCube();
    const auto pixel = view.project(point);
    if (!pixel) {
      ASSERT_TRUE(view.perspective());
      ASSERT_LE(glm::dot(point - view.referencePoint(), view.viewingDirection()), 1e-12);
      continue;
    }
    const Ray ray = view.ray(*pixel);
    ASSERT_NEAR(glm::length(ray.direction), 1.0, 1e-15);
    ASSERT_GT(glm::dot(ray.direction, view.viewingDirection()), 0.0);
    const Vec3 off = glm::cross(point - ray.origin, ray.direction);
    ASSERT_LT(glm::length(off), 1e-12);
    if (view.perspective()) {
      ASSERT_GT(glm::dot(point - ray.origin, ray.direction), 0.0);
    }
  }
}

TEST(ViewProjection, JacobianIsTheDerivative) {
  Random random(62);
  for (int i = 0; i < 10000; ++i) {
    const ViewProjection view = randomView(random);
    const Vec3 point = random.inCube();
    if (view.weight(point) < 0.05) continue;
    const glm::dmat3x2 jacobian = view.jacobian(point);
    const double h = 1e-6;
    for (int k = 0; k < 3; ++k) {
      Vec3 step{0.0};
      step[k] = h;
      const Vec2 slope = (*view.project(point + step) - *view.project(point - step)) / (2 * h);
      ASSERT_LT(glm::distance(slope, jacobian[k]), 1e-5 * (1 + glm::length(slope)));
    }
  }
}

TEST(ViewProjection, NamedViewsByHand) {
  // 600 pixels show 2 sqrt 3 units.
  const double unit = 600 / (2 * std::sqrt(3.0));
  struct Case {
    double turn, tilt;
    Vec3 right, up;  // world axes seen to the right and upwards
  };
  for (const Case& c : {Case{0, 0, {1, 0, 0}, {0, 1, 0}},       // front
                        Case{90, 0, {0, 0, -1}, {0, 1, 0}},     // side
                        Case{0, 90, {1, 0, 0}, {0, 0, -1}},     // top
                        Case{180, 0, {-1, 0, 0}, {0, 1, 0}},    // back
                        Case{0, -90, {1, 0, 0}, {0, 0, 1}}}) {  // from below
    for (const auto type : {ProjectionType::Parallel, ProjectionType::Perspective}) {
      const ViewProjection view = named(c.turn, c.tilt, type);
      const Vec2 middle = *view.project({0, 0, 0});
      EXPECT_NEAR(middle.x, 300, 1e-12);
      EXPECT_NEAR(middle.y, 300, 1e-12);
      const Vec2 right = *view.project(c.right) - middle, up = *view.project(c.up) - middle;
      EXPECT_GT(right.x, 0);
      EXPECT_NEAR(right.y, 0, 1e-12);
      EXPECT_LT(up.y, 0);  // y runs down
      EXPECT_NEAR(up.x, 0, 1e-12);
      if (type == ProjectionType::Parallel) {
        EXPECT_NEAR(right.x, unit, 1e-11);
        EXPECT_NEAR(up.y, -unit, 1e-11);
      }
    }
  }
}

TEST(ViewProjection, IsoByHand) {
  // The viewer stands at azimuth 32 degrees from +z towards +x, 22 degrees up.
  const double turn = 32 * std::numbers::pi / 180, tilt = 22 * std::numbers::pi / 180;
  const Vec3 toViewer{std::sin(turn) * std::cos(tilt), std::sin(tilt),
                      std::cos(turn) * std::cos(tilt)};
  const EditorView iso;
  const ViewProjection view = viewProjection(iso, kSquare);
  EXPECT_LT(glm::distance(view.viewingDirection(), -toViewer), 1e-15);
  const double unit = 600 / (2 * std::sqrt(3.0));
  const Vec2 x = *view.project({1, 0, 0}) - Vec2{300, 300};
  EXPECT_NEAR(x.x, unit * std::cos(turn), 1e-11);
  EXPECT_NEAR(x.y, unit * std::sin(turn) * std::sin(tilt), 1e-11);
  const Vec2 y = *view.project({0, 1, 0}) - Vec2{300, 300};
  EXPECT_NEAR(y.x, 0, 1e-11);
  EXPECT_NEAR(y.y, -unit * std::cos(tilt), 1e-11);
}

TEST(ViewProjection, AtSizeOneTheSphereTouchesTheSmallerSide) {
  Random random(63);
  for (const auto type : {ProjectionType::Parallel, ProjectionType::Perspective}) {
    for (const PixelRectangle& pixels :
         {PixelRectangle{10, 20, 800, 500}, PixelRectangle{0, 0, 300, 900}, kSquare}) {
      for (const double size : {1.0, 0.5}) {
        EditorView view{random.between(-180, 180), random.between(-90, 90), size, Vec3{0.0}, type};
        const ViewProjection p = viewProjection(view, pixels);
        Vec2 least{1e9}, most{-1e9};
        for (int i = 0; i < 200000; ++i) {
          const Vec2 at = *p.project(kCubeRadius * random.direction());
          least = glm::min(least, at);
          most = glm::max(most, at);
        }
        const double smaller = std::min(pixels.width, pixels.height);
        const Vec2 extent = most - least;
        if (size == 1.0) {
          EXPECT_LE(extent.x, smaller + 1e-9);
          EXPECT_GT(extent.x, 0.999 * smaller);
          EXPECT_LE(extent.y, smaller + 1e-9);
        } else if (type == ProjectionType::Parallel) {
          EXPECT_NEAR(extent.x, 0.5 * smaller, 0.001 * smaller);
        } else {
          EXPECT_LT(extent.x, 0.5 * smaller);  // twice as far
        }
      }
    }
  }
}

TEST(ViewProjection, PerspectiveSeesThirtyDegrees) {
  const ViewProjection view = viewProjection(
      EditorView{0, 0, 2.0, Vec3{0.0}, ProjectionType::Perspective}, {0, 0, 800, 500});
  const Vec3 top = view.ray({400, 0}).direction, bottom = view.ray({400, 500}).direction;
  EXPECT_NEAR(std::acos(glm::dot(top, bottom)), 30 * std::numbers::pi / 180, 1e-14);
}

TEST(ViewProjection, PanPutsTheTargetInTheMiddle) {
  Random random(64);
  for (int i = 0; i < 1000; ++i) {
    EditorView view{random.between(-180, 180), random.between(-90, 90), random.between(0.25, 20),
                    random.inCube(),
                    random.coin() ? ProjectionType::Parallel : ProjectionType::Perspective};
    const PixelRectangle pixels{20, 30, 700, 400};
    const auto at = viewProjection(view, pixels).project(view.target);
    ASSERT_TRUE(at.has_value());
    ASSERT_LT(glm::distance(*at, Vec2(370, 230)), 1e-10);
  }
}

TEST(ViewProjection, CameraViewShowsItsFieldOfView) {
  // At rest, 90 degrees over 400 pixels: a unit ahead, a unit is 200 pixels. Right is -x.
  const ViewProjection view = viewProjection({1, 2, 3}, {0, 0, 1}, {0, 1, 0}, std::numbers::pi / 2,
                                             PixelRectangle{0, 0, 800, 400});
  const Vec2 ahead = *view.project({1, 2, 5});
  EXPECT_NEAR(ahead.x, 400, 1e-12);
  EXPECT_NEAR(ahead.y, 200, 1e-12);
  const Vec2 corner = *view.project({0, 3, 4});
  EXPECT_NEAR(corner.x, 600, 1e-12);
  EXPECT_NEAR(corner.y, 0, 1e-12);
  EXPECT_FALSE(view.project({1, 2, 2.9}).has_value());
}

TEST(ViewProjection, ACollapsedRectangleStillHasAView) {
  for (const auto type : {ProjectionType::Parallel, ProjectionType::Perspective}) {
    EditorView view;
    view.type = type;
    const auto at = viewProjection(view, {5, 5, 0, 0}).project({0.1, 0.2, 0.3});
    ASSERT_TRUE(at.has_value());
    EXPECT_TRUE(std::isfinite(at->x) && std::isfinite(at->y));
  }
}

TEST(ViewProjection, ObliqueRaysRunAlongTheDirectionOfProjection) {
  ViewMapping cavalier;
  cavalier.projectionReferencePoint = {-std::sqrt(0.5), -std::sqrt(0.5), 1.0};
  const auto view = ViewProjection::make({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, cavalier, kSquare);
  ASSERT_TRUE(view.has_value());
  const Vec3 point{0.3, 0.2, 0.7};
  const Ray ray = view->ray(*view->project(point));
  EXPECT_LT(glm::length(glm::cross(point - ray.origin, ray.direction)), 1e-15);
  // 45 degrees to the view plane.
  EXPECT_NEAR(ray.direction.z, -std::sqrt(0.5), 1e-15);
}

}  // namespace
}  // namespace vides
