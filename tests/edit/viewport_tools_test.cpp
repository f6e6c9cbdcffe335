// SPDX-License-Identifier: MIT
// The viewport's tools by synthetic pointers: plane drags, VUP turns, navigation, selection.
#include "edit/viewport_tools.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include <cmath>
#include <numbers>
#include <random>

#include "edit/edit_fixture.hpp"

namespace vides {
namespace {

const PixelRectangle kPixels{280, 40, 700, 560};
constexpr Modifiers kShift{true, false, false, false};
constexpr Modifiers kControl{false, true, false, false};

// A viewport whose picking knows the handles' places: what the drawing does, without a drawing.
class Hand {
 public:
  Hand() : tools(session) {}

  ViewportPlace place() {
    ViewportPlace p;
    p.view = viewProjection(session.view().view, kPixels);
    p.now = now;
    p.pick = [this](const Vec2& pixel) { return pick(pixel); };
    return p;
  }
  Vec2 seen(const Vec3& point) { return *place().view.project(point); }
  Vec2 key(std::size_t k) { return seen(session.flight().keys[k].position); }
  Vec2 aim() { return seen(aimPoint(session.currentKey(), session.currentOrientation())); }

  void press(PointerButton button, const Vec2& at, const Modifiers& m = {}) {
    tools.move(place(), at, m);
    tools.press(place(), button, at, m);
  }
  void move(const Vec2& to, const Modifiers& m = {}) { tools.move(place(), to, m); }
  void release(PointerButton button, const Vec2& at, const Modifiers& m = {}) {
    tools.release(place(), button, at, m);
  }
  void drag(PointerButton button, const Vec2& from, const Vec2& to, const Modifiers& m = {}) {
    press(button, from, m);
    for (int i = 1; i <= 10; ++i) move(from + (to - from) * (i / 10.0), m);
    release(button, to, m);
  }
  void click(const Vec2& at, const Modifiers& m = {}) {
    press(PointerButton::kLeft, at, m);
    release(PointerButton::kLeft, at, m);
  }
  bool tap(KeyboardKey key) {
    const bool taken = tools.key(place(), {key, true, false, {}});
    tools.key(place(), {key, false, false, {}});
    return taken;
  }

  Session session;
  ViewportTools tools;
  double now = 0.0;
  std::vector<std::pair<HandleId, Vec3>> extra;  // squares and tips that a drawing would add

