// SPDX-License-Identifier: MIT
// The session: one path for every change, undo and redo, current and selection, gestures.
#include "edit/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "edit/command_table.hpp"
#include "edit/edit_fixture.hpp"

namespace vides {
namespace {

TEST(Session, BeginsWithNew) {
  const Session session;
  EXPECT_EQ(session.flight(), newFlight());
  EXPECT_FALSE(session.modified());
  EXPECT_FALSE(session.undoName());
  EXPECT_EQ(session.output().kind, MessageKind::kNumbers);
}

TEST(Session, EditIsAStepThatCanBeTakenBack) {
  Session session;
  run(session, "move-key 1 0.1 0.2 0.3");
  EXPECT_EQ(session.flight().keys[1].position, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(session.evaluation().flight(), session.flight());
  EXPECT_TRUE(session.modified());
  EXPECT_EQ(session.undoName(), Text("menu.undo", {Text("step.move-key", {2})}));
  run(session, "undo");
  EXPECT_EQ(session.flight(), newFlight());
  EXPECT_FALSE(session.modified());
  EXPECT_EQ(session.redoName(), Text("menu.redo", {Text("step.move-key", {2})}));
  run(session, "redo");
  EXPECT_EQ(session.flight().keys[1].position, Vec3(0.1, 0.2, 0.3));
  refused(session, "redo", "refusal.not-available");
}

TEST(Session, RefusalChangesNothingAndIsTold) {
  Session session;
  refused(session, "move-key 0 1.5 0 0", "refusal.at");
  EXPECT_EQ(session.output().kind, MessageKind::kRefusal);
  refused(session, "move-key 7 0 0 0", "refusal.no-such-key");
  refused(session, "set-zoom 0.5", "refusal.at");
  refused(session, "set-rates 1e6 100 100 1e7", "refusal.problem");
  refused(session, "set-aim -0.5 0.2 0.8", "refusal.at");  // on the key
  refused(session, "undo", "refusal.not-available");
  // Told until something else is done.
  run(session, "next-key");
  EXPECT_EQ(session.output().kind, MessageKind::kNumbers);
}

TEST(Session, TooManyFramesAreRefused) {
  Session session;
  for (int i = 0; i < 9; ++i) run(session, "insert-orientation");
  run(session, "insert-keys 2");
  run(session, "set-frame-rate 1000");
  // Each hold has 86,400,000 frames: 23 of them fit into 2,000,000,000.
  int held = 0;
  while (held < 30 && session.execute("set-hold 86400")) {
    ++held;
    run(session, held % 10 == 0 ? "previous-key" : "next-orientation");
  }
  EXPECT_EQ(held, 23);
  EXPECT_EQ(session.output().text.key, "refusal.too-many-frames");
  EXPECT_LE(session.evaluation().frameCount(), 2'000'000'000);
  EXPECT_EQ(session.currentOrientation().hold, 0.0);
}

TEST(Session, WhatChangesNothingIsNoStep) {
  Session session;
  run(session, "move-key 0 -0.5 0.2 0.8");
  run(session, "set-zoom 12");
  run(session, "set-name \"\"");
  run(session, "clear-duration");
  EXPECT_FALSE(session.undoName());
  EXPECT_FALSE(session.modified());
}

TEST(Session, UndoBringsBackCurrentAndSelectionButTheyAreNoStep) {
  Session session;
  makeFive(session);
  run(session, "select-keys 1 3");
  run(session, "make-current 3");
  const Marks before = session.state().marks;
  const std::size_t steps = session.history().steps();
  run(session, "delete-keys");
  EXPECT_EQ(session.flight().keys.size(), 3u);
  EXPECT_EQ(session.current().key, 1u);  // 2, the predecessor, counted without the deleted 1
  EXPECT_EQ(session.selected().size(), 1u);
  run(session, "select-key 0");
  run(session, "select-all");
  EXPECT_EQ(session.history().steps(), steps + 1);
  run(session, "undo");
  EXPECT_EQ(session.state().marks, before);
  run(session, "redo");
  EXPECT_EQ(session.current().key, 1u);
}

TEST(Session, ANewStepForgetsWhatCouldBeRedone) {
  Session session;
  run(session, "set-zoom 20");
  run(session, "undo");
  run(session, "set-zoom 30");
  EXPECT_FALSE(session.redoName());
  run(session, "undo");
  EXPECT_EQ(session.flight(), newFlight());
}

TEST(Session, HistoryIsLimitedByWhatStepsDoNotShare) {
  SessionSeams seams;
  seams.historyBytes = 200'000;
  Session session(std::move(seams));
  for (int i = 0; i < 2000; ++i) run(session, "set-zoom " + std::to_string(1 + i % 99));
  EXPECT_LE(session.history().bytes(), 200'000u);
  EXPECT_GT(session.history().steps(), 10u);
  EXPECT_LT(session.history().steps(), 2000u);
  // One edit in a large flight costs little: what it shares isn't counted.
  Session large;
  for (int i = 0; i < 100; ++i) run(large, "insert-keys 10");
  const std::size_t before = large.history().bytes();
  run(large, "move-key 500 0.1 0.1 0.1");
  EXPECT_LT(large.history().bytes() - before, 20'000u);
}

TEST(Session, GestureIsOneStep) {
  Session session;
  session.begin(Text("step.move-key", {1}));
  for (int i = 1; i <= 20; ++i) {
    Key key = session.start().key();
    key.position.x += 0.01 * i;
    ASSERT_TRUE(session.preview(withKey(session.start().flight, 0, key)));
    EXPECT_EQ(session.evaluation().frame(0).camera.viewReferencePoint, key.position);
  }
  refused(session, "set-zoom 3", "refusal.in-gesture");
  EXPECT_FALSE(session.undoName());
  session.commit();
  EXPECT_EQ(session.history().steps(), 1u);
  run(session, "undo");
  EXPECT_EQ(session.flight(), newFlight());
}

TEST(Session, EscapePutsEverythingBack) {
  Session session;
  makeFive(session);
  const Flight before = session.flight();
  const std::string bytes = writeVid(before);
  const std::size_t steps = session.history().steps();
  session.begin("step.set-zoom");
  ASSERT_TRUE(session.preview(Command("set-zoom", 80)));
  ASSERT_NE(session.flight(), before);
  run(session, "escape");
  EXPECT_FALSE(session.inGesture());
  EXPECT_EQ(session.flight(), before);
  EXPECT_EQ(writeVid(session.flight()), bytes);
  EXPECT_EQ(session.evaluation().flight(), before);
  EXPECT_EQ(session.history().steps(), steps);
}

TEST(Session, AGestureThatEndsWhereItBeganIsNoStep) {
  Session session;
  session.begin("step.set-zoom");
  session.preview(Command("set-zoom", 80));
  session.preview(Command("set-zoom", 12));
  session.commit();
  EXPECT_FALSE(session.undoName());
  EXPECT_FALSE(session.modified());
}

TEST(Session, AnInvalidPreviewKeepsTheLastValidOne) {
  Session session;
  session.begin("step.set-zoom");
  EXPECT_TRUE(session.preview(Command("set-zoom", 80)));
  EXPECT_FALSE(session.preview(Command("set-zoom", 180)));
  EXPECT_EQ(session.currentOrientation().zoom, 80);
  EXPECT_EQ(session.output().kind, MessageKind::kRefusal);
  session.commit();
  EXPECT_EQ(session.currentOrientation().zoom, 80);
}

TEST(Session, AWindowsGestureGivesWayToOtherEdits) {
  Session session;
  session.beginWindow("step.set-shape");
  session.preview(Command("set-tension", 0.5));
  session.preview(Command("set-bias", -0.5));
  run(session, "set-zoom 40");  // ends the window's step, then makes its own
  EXPECT_EQ(session.history().steps(), 2u);
  EXPECT_TRUE(session.inGesture());
  session.preview(Command("set-continuity", 0.25));
  session.begin("step.move-key");  // so does a drag
  session.preview(Command("move-key", 0, 0.1, 0.0, 0.0));
  session.commit();
  EXPECT_EQ(session.history().steps(), 4u);
  session.preview(Command("set-tension", 1));
  session.cancel();  // only what came after
  EXPECT_FALSE(session.inGesture());
  EXPECT_EQ(session.currentKey().shape.own, (Shape{0.5, 0.25, -0.5}));
  for (int i = 0; i < 4; ++i) run(session, "undo");
  EXPECT_EQ(session.flight(), newFlight());
}

TEST(Session, MakingCurrentMovesThePlayheadScrubbingDoesNotMakeCurrent) {
  Session session;
  makeFive(session);
  run(session, "select-key 2");
  EXPECT_EQ(session.frame(), session.evaluation().frameOf({2, 0}));
  run(session, "go-to-frame 3");
  EXPECT_EQ(session.frame(), 3);
  EXPECT_EQ(session.current().key, 2u);
  run(session, "go-to-frame 999999");
  EXPECT_EQ(session.frame(), session.evaluation().frameCount() - 1);
  // While the playhead stands on the current orientation it stays there in every edit.
  run(session, "select-key 4");
  run(session, "move-key 1 0.9 0.9 0.9");
  EXPECT_EQ(session.frame(), session.evaluation().frameOf({4, 0}));
}

TEST(Session, StepsWrapOverKeysAndOrientations) {
  Session session;
  makeFive(session);
  run(session, "select-key 4");
  run(session, "next-key");
  EXPECT_EQ(session.current(), (OrientationPlace{0, 0}));
  run(session, "previous-key");
  EXPECT_EQ(session.current().key, 4u);
  run(session, "select-key 1 2");
  run(session, "next-orientation");
  EXPECT_EQ(session.current(), (OrientationPlace{1, 0}));
  run(session, "previous-orientation");
  EXPECT_EQ(session.current(), (OrientationPlace{1, 2}));
}

TEST(Session, ThePlayheadGoesFromOrientationToOrientation) {
  Session session;
  makeFive(session);
  run(session, "first-frame");
  std::vector<std::int64_t> forward{0};
  for (int i = 0; i < 20; ++i) {
    run(session, "go-to-next-orientation");
    if (session.frame() != forward.back()) forward.push_back(session.frame());
  }
  EXPECT_EQ(forward.back(), session.evaluation().frameCount() - 1);
  // Two of the second key's orientations see the same: no frames lie between them.
  EXPECT_EQ(forward.size(), 7u);
  for (std::size_t i = forward.size(); i-- > 1;) {
    EXPECT_EQ(session.frame(), forward[i]);
    run(session, "go-to-previous-orientation");
  }
  EXPECT_EQ(session.frame(), 0);
}

TEST(Session, ToggledSelectionAlwaysHoldsTheCurrentKey) {
  Session session;
  makeFive(session);
  run(session, "select-key 2");
  run(session, "toggle-select 4");
  run(session, "toggle-select 0");
  EXPECT_THAT(session.selected().keys(), testing::ElementsAre(0, 2, 4));
  run(session, "toggle-select 2");
  EXPECT_EQ(session.current().key, 0u);
  EXPECT_THAT(session.selected().keys(), testing::ElementsAre(0, 4));
  run(session, "toggle-select 4");
  run(session, "toggle-select 0");  // the last one stays
  EXPECT_THAT(session.selected().keys(), testing::ElementsAre(0));
  refused(session, "select-keys 1 9", "refusal.no-such-key");
}

TEST(Session, ViewCommandsAreNoSteps) {
  Session session;
  run(session, "view top");
  EXPECT_EQ(session.view().view.tilt, 90.0);
  run(session, "set-view 10 20 30 0.1 0.2 0.3");
  EXPECT_EQ(session.view().view.size, kMaxViewSize);
  EXPECT_EQ(session.view().view.target, Vec3(0.1, 0.2, 0.3));
  run(session, "perspective on");
  EXPECT_EQ(session.view().view.type, ProjectionType::Perspective);
  run(session, "frame-all");
  run(session, "swap-views");
  EXPECT_TRUE(session.view().swapped);
  EXPECT_FALSE(session.undoName());
  EXPECT_FALSE(session.modified());
}

TEST(Session, ThroughTheCameraUntilANamedView) {
  Session session;
  const EditorView before = session.view().view;
  run(session, "view-camera");
  EXPECT_TRUE(session.view().swapped);
  EXPECT_EQ(session.view().view, before);  // the viewport looks as it did, at the small place
  run(session, "view-camera");
  EXPECT_FALSE(session.view().swapped);
  // Asked for, not switched.
  run(session, "view camera");
  run(session, "view camera");
  EXPECT_TRUE(session.view().swapped);
  // What turns, sizes and frames the small viewport leaves it there.
  for (const char* line : {"perspective on", "set-turn 20", "set-tilt 20", "set-size 2",
                           "frame-all", "frame-selection", "set-view 10 20 1"}) {
    run(session, line);
    EXPECT_TRUE(session.view().swapped) << line;
  }
  for (const char* line : {"view front", "view side", "view top", "view iso", "view-opposite"}) {
    run(session, "view camera");
    run(session, line);
    EXPECT_FALSE(session.view().swapped) << line;
  }
  // Who has swapped the places for good keeps that, until the camera's key is pressed.
  run(session, "swap-views");
  run(session, "view front");
  run(session, "view camera");
  run(session, "view side");
  EXPECT_TRUE(session.view().swapped);
  run(session, "view-camera");
  EXPECT_FALSE(session.view().swapped);
  run(session, "view-camera");
  run(session, "swap-views");
  EXPECT_FALSE(session.view().swapped);
  run(session, "swap-views");
  run(session, "view front");
  EXPECT_TRUE(session.view().swapped);
}

TEST(Session, EscapeClosesOneThingAtATime) {
  Session session;
  run(session, "show-window flight");
  run(session, "show-window shortcuts");
  run(session, "fly-move 0.1 0 0");
  run(session, "escape");
  EXPECT_FALSE(session.freeCamera());
  run(session, "escape");
  EXPECT_THAT(session.windows(), testing::ElementsAre("flight"));
  run(session, "escape");
  EXPECT_TRUE(session.windows().empty());
}

// Every command of the table that edits and can be run on this flight: done and taken back, the
// flight is equal; whatever else a command does, it leaves flight and history alone.
TEST(Session, EveryCommandIsTakenBackWhole) {
  const std::vector<std::string> lines = {"insert-key",
                                          "insert-keys 4",
                                          "insert-key-at 1 0.3",
                                          "append-key",
                                          "delete-keys",
                                          "duplicate-keys",
                                          "move-key 3 0.1 0.2 0.3",
                                          "set-coordinate y 0.15",
                                          "move-keys 0.1 0 -0.2",
                                          "set-preset 4",
                                          "set-shape 0.1 0.2 0.3",
                                          "set-tension 0.4",
                                          "set-continuity -0.4",
                                          "set-bias 1",
                                          "set-preset-shape 0 0.5 0.5 0.5",
                                          "insert-orientation",
                                          "delete-orientation",
                                          "set-aim 0 0 0.9",
                                          "set-aim-coordinate z +=0.15",
                                          "move-aims 0.1 0.1 0.1",
                                          "set-aim-mode relative",
                                          "set-roll -700",
                                          "set-zoom 99",
                                          "set-focal-length 50",
                                          "set-field-of-view 40",
                                          "set-speed 1 2 3 4 5 6 7 8 9 100",
                                          "set-speed-value 3 77",
                                          "ease in-out-sine",
                                          "set-duration 3.5",
                                          "set-duration-frames 12",
                                          "set-hold 2",
                                          "set-name \"A name\"",
                                          "set-frame-rate 24",
                                          "set-picture 640 480",
                                          "set-lens 24 10 100",
                                          "set-rates 1 2 3 4",
                                          "set-closed on",
                                          "set-orientation-curve slerp",
                                          "set-space 0.1 0 0 3",
                                          "add-scene pyramid.obj",
                                          "add-scene pyramid.obj 0 0 0 4 2 1",
                                          "cut",
                                          "use-view",
                                          "new-key-from-view",
                                          "match-speed after"};
  std::set<std::string> tried;
  Session session;
  makeFive(session);
  run(session, "select-key 1 2");
  run(session, "set-speed 20 20 20 20 20 20 20 20 20 20");
  run(session, "set-free-view 0.1 0.2 0.3 1 0 0 0 1 0 40");
  const Flight before = session.flight();
  const std::string bytes = writeVid(before);
  for (const std::string& line : lines) {
    // A view that was used is no free view any more.
    run(session, "set-free-view 0.1 0.2 0.3 1 0 0 0 1 0 40");
    run(session, line);
    EXPECT_NE(session.flight(), before) << line;
    const std::string after = writeVid(session.flight());
    run(session, "undo");
    EXPECT_EQ(session.flight(), before) << line;
    EXPECT_EQ(writeVid(session.flight()), bytes) << line;
    run(session, "redo");
    EXPECT_EQ(writeVid(session.flight()), after) << line;
    run(session, "undo");
    run(session, "set-free-view 0.1 0.2 0.3 1 0 0 0 1 0 40");
    tried.insert(line.substr(0, line.find(' ')));
  }
  // Those that need something first.
  const std::set<std::string> elsewhere = {"clear-duration", "remove-scene", "show-scene"};
  for (const CommandSpecification& command : commandTable()) {
    EXPECT_TRUE(!command.edits() || tried.contains(command.name) ||
                elsewhere.contains(command.name))
        << command.name;
  }
  run(session, "set-duration 2");
  run(session, "clear-duration");
  run(session, "add-scene a.obj");
  run(session, "show-scene 0 off");
  run(session, "remove-scene 0");
  for (int i = 0; i < 5; ++i) run(session, "undo");
  EXPECT_EQ(session.flight(), before);
}

}  // namespace
}  // namespace vides
