// SPDX-License-Identifier: MIT
// Flying the camera with pointer and keys.
#include "edit/camera_tools.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "edit/edit_fixture.hpp"
#include "edit/free_camera.hpp"
#include "math/quaternion.hpp"

namespace vides {
namespace {

const PixelRectangle kPixels{0, 0, 400, 225};

ViewProjection viewOf(const Session& session) {
  const Flight& flight = session.flight();
  const Camera camera = session.camera();
  return viewProjection(
      camera.viewReferencePoint, camera.viewPlaneNormal, camera.viewUpVector,
      flight.lens.verticalFieldOfView(camera.zoom, flight.picture.width, flight.picture.height),
      kPixels);
}

TEST(FreeCamera, TurnsAsYawAndPitchDo) {
  Camera camera;  // at rest: along +z
  const Camera left = turnedCamera(camera, 0.5, 0.0);
  EXPECT_NEAR(glm::length(left.viewPlaneNormal - Vec3(std::sin(0.5), 0, std::cos(0.5))), 0, 1e-12);
  const Camera down = turnedCamera(camera, 0.0, 0.5);
  EXPECT_NEAR(down.viewPlaneNormal.y, -std::sin(0.5), 1e-12);
  // A level camera stays level.
  const Camera both = turnedCamera(turnedCamera(camera, 0.7, 0.4), -1.9, -0.9);
  EXPECT_NEAR(rollOf(both), 0.0, 1e-9);
  // The pitch stops at straight down.
  EXPECT_NEAR(turnedCamera(camera, 0.0, 3.0).viewPlaneNormal.y, -1.0, 1e-12);
  EXPECT_NEAR(rollOf(rolledCamera(camera, 0.3)), 0.3 * 180 / std::numbers::pi, 1e-9);
  EXPECT_EQ(zoomedCamera(camera, 1000).zoom, 100.0);
  EXPECT_EQ(zoomedCamera(camera, -1000).zoom, 1.0);
}

TEST(CameraTools, ADragTurnsWhatIsSeenWithThePointer) {
  Session session;
  CameraTools tools(session);
  const ViewProjection view = viewOf(session);
  const Vec2 middle{200, 112.5};
  const Vec3 seen = view.ray(middle).direction;
  tools.press(view, PointerButton::kLeft, middle, {});
  tools.move({201, 112.5});
  EXPECT_FALSE(session.freeCamera());  // a click's worth
  tools.move({230, 100});
  ASSERT_TRUE(session.freeCamera());
  const Vec3 far = session.camera().viewReferencePoint + 100.0 * seen;
  const Vec2 now = *viewOf(session).project(far);
  EXPECT_NEAR(now.x, 230, 2.0);
  EXPECT_NEAR(now.y, 100, 2.0);
  tools.release(PointerButton::kLeft);
  EXPECT_FALSE(session.undoName());  // flying changes nothing of the flight
  EXPECT_FALSE(session.modified());
}

TEST(CameraTools, TheMiddleButtonMovesTheAimsPlaneWithThePointer) {
  Session session;
  CameraTools tools(session);
  const ViewProjection view = viewOf(session);
  const Vec3 aim(0.0);
  const Vec2 at = *view.project(aim);
  tools.press(view, PointerButton::kMiddle, at, {});
  tools.move(at + Vec2(40, 25));
  const Vec2 now = *viewOf(session).project(aim);
  EXPECT_NEAR(now.x, at.x + 40, 1e-6);
  EXPECT_NEAR(now.y, at.y + 25, 1e-6);
}

TEST(CameraTools, ShiftRollsThePictureWithThePointer) {
  Session session;
  CameraTools tools(session);
  const Modifiers shift{true, false, false, false};
  const Vec3 point = aimPoint(session.currentKey(), session.currentOrientation()) + Vec3(0.1, 0, 0);
  const Vec2 middle{200, 112.5};
  const Vec2 before = *viewOf(session).project(point) - middle;
  tools.press(viewOf(session), PointerButton::kLeft, middle + Vec2(50, 0), shift);
  tools.move(middle + Vec2(0, 50));  // a quarter clockwise
  const Vec2 after = *viewOf(session).project(point) - middle;
  EXPECT_NEAR(after.x, -before.y, 1e-6);
  EXPECT_NEAR(after.y, before.x, 1e-6);
}

TEST(CameraTools, WheelDolliesAndZooms) {
  Session session;
  CameraTools tools(session);
  const double before = glm::length(session.camera().viewReferencePoint);
  tools.wheel(1, {});
  EXPECT_NEAR(glm::length(session.camera().viewReferencePoint), 0.9 * before, 1e-12);
  tools.wheel(-1, {});
  EXPECT_NEAR(glm::length(session.camera().viewReferencePoint), before, 1e-12);
  tools.wheel(2, {false, true, false, false});
  EXPECT_EQ(session.camera().zoom, 16.0);
}

TEST(CameraTools, KeysWalkWhileTheRightButtonIsDown) {
  Session session;
  CameraTools tools(session);
  const KeyChanged w{KeyboardKey::kW, true, false, {}}, notW{KeyboardKey::kW, false, false, {}};
  EXPECT_FALSE(tools.key(w));  // without the button it isn't ours
  tools.press(viewOf(session), PointerButton::kRight, {10, 10}, {});
  EXPECT_TRUE(tools.key(w));
  EXPECT_TRUE(tools.walking());
  const Camera before = session.camera();
  tools.advance(0.5);
  EXPECT_NEAR(glm::length(session.camera().viewReferencePoint -
                          (before.viewReferencePoint + 0.25 * before.viewPlaneNormal)),
              0, 1e-12);
  EXPECT_TRUE(tools.key(notW));
  EXPECT_FALSE(tools.walking());
}

TEST(CameraTools, EscapeInADragReturnsToWhereItBegan) {
  Session session;
  run(session, "fly-turn 10 0");
  const Camera before = session.camera();
  CameraTools tools(session);
  tools.press(viewOf(session), PointerButton::kLeft, {10, 10}, {});
  tools.move({100, 60});
  EXPECT_TRUE(tools.key({KeyboardKey::kEscape, true, false, {}}));
  EXPECT_NEAR(glm::length(session.camera().viewPlaneNormal - before.viewPlaneNormal), 0, 1e-12);
  EXPECT_FALSE(tools.active());
}

TEST(CameraTools, EscapeTakesBackAWalkWithoutADrag) {
  Session session;
  CameraTools tools(session);
  tools.press(viewOf(session), PointerButton::kRight, {10, 10}, {});
  tools.key({KeyboardKey::kD, true, false, {}});
  tools.advance(0.25);
  ASSERT_TRUE(session.freeCamera());
  EXPECT_TRUE(tools.key({KeyboardKey::kEscape, true, false, {}}));
  EXPECT_FALSE(session.freeCamera());
  EXPECT_FALSE(tools.walking());
}

TEST(CameraTools, StoppedItStaysWhereItIs) {
  Session session;
  CameraTools tools(session);
  tools.press(viewOf(session), PointerButton::kLeft, {10, 10}, {});
  tools.move({100, 60});
  const Camera there = session.camera();
  tools.stop();
  EXPECT_FALSE(tools.active());
  tools.move({200, 60});
  EXPECT_EQ(session.camera().viewPlaneNormal, there.viewPlaneNormal);
}

TEST(CameraTools, ATurnGoesOnFromWhereTheWheelLed) {
  Session session;
  CameraTools tools(session);
  tools.press(viewOf(session), PointerButton::kRight, {10, 10}, {});
  tools.wheel(1, {});
  const Vec3 place = session.camera().viewReferencePoint;
  tools.move({100, 60});
  EXPECT_EQ(session.camera().viewReferencePoint, place);
}

TEST(CameraTools, ShortcutsWithControlAreNotWalks) {
  Session session;
  CameraTools tools(session);
  tools.press(viewOf(session), PointerButton::kRight, {10, 10}, {});
  EXPECT_FALSE(tools.key({KeyboardKey::kS, true, false, {false, true, false, false}}));
  EXPECT_FALSE(tools.walking());
  EXPECT_TRUE(tools.key({KeyboardKey::kS, true, false, {true, false, false, false}}));
  EXPECT_TRUE(tools.walking());
}

}  // namespace
}  // namespace vides