 private:
  PointerTarget pick(const Vec2& pixel) {
    PointerTarget target;
    const ViewProjection view = viewProjection(session.view().view, kPixels);
    double nearest = 10.0;
    const auto add = [&](const HandleId& id, const Vec3& point) {
      const auto at = view.project(point);
      if (!at || glm::length(*at - pixel) > nearest) return;
      nearest = glm::length(*at - pixel);
      target.handle = id;
    };
    for (std::size_t k = 0; k < session.flight().keys.size(); ++k) {
      add({HandleKind::kKey, k, 0, Axis::X}, session.flight().keys[k].position);
    }
    add({HandleKind::kAim, session.current().key, session.current().orientation, Axis::X},
        aimPoint(session.currentKey(), session.currentOrientation()));
    for (const auto& [id, point] : extra) add(id, point);
    for (std::size_t piece = 0; piece < session.evaluation().pieceCount(); ++piece) {
      for (double f = 0.0; f <= 1.0; f += 0.002) {
        const Vec3 point = session.evaluation().piecePoint(piece, f);
        const double distance = glm::length(*view.project(point) - pixel);
        if (distance < 6.0 && (!target.curve || distance < target.curve->distance)) {
          target.curve = CurveHit{piece, 0.0, f, point, distance};
        }
      }
    }
    return target;
  }
};

TEST(PlaneDrag, EachButtonKeepsItsCoordinate) {
  const std::pair<PointerButton, int> buttons[] = {
      {PointerButton::kLeft, 0}, {PointerButton::kMiddle, 1}, {PointerButton::kRight, 2}};
  for (const auto& [button, fixed] : buttons) {
    Hand hand;
    const Vec3 before = hand.session.flight().keys[0].position;
    const Vec2 from = hand.key(0), to = from + Vec2(35.25, -20.5);
    hand.drag(button, from, to);
    const Vec3 after = hand.session.flight().keys[0].position;
    EXPECT_EQ(after[fixed], before[fixed]);
    EXPECT_NEAR(glm::length(hand.key(0) - to), 0.0, 1e-6);
    EXPECT_EQ(hand.session.history().steps(), 1u);
    EXPECT_EQ(hand.session.history().undoStep().name, Text("step.move-key", {1}));
    run(hand.session, "undo");
    EXPECT_EQ(hand.session.flight(), newFlight());
  }
}

// The output line has the point's place and what holds it, whatever the keys choose; in the units
// that are shown.
TEST(PlaneDrag, TheOutputLineTellsWhereAndHow) {
  Hand hand;
  EXPECT_FALSE(hand.tools.output());
  const Vec2 from = hand.key(0), to = from + Vec2(10, -5);
  hand.press(PointerButton::kLeft, from);
  EXPECT_FALSE(hand.tools.output());  // not a drag yet
  hand.move(to);
  const auto said = [&](const char* way) {
    return OutputLine{
        MessageKind::kNumbers,
        Text("output.drag-point",
             {Text(way), hand.session.pointText(hand.session.flight().keys[0].position)})};
  };
  EXPECT_EQ(hand.tools.output(), said("hint.plane.x"));
  hand.tap(KeyboardKey::kX);
  hand.move(to + Vec2(1, 0));
  EXPECT_EQ(hand.tools.output(), said("drag.along.x"));
  hand.tap(KeyboardKey::kX);
  hand.tap(KeyboardKey::kZ);
  hand.tap(KeyboardKey::kZ);
  hand.move(to);
  EXPECT_EQ(hand.tools.output(), said("hint.plane.z"));
  hand.tools.cancel();
  EXPECT_FALSE(hand.tools.output());

  // Turning the view says nothing; turning the VUP the roll.
  hand.press(PointerButton::kLeft, {300, 60});
  hand.move({330, 60});
  EXPECT_FALSE(hand.tools.output());
  hand.tools.cancel();
  const Camera camera = hand.session.evaluation().cameraAt(hand.session.current());
  const Vec3 tip = upTip(hand.place().view, camera, 1.0);
  hand.extra = {{{HandleKind::kUp, 0, 0, Axis::X}, tip}};
  hand.press(PointerButton::kLeft, hand.seen(tip));
  hand.move(hand.seen(tip) + Vec2(30, 10));
  const double roll = hand.session.currentOrientation().roll;
  EXPECT_NE(roll, 0.0);
  EXPECT_EQ(hand.tools.output(),
            (OutputLine{MessageKind::kNumbers, Text("output.drag-up", {roll})}));
}

TEST(PlaneDrag, ControlAndLeftIsTheMiddleButton) {
  Hand hand;
  const Vec2 from = hand.key(1);
  hand.drag(PointerButton::kLeft, from, from + Vec2(20, 20), kControl);
  EXPECT_EQ(hand.session.flight().keys[1].position.y, 0.2);
  EXPECT_NE(hand.session.flight().keys[1].position.x, 0.5);
  EXPECT_EQ(hand.session.current().key, 1u);  // pressing on a cross makes it current
}

TEST(PlaneDrag, TheAimMovesByTheSameDragAndMayLeaveTheCube) {
  Hand hand;
  run(hand.session, "set-view 32 22 0.3");
  const Vec2 from = hand.aim(), to = from + Vec2(-150, 40);
  hand.drag(PointerButton::kRight, from, to);
  EXPECT_NEAR(glm::length(hand.aim() - to), 0.0, 1e-6);
  EXPECT_EQ(hand.session.currentOrientation().aim.z, 0.0);
  EXPECT_GT(glm::length(hand.session.currentOrientation().aim), 1.8);
}

TEST(PlaneDrag, LessThanThreePixelsIsAClick) {
  Hand hand;
  const Vec2 at = hand.key(1);
  hand.press(PointerButton::kLeft, at);
  hand.move(at + Vec2(2.9, 0));
  hand.release(PointerButton::kLeft, at + Vec2(2.9, 0));
  EXPECT_EQ(hand.session.flight(), newFlight());
  EXPECT_EQ(hand.session.current().key, 1u);
  EXPECT_FALSE(hand.session.undoName());
}

TEST(PlaneDrag, ADragIsComputedFromThePressNotBySteps) {
  Hand straight, around;
  const Vec2 from = straight.key(0), to = from + Vec2(31, 17);
  straight.drag(PointerButton::kLeft, from, to);
  around.press(PointerButton::kLeft, from);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> far(-400, 400);
  for (int i = 0; i < 200; ++i) around.move(from + Vec2(far(random), far(random)));
  around.release(PointerButton::kLeft, to);
  EXPECT_EQ(straight.session.flight(), around.session.flight());
}

TEST(PlaneDrag, EscapeLeavesTheDocumentEqual) {
  Hand hand;
  makeFive(hand.session);
  const std::string before = writeVid(hand.session.flight());
  const std::size_t steps = hand.session.history().steps();
  const Vec2 from = hand.key(3);
  hand.press(PointerButton::kRight, from);
  hand.move(from + Vec2(60, 60));
  EXPECT_NE(writeVid(hand.session.flight()), before);
  EXPECT_TRUE(hand.tap(KeyboardKey::kEscape));
  EXPECT_EQ(writeVid(hand.session.flight()), before);
  // The rest of the movement means nothing.
  hand.move(from + Vec2(90, 10));
  hand.release(PointerButton::kRight, from + Vec2(90, 10));
  EXPECT_EQ(writeVid(hand.session.flight()), before);
  EXPECT_EQ(hand.session.history().steps(), steps);
}

TEST(PlaneDrag, XyzCycleThroughAxisPlaneAndButton) {
  Hand hand;
  const Vec3 start = hand.session.flight().keys[0].position;
  const Vec2 from = hand.key(0), to = from + Vec2(30, 12);
  hand.press(PointerButton::kLeft, from);
  hand.move(to);
  const auto at = [&] { return hand.session.flight().keys[0].position; };
  EXPECT_EQ(hand.tools.drag()->constant, Axis::X);
  EXPECT_TRUE(hand.tap(KeyboardKey::kX));  // along x only
  EXPECT_FALSE(hand.tools.drag()->constant);
  EXPECT_NE(at().x, start.x);
  EXPECT_EQ(at().y, start.y);
  EXPECT_EQ(at().z, start.z);
  // As near to the pointer as that axis comes: the rest is perpendicular to it.
  const Vec2 axis = hand.seen(start + Vec3(0.1, 0, 0)) - hand.seen(start);
  EXPECT_NEAR(glm::dot(hand.key(0) - to, axis) / glm::length(axis), 0.0, 1e-6);
  hand.tap(KeyboardKey::kY);  // along y
  EXPECT_EQ(at().x, start.x);
  EXPECT_NE(at().y, start.y);
  hand.tap(KeyboardKey::kY);  // y kept
  EXPECT_EQ(hand.tools.drag()->constant, Axis::Y);
  EXPECT_EQ(at().y, start.y);
  EXPECT_NEAR(glm::length(hand.key(0) - to), 0.0, 1e-6);
  hand.tap(KeyboardKey::kY);  // back to the button's plane
  EXPECT_EQ(hand.tools.drag()->constant, Axis::X);
  EXPECT_EQ(at().x, start.x);
  hand.release(PointerButton::kLeft, to);
}

TEST(PlaneDrag, ShiftSnapsWhatMovesToTheGrid) {
  Hand hand;
  run(hand.session, "move-key 0 -0.512 0.2 0.8");
  const Vec2 from = hand.key(0);
  hand.press(PointerButton::kLeft, from);
  hand.move(from + Vec2(33, 21), kShift);
  const Vec3 p = hand.session.flight().keys[0].position;
  EXPECT_EQ(p.x, -0.512);  // what is fixed stays off the grid
  for (const int i : {1, 2}) EXPECT_EQ(p[i], std::round(p[i] * 20) / 20);
  EXPECT_NE(p.y, 0.2);
  // Letting go of Shift lets go of the grid, without moving the pointer.
  hand.tools.key(hand.place(), {KeyboardKey::kLeftShift, false, false, {}});
  const Vec3 q = hand.session.flight().keys[0].position;
  EXPECT_NE(q.y, p.y);
  hand.release(PointerButton::kLeft, from + Vec2(33, 21));
}

TEST(PlaneDrag, TheGridsStepCanBeChosenAndGivesTheDecimalsThatAreTyped) {
  for (const double step : {0.1, 0.003, 0.125, 0.000001 * 1234}) {
    Hand hand;
    Display display = hand.session.display();
    display.gridStep = step;
    hand.session.setDisplay(display);
    const Vec2 from = hand.key(0);
    hand.press(PointerButton::kLeft, from);
    hand.move(from + Vec2(33, 21), kShift);
    const Vec3 p = hand.session.flight().keys[0].position;
    for (const int i : {1, 2}) {
      const double times = p[i] / step;
      EXPECT_NEAR(times, std::round(times), 1e-9) << step;
      char typed[32];
      std::snprintf(typed, sizeof typed, "%.6f", p[i]);
      EXPECT_EQ(p[i], std::strtod(typed, nullptr)) << step;
    }
    hand.release(PointerButton::kLeft, from + Vec2(33, 21), kShift);
  }
}

TEST(PlaneDrag, AKeyStaysInTheCubeAndFollowsAlongItsFace) {
  Hand hand;
  const Vec2 from = hand.key(0), to = from + Vec2(20, -900);
  hand.press(PointerButton::kLeft, from);
  hand.move(to);
  const Vec3 p = hand.session.flight().keys[0].position;
  EXPECT_EQ(p.y, 1.0);
  EXPECT_LE(std::abs(p.z), 1.0);
  // Stopped by the lid only: z is still where the pointer wants it.
  const Vec2 slight = from + Vec2(0, -300);
  hand.move(slight);
  const Vec3 q = hand.session.flight().keys[0].position;
  if (q.y == 1.0 && std::abs(q.z) < 1.0) {
    const Vec2 axis = hand.seen(q + Vec3(0, 0, 0.1)) - hand.seen(q);
    EXPECT_NEAR(glm::dot(hand.key(0) - slight, axis) / glm::length(axis), 0.0, 0.5);
  }
  hand.release(PointerButton::kLeft, slight);
}

TEST(PlaneDrag, SelectedKeysMoveTogetherClampedInCommon) {
  Hand hand;
  makeFive(hand.session);
  run(hand.session, "select-keys 1 3");
  const Vec3 a = hand.session.flight().keys[1].position, b = hand.session.flight().keys[3].position;
  const Vec2 from = hand.key(3);
  hand.drag(PointerButton::kMiddle, from, from + Vec2(70, 10));
  const Vec3 moved = hand.session.flight().keys[3].position - b;
  EXPECT_GT(glm::length(moved), 0.05);
  EXPECT_NEAR(glm::length(hand.session.flight().keys[1].position - a - moved), 0.0, 1e-12);
  EXPECT_THAT(hand.session.selected().keys(), testing::ElementsAre(1, 3));
  EXPECT_EQ(hand.session.history().undoStep().name, Text("step.move-keys", {2}));
}

TEST(PlaneDrag, SeveralAimsMoveTogether) {
  Hand hand;
  run(hand.session, "select-all");
  const Vec2 from = hand.aim();
  hand.drag(PointerButton::kRight, from, from + Vec2(40, -30));
  const Flight& flight = hand.session.flight();
  EXPECT_NE(flight.keys[0].orientations[0].aim, Vec3(0.0));
  EXPECT_EQ(flight.keys[0].orientations[0].aim, flight.keys[1].orientations[0].aim);
}

TEST(PlaneDrag, EdgeOnNothingMovesAndThePlaneIsNamed) {
  Hand hand;
  run(hand.session, "view front");
  hand.now = 5.0;
  const Vec2 from = hand.key(0);
  hand.drag(PointerButton::kLeft, from, from + Vec2(40, 40));
  EXPECT_EQ(hand.session.flight(), newFlight());
  EXPECT_FALSE(hand.session.undoName());
  EXPECT_EQ(hand.session.output().text, Text("refusal.plane-edge-on.x"));
  ASSERT_TRUE(hand.tools.note(7.9));
  EXPECT_EQ(hand.tools.note(7.9)->text, Text("refusal.plane-edge-on.x"));
  EXPECT_FALSE(hand.tools.note(8.1));
  const Vec2 again = hand.key(1);
  hand.drag(PointerButton::kMiddle, again, again + Vec2(40, 40));
  EXPECT_EQ(hand.session.output().text, Text("refusal.plane-edge-on.y"));
  hand.drag(PointerButton::kRight, again, again + Vec2(40, 40));
  EXPECT_NEAR(glm::length(hand.key(1) - again - Vec2(40, 40)), 0.0, 1e-6);
}

TEST(PlaneDrag, APlaneSquareDragsItsPlaneAndKeepsItsDistance) {
  Hand hand;
  const Vec3 start = hand.session.flight().keys[0].position;
  const Vec2 key = hand.key(0), square = key + Vec2(14, -14);
  // Where that pixel is in space doesn't matter.
  const Vec3 there = hand.place().view.ray(square).origin;
  hand.extra.push_back({{HandleKind::kPlane, 0, 0, Axis::Z}, there});
  hand.drag(PointerButton::kLeft, square, square + Vec2(25, 30));
  EXPECT_EQ(hand.session.flight().keys[0].position.z, start.z);
  EXPECT_NEAR(glm::length(hand.key(0) - key - Vec2(25, 30)), 0.0, 1e-6);
}

// 4, "Must hold": 10,000 random views, keys, planes and pointer moves, in both projections: under
// the pointer within half a pixel, or refused for a named reason, or stopped by the cube.
TEST(PlaneDrag, TenThousandRandomDragsFollowThePointer) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int followed = 0, edgeOn = 0, stopped = 0;
  for (int i = 0; i < 10'000; ++i) {
    EditorView view;
    view.turn = 180 * unit(random);
    view.tilt = 90 * unit(random);
    view.size = std::pow(3.0, unit(random));
    view.type = i % 2 == 0 ? ProjectionType::Parallel : ProjectionType::Perspective;
    const ViewProjection projection = viewProjection(view, kPixels);
    Flight flight = newFlight();
    Key key = flight.keys[0];
    key.position = Vec3(unit(random), unit(random), unit(random));
    flight.keys.set(0, key);
    const auto from = projection.project(key.position);
    if (!from) continue;
    const Vec2 to = *from + 80.0 * Vec2(unit(random), unit(random));
    const auto plane = static_cast<Axis>(i % 3);
    const PlaneDragTool tool({flight, Evaluation(), Marks{}}, PlaneDragTool::What::kKey, projection,
                             *from + 5.0 * Vec2(unit(random), unit(random)), plane, false);
    const auto moved = tool.at(to);
    if (!moved) {
      ++edgeOn;
      EXPECT_FALSE(textOf(moved.error()).empty());
      continue;
    }
    const Vec3 p = moved->keys[0].position;
    EXPECT_EQ(p[static_cast<int>(plane)], key.position[static_cast<int>(plane)]);
    ASSERT_LE(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1.0);
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) == 1.0) {
      ++stopped;
      continue;
    }
    ++followed;
    ASSERT_LT(glm::length(*projection.project(p) - to), 0.5);
  }
  EXPECT_GT(followed, 5000);
  EXPECT_GT(edgeOn, 10);
  EXPECT_GT(stopped, 100);
}

