// SPDX-License-Identifier: MIT
// The camera's view: letterboxing, and the lens formula by hand.
#include "scene/camera_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.hpp"
#include "scene/floor_part.hpp"

namespace vides {
namespace {

TEST(CameraScene, Letterbox) {
  const PictureFormat wide{1920, 1080}, square{100, 100};
  EXPECT_EQ(letterbox({0, 0, 800, 600}, wide), (PixelRectangle{0, 75, 800, 450}));
  EXPECT_EQ(letterbox({10, 20, 800, 600}, square), (PixelRectangle{110, 20, 600, 600}));
  EXPECT_EQ(letterbox({0, 0, 1600, 100}, wide), (PixelRectangle{711, 0, 178, 100}));
  EXPECT_EQ(letterbox({0, 0, 0, 0}, wide).width, 1.0);
  EXPECT_EQ(letterbox({0, 0, 100, 100}, {65536, 1}).height, 1.0);
}

TEST(CameraScene, PointsAreSeenThroughTheLens) {
  // Zoom 34 with 12 to 210 mm: f = 12 + 33 / 99 · 198 = 78 mm on a sensor 36 mm wide. A point x to
  // the right at distance d is seen f x / d mm right of the middle: 800 / 36 pixels a millimetre.
  Camera camera;
  camera.viewReferencePoint = {0.1, 0.2, 0.3};
  camera.viewPlaneNormal = {0, 0, 1};
  camera.viewUpVector = {0, 1, 0};  // the right is -x
  camera.zoom = 34;
  const ViewProjection view = cameraView(camera, {1920, 1080}, Lens{}, {0, 75, 800, 450});
  const Vec2 pixel = *view.project(camera.viewReferencePoint + Vec3{-0.2, 0.1, 2.0});
  EXPECT_NEAR(pixel.x, 400 + 78 * 0.2 / 2.0 * 800 / 36, 1e-9);
  EXPECT_NEAR(pixel.y, 75 + 225 - 78 * 0.1 / 2.0 * 800 / 36, 1e-9);
  EXPECT_FALSE(view.project(camera.viewReferencePoint - Vec3{0, 0, 1}));
}

TEST(CameraScene, AnyCameraByTheLensFormula) {
  test::Random random(11);
  for (int round = 0; round < 200; ++round) {
    Camera camera;
    camera.viewReferencePoint = random.inCube();
    camera.viewPlaneNormal = glm::normalize(random.inCube());
    camera.viewUpVector =
        glm::normalize(glm::cross(camera.viewPlaneNormal, glm::normalize(random.inCube())));
    camera.zoom = random.between(1, 100);
    const PictureFormat picture{1000, 500};
    const PixelRectangle r = letterbox({5, 7, 900, 800}, picture);
    const ViewProjection view = cameraView(camera, picture, Lens{24, 10, 100}, r);
    const Vec3 right = glm::cross(camera.viewPlaneNormal, camera.viewUpVector);
    const double x = random.between(-0.3, 0.3), y = random.between(-0.3, 0.3);
    const double d = random.between(0.2, 3);
    const double focal = 10 + (camera.zoom - 1) / 99 * 90;
    const Vec2 pixel = *view.project(camera.viewReferencePoint + x * right +
                                     y * camera.viewUpVector + d * camera.viewPlaneNormal);
    const double pixelsPerMillimetre = r.width / 24;
    EXPECT_NEAR(pixel.x, r.x + 0.5 * r.width + focal * x / d * pixelsPerMillimetre, 1e-6);
    EXPECT_NEAR(pixel.y, r.y + 0.5 * r.height - focal * y / d * pixelsPerMillimetre, 1e-6);
  }
}

// The horizon is where rays to far points of the ground are seen.
TEST(FloorPart, TheHorizonLiesWhereTheGroundEnds) {
  for (const Vec3& vpn : {Vec3(0, 0, 1), Vec3(0.3, -0.2, 0.9), Vec3(-0.8, 0.15, -0.4)}) {
    for (const Vec3& vup : {Vec3(0, 1, 0), Vec3(0.6, 0.7, 0), Vec3(1, 0.01, 0)}) {
      const ViewProjection view =
          viewProjection({0.1, 0.2, 0.3}, vpn, vup, 1.0, {10, 20, 400, 300});
      const auto ends = horizon(view);
      ASSERT_TRUE(ends);
      const Vec2 along = glm::normalize((*ends)[1] - (*ends)[0]);
      for (const double turn : {-0.3, 0.0, 0.3}) {
        const double azimuth = std::atan2(vpn.x, vpn.z) + turn;
        const Vec3 far(1e9 * std::sin(azimuth), -1.0, 1e9 * std::cos(azimuth));
        const Vec2 seen = *view.project(far) - (*ends)[0];
        EXPECT_NEAR(along.x * seen.y - along.y * seen.x, 0.0, 1e-3);
      }
      // Both ends lie outside the rectangle.
      for (const Vec2& end : *ends) {
        EXPECT_TRUE(end.x < 10 || end.x > 410 || end.y < 20 || end.y > 320);
      }
    }
  }
  EXPECT_FALSE(horizon(viewProjection(Vec3(0), {0, -1, 0}, {0, 0, 1}, 1.0, {0, 0, 400, 300})));
  EXPECT_FALSE(horizon(viewProjection(Vec3(0), {0, 0.9, 0.1}, {0, 1, 0}, 1.0, {0, 0, 400, 300})));
}

TEST(CameraScene, ShowsSceneCubeAndGuides) {
  CameraInput input;
  input.rectangle = {0, 0, 800, 600};
  input.camera.viewReferencePoint = {0, 0, -2};
  CameraScene scene;
  const auto elements = [&] {
    std::size_t sum = 0;
    for (const DrawItem& item : scene.build(input).items) sum += item.geometry->elements();
    return sum;
  };
  EXPECT_GT(elements(), 100u);  // the cube and the ground stand for a scene that isn't there
  input.surroundings = false;
  EXPECT_EQ(elements(), 0u);
  input.thirds = true;
  EXPECT_EQ(elements(), 4u);
  input.safeFrames = true;
  EXPECT_EQ(elements(), 12u);
  SceneGeometry geometry;
  geometry.positions = {{10, 0, 0}, {11, 0, 0}};
  geometry.edges = {{0, 1}};
  geometry.points = {0};
  input.scenes = {DrawableScene::make(geometry)};
  input.space = {{10, 0, 0}, 2.0};
  EXPECT_EQ(elements(), 14u);
  const DrawList& list = scene.build(input);
  const DrawItem& edge = list.items[1];
  const GeometryPoint& end = edge.geometry->points[1];
  EXPECT_EQ(edge.place.at({end.x, end.y, end.z}), Vec3(0.5, 0, 0));
  // Upright its x leads to y, and its box with it.
  input.scenes = {{DrawableScene::make(geometry), UpAxis::kX}};
  input.space = {{0, 10, 0}, 2.0};
  const DrawItem& upright = scene.build(input).items[1];
  const GeometryPoint& top = upright.geometry->points[1];
  EXPECT_EQ(upright.place.at({top.x, top.y, top.z}), Vec3(0, 0.5, 0));
  EXPECT_EQ(input.scenes[0].box(), (BoundingBox{{0, 10, 0}, {0, 11, 0}}));
  input.sceneAsPoints = true;
  EXPECT_EQ(elements(), 14u);
  EXPECT_EQ(list.outer, input.rectangle);
}

}  // namespace
}  // namespace vides
