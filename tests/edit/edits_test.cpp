// SPDX-License-Identifier: MIT
// Each edit does what the specification says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "edit/edit_fixture.hpp"
#include "edit/key_edits.hpp"
#include "edit/texts.hpp"
#include "io/frame_writer.hpp"

namespace vides {
namespace {

double distance(const Vec3& a, const Vec3& b) { return glm::length(a - b); }

TEST(KeyEdits, InsertGoesHalfwayAndTakesOver) {
  Session session;
  makeFive(session);
  run(session, "select-key 1");
  run(session, "set-shape 0.1 0.2 0.3");
  run(session, "set-hold 3");
  const Vec3 halfway = session.evaluation().piecePoint(1, 0.5);
  const Key from = session.currentKey();
  run(session, "insert-key");
  EXPECT_EQ(session.current(), (OrientationPlace{2, 0}));
  EXPECT_EQ(session.currentKey().position, halfway);
  EXPECT_EQ(session.currentKey().shape, from.shape);
  EXPECT_EQ(session.currentKey().orientations.size(), 3u);
  EXPECT_EQ(session.currentKey().orientations[0].hold, 0.0);
  EXPECT_EQ(session.undoName()->parts.front(), TextPart(Text("step.insert-key", {3})));
}

TEST(KeyEdits, InsertSeveralMakesTheLastCurrent) {
  Session session;
  run(session, "insert-keys 10");
  EXPECT_EQ(session.flight().keys.size(), 12u);
  EXPECT_EQ(session.current().key, 10u);
  refused(session, "insert-keys 0", "refusal.insert-count");
  refused(session, "insert-keys 11", "refusal.insert-count");
}

TEST(KeyEdits, AfterTheLastKeyOnlyAppend) {
  Session session;
  run(session, "select-key 1");
  refused(session, "insert-key", "refusal.after-last-key");
  refused(session, "insert-keys 2", "refusal.after-last-key");
  run(session, "append-key");
  // Along the straight line, a third of its length of 1 away.
  EXPECT_NEAR(distance(session.flight().keys[2].position, {0.5 + 1.0 / 3.0, 0.2, 0.8}), 0, 1e-12);
  EXPECT_EQ(session.current().key, 2u);
  run(session, "append-key");
  EXPECT_NEAR(session.flight().keys[3].position.x, 0.5 + 1.0 / 3.0 + 1.0 / 9.0, 1e-12);
  run(session, "move-key 3 1 0.2 0.8");
  refused(session, "append-key", "refusal.no-room");
  run(session, "set-closed on");
  run(session, "select-key 3");
  run(session, "insert-key");
  EXPECT_EQ(session.flight().keys.size(), 5u);
}

TEST(KeyEdits, TwoKeysRemainAndThePredecessorBecomesCurrent) {
  Session session;
  refused(session, "delete-keys", "refusal.two-keys");
  makeFive(session);
  run(session, "select-key 3");
  run(session, "delete-keys");
  EXPECT_EQ(session.current().key, 2u);
  run(session, "select-key 0");
  const Vec3 successor = session.flight().keys[1].position;
  run(session, "delete-keys");
  EXPECT_EQ(session.current().key, 0u);
  EXPECT_EQ(session.currentKey().position, successor);
  run(session, "select-all");
  refused(session, "delete-keys", "refusal.two-keys");
  run(session, "select-keys 1 2");
  refused(session, "delete-keys", "refusal.two-keys");
}

TEST(KeyEdits, SelectedKeysMoveTogetherAndStopTogether) {
  Session session;
  makeFive(session);
  run(session, "select-keys 1 3");
  const Vec3 a = session.flight().keys[1].position, b = session.flight().keys[3].position;
  run(session, "move-keys 0.7 0.1 0");
  // Key 4 at x = 0.6 leaves room for 0.4.
  EXPECT_NEAR(distance(session.flight().keys[1].position, a + Vec3(0.4, 0.1, 0)), 0, 1e-15);
  EXPECT_NEAR(distance(session.flight().keys[3].position, b + Vec3(0.4, 0.1, 0)), 0, 1e-15);
  EXPECT_LE(session.flight().keys[3].position.x, 1.0);
}

TEST(KeyEdits, AbsoluteAimsStayAndRelativeOnesMoveAlong) {
  Session session;
  run(session, "insert-orientation");
  run(session, "set-aim-mode relative");
  const Key before = session.currentKey();
  EXPECT_NEAR(distance(aimPoint(before, before.orientations[1]), Vec3(0.0)), 0, 1e-15);
  run(session, "move-key 0 0.5 -0.5 0.1");
  const Key after = session.currentKey();
  EXPECT_EQ(aimPoint(after, after.orientations[0]), Vec3(0.0));
  EXPECT_EQ(aimOffset(after, after.orientations[1]), aimOffset(before, before.orientations[1]));
}

TEST(KeyEdits, DuplicatesFollowTheCurrentKey) {
  Session session;
  makeFive(session);
  run(session, "select-keys 0 3");
  run(session, "make-current 3");
  run(session, "duplicate-keys");
  EXPECT_EQ(session.flight().keys.size(), 7u);
  EXPECT_EQ(session.flight().keys[4], session.flight().keys[0]);
  EXPECT_EQ(session.flight().keys[5], session.flight().keys[3]);
  EXPECT_EQ(session.current().key, 5u);
  EXPECT_THAT(session.selected().keys(), testing::ElementsAre(4, 5));
}

TEST(OrientationEdits, UpToTenAndNeverNone) {
  Session session;
  refused(session, "delete-orientation", "refusal.one-orientation");
  run(session, "set-roll 5");
  for (std::size_t i = 1; i < 10; ++i) {
    run(session, "insert-orientation");
    EXPECT_EQ(session.current().orientation, i);
    EXPECT_EQ(session.currentOrientation().roll, 5.0);
  }
  refused(session, "insert-orientation", "refusal.ten-orientations");
  run(session, "select-key 0 4");
  run(session, "delete-orientation");
  EXPECT_EQ(session.current().orientation, 3u);
  EXPECT_EQ(session.currentKey().orientations.size(), 9u);
}

TEST(OrientationEdits, SwitchingTheModeKeepsTheAim) {
  Session session;
  run(session, "set-aim 0.3 -0.7 2.5");
  run(session, "set-aim-mode relative");
  EXPECT_NEAR(
      distance(aimPoint(session.currentKey(), session.currentOrientation()), {0.3, -0.7, 2.5}), 0,
      1e-15);
  run(session, "set-aim 0.1 0.1 0.1");  // still given in the cube
  EXPECT_NEAR(
      distance(aimPoint(session.currentKey(), session.currentOrientation()), {0.1, 0.1, 0.1}), 0,
      1e-15);
  run(session, "set-aim-mode absolute");
  EXPECT_NEAR(distance(session.currentOrientation().aim, {0.1, 0.1, 0.1}), 0, 1e-15);
}

TEST(OrientationEdits, TheLastOrientationOfAnOpenFlightOwnsNoSection) {
  Session session;
  run(session, "select-key 1");
  for (const char* line :
       {"set-speed-value 0 3", "set-duration 1", "ease constant", "set-duration-frames 3",
        "match-speed before", "set-speed 1 1 1 1 1 1 1 1 1 1"}) {
    refused(session, line, "refusal.no-section");
  }
  run(session, "set-hold 1");  // a hold at the end is possible
  run(session, "set-closed on");
  run(session, "set-duration 1");
}

TEST(OrientationEdits, DurationOverridesTheRateAndGivesBack) {
  Session session;
  const std::int64_t byRate = session.evaluation().frameCount();
  run(session, "set-duration 2");
  EXPECT_EQ(session.evaluation().frameCount(), 51);
  run(session, "set-duration-frames 10");
  EXPECT_EQ(session.evaluation().frameCount(), 11);
  EXPECT_DOUBLE_EQ(*session.currentOrientation().duration, 0.4);
  run(session, "clear-duration");
  EXPECT_EQ(session.evaluation().frameCount(), byRate);
}

TEST(OrientationEdits, SpeedsMatchTheirNeighbours) {
  Session session;
  run(session, "insert-key");
  run(session, "select-key 0");
  run(session, "set-speed 10 10 10 10 10 10 10 10 10 30");
  run(session, "select-key 1");
  run(session, "match-speed before");
  EXPECT_EQ(session.currentOrientation().speed[0], 30.0);
  refused(session, "match-speed after", "refusal.no-neighbour");
}

TEST(FlightEdits, ATypedShapeIsOwn) {
  Session session;
  run(session, "set-preset 3");
  run(session, "set-bias 0.25");
  EXPECT_EQ(session.currentKey().shape.preset, KeyShape::kOwn);
  EXPECT_EQ(session.currentKey().shape.own, (Shape{-0.3, 0.0, 0.25}));
  refused(session, "set-tension 1.01", "refusal.at");
  refused(session, "set-preset 10", "refusal.preset");
}

TEST(FlightEdits, APresetReachesEveryKeyThatHasIt) {
  Session session;
  makeFive(session);
  const double before = session.evaluation().length();
  run(session, "set-preset-shape 0 0.9 0 0");
  EXPECT_EQ(shapeOf(session.flight(), session.flight().keys[2]).tension, 0.9);
  EXPECT_NE(session.evaluation().length(), before);
}

TEST(FlightEdits, AnotherSpaceKeepsEveryWorldPositionAndFrame) {
  Session session;
  makeFive(session);
  run(session, "select-key 2");
  run(session, "set-aim-mode relative");
  const Flight before = session.flight();
  const Evaluation old = session.evaluation();
  run(session, "set-space 0.2 -0.1 0 2.5");
  const Flight& after = session.flight();
  EXPECT_EQ(after.space.halfSize, 2.5);
  EXPECT_DOUBLE_EQ(after.rates.move, 250.0);
  ASSERT_EQ(session.evaluation().frameCount(), old.frameCount());
  for (std::int64_t n = 0; n < old.frameCount(); n += 7) {
    const Camera a = old.frame(n).camera, b = session.evaluation().frame(n).camera;
    EXPECT_NEAR(distance(before.space.toWorld(a.viewReferencePoint),
                         after.space.toWorld(b.viewReferencePoint)),
                0, 1e-12);
    EXPECT_NEAR(distance(a.viewPlaneNormal, b.viewPlaneNormal), 0, 1e-12);
    EXPECT_NEAR(distance(a.viewUpVector, b.viewUpVector), 0, 1e-12);
  }
  refused(session, "set-space 0.2 -0.1 0 0.3", "refusal.space-too-small");
  refused(session, "set-space 0 0 0 0", "refusal.problem");
  refused(session, "set-space 0 0 0 -1", "refusal.problem");
  refused(session, "set-space 5 0 0 1", "refusal.space-too-small");
}

TEST(FlightEdits, TheFirstSceneIsFittedToTheCube) {
  Session session;
  run(session, "add-scene a.obj 10 0 -2 14 2 6");
  EXPECT_EQ(session.flight().space.center, Vec3(12, 1, 2));
  EXPECT_DOUBLE_EQ(session.flight().space.halfSize, 5.0);
  EXPECT_NEAR(session.flight().space.toCube({12, 1, 6}).z, 0.8, 1e-15);
  run(session, "add-scene b.obj 0 0 0 100 100 100");  // later ones leave it
  EXPECT_DOUBLE_EQ(session.flight().space.halfSize, 5.0);
  EXPECT_EQ(session.flight().scene.size(), 2u);
  refused(session, "remove-scene 2", "refusal.no-such-scene");
  run(session, "remove-scene 0");
  EXPECT_EQ(session.flight().scene[0].file, "b.obj");
}

// The current orientation's frame, as the frame writer puts it, is what the camera saw.
void expectWritten(const Session& session, const Camera& camera) {
  FrameOptions options;
  options.format = frameFormat("csv");
  options.first = session.evaluation().frameOf(session.current());
  options.last = options.first + 1;
  std::string text;
  writeFrames(session.evaluation(), options, [&](std::string_view piece) {
    text += piece;
    return true;
  });
  std::istringstream line(text.substr(text.find('\n') + 1));
  std::vector<double> values;
  for (std::string cell; std::getline(line, cell, ',');) {
    values.push_back(values.size() == 3 ? 0.0 : std::stod(cell));
  }
  ASSERT_EQ(values.size(), 14u);
  const auto point = [&](std::size_t i) { return Vec3(values[i], values[i + 1], values[i + 2]); };
  EXPECT_NEAR(distance(point(4), camera.viewReferencePoint), 0, 1e-6);
  EXPECT_NEAR(distance(point(7), camera.viewPlaneNormal), 0, 1e-6);
  EXPECT_NEAR(distance(point(10), camera.viewUpVector), 0, 1e-6);
  EXPECT_NEAR(values[13], camera.zoom, 1e-6);
}

TEST(CameraEdits, NewKeyFromViewSeesWhatTheViewSaw) {
  // 5-editor's bar: VRP, VPN, VUP within 1e-6; looking straight up and down as well.
  const std::vector<std::string> views = {"set-free-view 0.3 0.1 -0.2 0.3 -0.2 0.5 0.1 1 0 30",
                                          "set-free-view -0.9 0.9 0.9 0 -1 0 1 0 1 5",
                                          "set-free-view 0 0 0 0 1 0 0.3 0 -1 100",
                                          "set-free-view 0.1 0 0 1e-8 -1 0 0 0 1 12",
                                          "set-free-view 0 0 0.5 1e-7 -1 1e-9 0 0 1 12",
                                          "set-free-view 1 1 1 -1 -1 -1 0 -1 0 1"};
  for (const char* mode : {"absolute", "relative"}) {
    for (const std::string& view : views) {
      for (const std::size_t at : {0u, 1u}) {
        Session session;
        run(session, std::string("set-aim-mode ") + mode);
        run(session, "select-key " + std::to_string(at));
        run(session, view);
        const Camera camera = session.camera();
        run(session, "new-key-from-view");
        EXPECT_EQ(session.current().key, at + 1);
        EXPECT_FALSE(session.freeCamera());
        const Camera found = session.evaluation().cameraAt(session.current());
        EXPECT_EQ(found.viewReferencePoint, camera.viewReferencePoint);
        EXPECT_NEAR(distance(found.viewPlaneNormal, camera.viewPlaneNormal), 0, 1e-6) << view;
        EXPECT_NEAR(distance(found.viewUpVector, camera.viewUpVector), 0, 1e-6) << view;
        EXPECT_EQ(found.zoom, camera.zoom);
        expectWritten(session, camera);
      }
    }
  }
}

TEST(CameraEdits, UseViewMovesTheKeyOnlyIfThePlaceChanged) {
  Session session;
  makeFive(session);
  run(session, "select-key 1 2");
  const Vec3 place = session.currentKey().position;
  run(session, "fly-turn 20 10");
  run(session, "fly-roll 15");
  run(session, "fly-zoom 5");
  const Camera camera = session.camera();
  run(session, "use-view");
  EXPECT_EQ(session.currentKey().position, place);
  const Camera found = session.evaluation().cameraAt({1, 2});
  EXPECT_NEAR(distance(found.viewPlaneNormal, camera.viewPlaneNormal), 0, 1e-12);
  EXPECT_NEAR(distance(found.viewUpVector, camera.viewUpVector), 0, 1e-9);
  run(session, "fly-move 0.1 0 0");
  run(session, "use-view");
  EXPECT_NEAR(distance(session.currentKey().position, place), 0.1, 1e-12);
  EXPECT_EQ(session.history().undoStep().name, Text("step.use-view", {2}));
}

TEST(CameraEdits, OutsideTheCubeTheSpaceCanBeEnlarged) {
  Session session;
  makeFive(session);
  run(session, "select-key 2");
  run(session, "set-free-view 1.5 0.2 0 -1 0 0 0 1 0 20");
  const Flight before = session.flight();
  const std::size_t steps = session.history().steps();
  EXPECT_FALSE(session.execute("new-key-from-view"));
  EXPECT_EQ(session.output().text.key, "refusal.outside-cube");
  ASSERT_TRUE(session.question());
  EXPECT_EQ(session.question()->kind, Question::Kind::kOutsideCube);
  EXPECT_FALSE(session.execute("set-zoom 3"));  // first the answer
  run(session, "answer enlarge");
  EXPECT_EQ(session.history().steps(), steps + 1);
  const Flight& after = session.flight();
  EXPECT_EQ(after.keys.size(), before.keys.size() + 1);
  EXPECT_NEAR(distance(after.space.toWorld(session.currentKey().position), {1.5, 0.2, 0}), 0,
              1e-12);
  EXPECT_NEAR(distance(after.space.toWorld(after.keys[1].position), before.keys[1].position), 0,
              1e-12);
  run(session, "undo");
  EXPECT_EQ(session.flight(), before);
  run(session, "set-free-view 1.5 0.2 0 -1 0 0 0 1 0 20");
  EXPECT_FALSE(session.execute("use-view"));
  run(session, "answer cancel");
  EXPECT_FALSE(session.question());
  EXPECT_EQ(session.flight(), before);
  EXPECT_TRUE(session.freeCamera());
}

TEST(CameraEdits, ADividedDurationIsSplitByDistance) {
  Session session;  // keys at x = -0.5 and 0.5
  run(session, "set-duration 4");
  run(session, "set-free-view -0.25 0.2 0.8 0 0 -1 0 1 0 12");
  run(session, "new-key-from-view");
  EXPECT_DOUBLE_EQ(*session.flight().keys[0].orientations[0].duration, 1.0);
  EXPECT_DOUBLE_EQ(*session.flight().keys[1].orientations[0].duration, 3.0);
}

}  // namespace
}  // namespace vides