TEST(VupTurn, FollowsThePointer) {
  Hand hand;
  hand.extra.push_back(
      {{HandleKind::kUp, 0, 0, Axis::X}, hand.session.flight().keys[0].position + Vec3(0, 0.3, 0)});
  const Vec2 tip = hand.seen(hand.extra[0].second), to = tip + Vec2(60, 30);
  hand.drag(PointerButton::kLeft, tip, to);
  const Camera camera = hand.session.evaluation().cameraAt({0, 0});
  const Vec2 key = hand.key(0);
  const Vec2 up = hand.seen(camera.viewReferencePoint + 0.01 * camera.viewUpVector) - key;
  const Vec2 wanted = to - key;
  EXPECT_NEAR(up.x * wanted.y - up.y * wanted.x, 0.0, 1e-3 * glm::length(up) * glm::length(wanted));
  EXPECT_GT(glm::dot(up, wanted), 0.0);
  EXPECT_EQ(hand.session.history().undoStep().name, Text("step.turn-up", {1}));
  hand.drag(PointerButton::kLeft, tip, to, {});
}

TEST(VupTurn, ShiftSnapsAndFullTurnsStay) {
  Hand hand;
  run(hand.session, "set-roll 700");
  hand.extra.push_back(
      {{HandleKind::kUp, 0, 0, Axis::X}, hand.session.flight().keys[0].position + Vec3(0, 0.3, 0)});
  const Vec2 tip = hand.seen(hand.extra[0].second);
  hand.press(PointerButton::kLeft, tip);
  hand.move(tip + Vec2(50, 40), kShift);
  const double roll = hand.session.currentOrientation().roll;
  EXPECT_EQ(std::remainder(roll, 15.0), 0.0);
  EXPECT_LE(std::abs(roll - 700), 180 + 7.5);
  hand.release(PointerButton::kLeft, tip + Vec2(50, 40), kShift);
}

