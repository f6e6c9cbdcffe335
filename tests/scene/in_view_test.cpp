// SPDX-License-Identifier: MIT
// Whether a picture has anything in it: lines, points and triangles before, beside and behind the
// camera.
#include "scene/in_view.hpp"

#include <gtest/gtest.h>

#include "scene/camera_scene.hpp"

namespace vides {
namespace {

// From the origin along z.
bool seen(Primitive primitive, const std::vector<Vec3>& points) {
  DrawList list;
  list.view = cameraView({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 12.0}, {1920, 1080}, {},
                         {0.0, 0.0, 320.0, 180.0});
  auto geometry = std::make_shared<Geometry>();
  geometry->primitive = primitive;
  for (const Vec3& p : points) geometry->points.push_back(geometryPoint(p));
  DrawItem item;
  item.geometry = geometry;
  list.items.push_back(item);
  return anythingInView(list);
}

TEST(InView, Points) {
  EXPECT_TRUE(seen(Primitive::kMarkers, {{0, 0, 1}}));
  EXPECT_FALSE(seen(Primitive::kMarkers, {{0, 0, -1}}));
  EXPECT_FALSE(seen(Primitive::kMarkers, {{5, 0, 1}, {0, -5, 1}}));
  EXPECT_TRUE(seen(Primitive::kMarkers, {{5, 0, 1}, {0, 0, 3}}));
}

TEST(InView, LinesWhoseEndsAreNot) {
  EXPECT_TRUE(seen(Primitive::kSegments, {{-9, 0, 1}, {9, 0, 1}}));
  EXPECT_TRUE(seen(Primitive::kSegments, {{0.01, 0, -3}, {0.01, 0, 3}}));  // through the camera
  EXPECT_FALSE(seen(Primitive::kSegments, {{-9, 5, 1}, {9, 5, 1}}));
  EXPECT_FALSE(seen(Primitive::kSegments, {{-9, 0, -1}, {9, 0, -1}}));
  // Across a corner, outside of it.
  EXPECT_FALSE(seen(Primitive::kSegments, {{-0.1, 3, 1}, {6, 0.1, 1}}));
}

TEST(InView, TrianglesAndNothing) {
  EXPECT_TRUE(seen(Primitive::kTriangles, {{-9, 0, 1}, {9, 0, 1}, {0, 9, 1}}));
  EXPECT_FALSE(seen(Primitive::kTriangles, {{3, 3, 1}, {4, 3, 1}, {3, 4, 1}}));
  EXPECT_FALSE(seen(Primitive::kSegments, {}));
}

}  // namespace
}  // namespace vides