TEST(VupTurn, EdgeOnIsTold) {
  Hand hand;
  run(hand.session, "view side");
  run(hand.session, "set-aim -0.5 0.2 -0.8");  // along -z: the circle is seen from its edge
  hand.extra.push_back(
      {{HandleKind::kUp, 0, 0, Axis::X}, hand.session.flight().keys[0].position + Vec3(0, 0.3, 0)});
  const double before = hand.session.currentOrientation().roll;
  const Vec2 tip = hand.seen(hand.extra[0].second);
  hand.drag(PointerButton::kLeft, tip, tip + Vec2(50, 40));
  EXPECT_EQ(hand.session.output().text, Text("refusal.circle-edge-on"));
  EXPECT_EQ(hand.session.currentOrientation().roll, before);
}

TEST(Navigation, DragsTurnPanAndTheWheelSizes) {
  Hand hand;
  const EditorView start = hand.session.view().view;
  const Vec2 empty{300, 60};
  hand.drag(PointerButton::kLeft, empty, empty + Vec2(50, 25));
  EXPECT_NEAR(hand.session.view().view.turn, start.turn - 20, 1e-9);
  EXPECT_NEAR(hand.session.view().view.tilt, start.tilt + 10, 1e-9);
  EXPECT_NEAR(glm::length(hand.seen(Vec3(0.0)) - Vec2(630, 320)), 0, 1e-9);
  const Vec2 before = hand.key(0);
  hand.drag(PointerButton::kMiddle, empty, empty + Vec2(50, 25));
  EXPECT_NEAR(glm::length(hand.key(0) - before - Vec2(50, 25)), 0, 1e-9);
  hand.tools.wheel(hand.place(), {500, 300}, 2);
  EXPECT_NEAR(hand.session.view().view.size, 1.44, 1e-12);
  EXPECT_EQ(hand.session.flight(), newFlight());
  EXPECT_FALSE(hand.session.undoName());
}

TEST(Navigation, WithVHeldNothingIsHit) {
  Hand hand;
  const Vec2 at = hand.key(1);
  hand.move(at);
  EXPECT_TRUE(hand.tools.hovered());
  EXPECT_EQ(hand.tools.hint(), Text("hint.handle"));
  hand.tools.key(hand.place(), {KeyboardKey::kV, true, false, {}});
  EXPECT_FALSE(hand.tools.hovered());
  hand.drag(PointerButton::kLeft, at, at + Vec2(30, 0));
  EXPECT_EQ(hand.session.flight(), newFlight());
  EXPECT_EQ(hand.session.current().key, 0u);
  EXPECT_NE(hand.session.view().view.turn, 32.0);
  hand.tools.key(hand.place(), {KeyboardKey::kV, false, false, {}});
  hand.move(hand.key(1));
  EXPECT_TRUE(hand.tools.hovered());
}

TEST(Navigation, EscapePutsTheViewBack) {
  Hand hand;
  const ViewState start = hand.session.view();
  hand.press(PointerButton::kLeft, {300, 60});
  hand.move({400, 100});
  EXPECT_NE(hand.session.view(), start);
  hand.tap(KeyboardKey::kEscape);
  EXPECT_EQ(hand.session.view(), start);
}

TEST(Selection, ClicksOnTheCurve) {
  Hand hand;
  makeFive(hand.session);
  const Vec3 point = hand.session.evaluation().piecePoint(2, 0.4);
  hand.click(hand.seen(point));
  EXPECT_EQ(hand.session.current().key, 2u);
  hand.click(hand.seen(point), kControl);
  ASSERT_EQ(hand.session.flight().keys.size(), 6u);
  EXPECT_LT(glm::length(hand.session.flight().keys[3].position - point), 0.02);
  EXPECT_EQ(hand.session.current().key, 3u);
}

TEST(Selection, ShiftClicksAndBoxes) {
  Hand hand;
  makeFive(hand.session);
  run(hand.session, "select-key 0");
  hand.click(hand.key(3), kShift);
  EXPECT_THAT(hand.session.selected().keys(), testing::ElementsAre(0, 3));
  EXPECT_EQ(hand.session.current().key, 0u);
  hand.click(hand.key(3), kShift);
  EXPECT_THAT(hand.session.selected().keys(), testing::ElementsAre(0));
  hand.click(hand.key(3), kShift);
  hand.click(hand.key(3));  // without Shift: only this one
  EXPECT_THAT(hand.session.selected().keys(), testing::ElementsAre(3));

  hand.press(PointerButton::kLeft, {281, 41}, kShift);
  hand.move({970, 590}, kShift);
  ASSERT_TRUE(hand.tools.box());
  EXPECT_EQ(hand.tools.box()->width, 689);
  hand.release(PointerButton::kLeft, {970, 590}, kShift);
  EXPECT_EQ(hand.session.selected().size(), 5u);
  EXPECT_EQ(hand.session.current().key, 3u);
  EXPECT_FALSE(hand.tools.box());
}

}  // namespace
}  // namespace vides
