// SPDX-License-Identifier: MIT
// The shape window: what its preview shows, what Show, OK and Cancel do, and what other edits in
// the meantime leave of it.
#include <gtest/gtest.h>

#include <algorithm>

#include "edit/edit_fixture.hpp"
#include "edit/shape_picture.hpp"

namespace vides {
namespace {

// Five keys, the third current; presets 2, 2, 2, 0, 0.
void begin(Session& session) {
  makeFive(session);
  for (const int key : {0, 1, 2}) {
    run(session, "select-key " + std::to_string(key));
    run(session, "set-preset 2");
  }
  run(session, "show-window shape");
}

TEST(ShapeWindow, WhatIsTriedForAPresetIsSeenAtTheCurrentKeyOnly) {
  Session session;
  begin(session);
  const Flight before = session.flight();
  EXPECT_EQ(session.chosenPreset(), 2);
  EXPECT_FALSE(session.triesPreset());
  run(session, "shape-set tension -0.25");
  EXPECT_TRUE(session.triesPreset());
  EXPECT_EQ(session.chosenPreset(), 2);
  EXPECT_EQ(shapeOf(session.flight(), session.currentKey()), (Shape{-0.25, 0, 0}));
  EXPECT_EQ(session.flight().presets, before.presets);
  EXPECT_EQ(session.flight().keys[1], before.keys[1]);
  EXPECT_EQ(session.evaluation().flight(), session.flight());
  // Moved back, it is the preset again.
  run(session, "shape-set tension 0.6");
  EXPECT_FALSE(session.triesPreset());
  EXPECT_EQ(session.flight(), before);
}

TEST(ShapeWindow, ShowGivesItToEveryKeyWithThePreset) {
  Session session;
  begin(session);
  run(session, "shape-set tension -0.25");
  run(session, "shape-set bias 0.5");
  run(session, "shape-show");
  EXPECT_EQ(session.output().text, Text("output.preset-shown", {3, 2}));
  EXPECT_EQ(session.flight().presets[2], (Shape{-0.25, 0, 0.5}));
  for (const std::size_t key : {0, 1, 2}) {
    EXPECT_EQ(session.flight().keys[key].shape.preset, 2);
    EXPECT_EQ(shapeOf(session.flight(), session.flight().keys[key]), (Shape{-0.25, 0, 0.5}));
  }
  EXPECT_FALSE(session.triesPreset());
}

TEST(ShapeWindow, OkIsOneStep) {
  Session session;
  begin(session);
  const Flight before = session.flight();
  const std::size_t steps = session.history().steps();
  run(session, "shape-set tension -0.25");
  run(session, "shape-show");
  run(session, "shape-set continuity 0.5");
  session.preview(Command("move-key", 2, 0.2, 0.3, 0.4));
  session.preview(Command("set-roll", 12));
  run(session, "shape-ok");
  EXPECT_FALSE(session.windowOpen("shape"));
  EXPECT_FALSE(session.inGesture());
  EXPECT_EQ(session.flight().presets[2], (Shape{-0.25, 0.5, 0}));
  EXPECT_EQ(session.flight().keys[2].shape.preset, 2);
  EXPECT_EQ(session.flight().keys[2].position, Vec3(0.2, 0.3, 0.4));
  EXPECT_EQ(session.history().steps(), steps + 1);
  EXPECT_EQ(session.undoName(), Text("menu.undo", {Text("step.set-shape", {3})}));
  run(session, "undo");
  EXPECT_EQ(session.flight(), before);
  // Without a change there is no step.
  run(session, "show-window shape");
  run(session, "shape-ok");
  EXPECT_EQ(session.flight(), before);
  EXPECT_TRUE(session.redoName());
}

TEST(ShapeWindow, CancelTakesBackWhatShowApplied) {
  for (const char* how : {"shape-cancel", "escape", "close-window shape", "close-window"}) {
    Session session;
    begin(session);
    const Flight before = session.flight();
    const std::string bytes = writeVid(before);
    const std::size_t steps = session.history().steps();
    run(session, "shape-set tension -0.25");
    run(session, "shape-show");
    run(session, "shape-choose 4");
    run(session, "shape-choose own");
    run(session, "shape-set bias 1");
    run(session, how);
    EXPECT_FALSE(session.windowOpen("shape")) << how;
    EXPECT_FALSE(session.inGesture()) << how;
    EXPECT_EQ(session.flight(), before) << how;
    EXPECT_EQ(writeVid(session.flight()), bytes) << how;
    EXPECT_EQ(session.history().steps(), steps) << how;
  }
}

TEST(ShapeWindow, OwnKeepsTheShapeThatIsSeen) {
  Session session;
  begin(session);
  run(session, "shape-set tension 0.1");
  run(session, "shape-choose own");
  EXPECT_EQ(session.chosenPreset(), KeyShape::kOwn);
  EXPECT_EQ(session.currentKey().shape.own, (Shape{0.1, 0, 0}));
  run(session, "shape-ok");
  EXPECT_EQ(session.flight().presets, newFlight().presets);
  EXPECT_EQ(session.currentKey().shape.preset, KeyShape::kOwn);
}

TEST(ShapeWindow, AnotherEditEndsTheStepAsItIsSeen) {
  Session session;
  begin(session);
  const std::size_t steps = session.history().steps();
  run(session, "shape-set tension -0.25");
  session.begin("step.move-key");  // a drag in the viewport
  session.preview(Command("move-key", 4, 0.5, 0.5, 0.5));
  refused(session, "shape-set tension 1", "refusal.in-gesture");
  session.commit();
  EXPECT_EQ(session.history().steps(), steps + 2);
  // Nobody else's shape has changed; the window goes on.
  EXPECT_TRUE(session.inWindow());
  EXPECT_EQ(session.flight().presets, newFlight().presets);
  EXPECT_EQ(session.chosenPreset(), KeyShape::kOwn);
  EXPECT_EQ(session.currentKey().shape.own, (Shape{-0.25, 0, 0}));
}

// The window lies beside everything else: what it is asked to take back may have become steps.
TEST(ShapeWindow, CancelGoesBackToTheOpeningPastOtherEdits) {
  Session session;
  begin(session);
  const Flight opening = session.flight();
  const std::size_t steps = session.history().steps();
  run(session, "shape-set tension -0.25");
  run(session, "shape-show");
  run(session, "set-zoom 44");
  run(session, "shape-set tension 1");
  run(session, "move-key 4 0.5 0.5 0.5");
  const Flight edited = session.flight();
  EXPECT_NE(edited, opening);
  run(session, "shape-cancel");
  EXPECT_EQ(session.flight(), opening);
  EXPECT_EQ(session.output().text, Text("output.shape-cancelled"));
  // As a step: nothing is lost.
  EXPECT_EQ(session.history().steps(), steps + 5);
  EXPECT_EQ(session.undoName(), Text("menu.undo", {Text("step.cancel-shape")}));
  run(session, "undo");
  EXPECT_EQ(session.flight(), edited);
}

// OK keeps it, and a window that has changed nothing takes nothing back.
TEST(ShapeWindow, OnlyItsOwnChangesAreTakenBack) {
  Session session;
  begin(session);
  run(session, "set-zoom 44");
  const Flight zoomed = session.flight();
  run(session, "shape-set tension -0.25");
  run(session, "shape-cancel");
  EXPECT_EQ(session.flight(), zoomed);
  run(session, "show-window shape");
  run(session, "shape-set tension -0.25");
  run(session, "set-zoom 45");
  run(session, "shape-ok");
  const Flight kept = session.flight();
  run(session, "show-window shape");
  run(session, "shape-cancel");
  EXPECT_EQ(session.flight(), kept);
}

TEST(ShapeWindow, UndoTakesBackWhatThePreviewShows) {
  Session session;
  begin(session);
  const Flight before = session.flight();
  run(session, "shape-set tension -0.25");
  EXPECT_EQ(session.undoName(), Text("menu.undo", {Text("step.set-shape", {3})}));
  run(session, "undo");
  EXPECT_EQ(session.flight(), before);
  EXPECT_EQ(session.chosenPreset(), 2);
  EXPECT_TRUE(session.inWindow());
  run(session, "redo");
  EXPECT_EQ(session.currentKey().shape.own, (Shape{-0.25, 0, 0}));
  run(session, "undo");
  // What the preview has changed ends what could be redone.
  run(session, "shape-set bias 1");
  refused(session, "redo", "refusal.not-available");
  EXPECT_TRUE(session.inWindow());
  run(session, "undo");
  EXPECT_EQ(session.flight(), before);
  run(session, "undo");
  EXPECT_NE(session.flight(), before);
}

TEST(ShapeWindow, UndoWorksWithTheFirstStep) {
  Session session;
  run(session, "show-window shape");
  EXPECT_FALSE(session.undoName());
  run(session, "shape-set tension 0.5");
  run(session, "undo");
  EXPECT_EQ(session.flight(), newFlight());
}

TEST(ShapeWindow, SeveralKeysAreOneStepAndOneCancel) {
  Session session;
  begin(session);
  const Flight before = session.flight();
  const std::size_t steps = session.history().steps();
  run(session, "shape-set tension -0.25");
  run(session, "make-current 4");
  EXPECT_EQ(session.chosenPreset(), 0);
  run(session, "shape-set bias 0.5");
  run(session, "shape-cancel");
  EXPECT_EQ(session.flight(), before);
  EXPECT_EQ(session.current().key, 2u);
  run(session, "show-window shape");
  run(session, "shape-set tension -0.25");
  run(session, "make-current 4");
  run(session, "shape-set bias 0.5");
  run(session, "shape-ok");
  EXPECT_EQ(session.history().steps(), steps + 1);
  EXPECT_EQ(session.undoName(), Text("menu.undo", {Text("step.set-shape", {3})}));
  EXPECT_EQ(session.flight().keys[2].shape.own, (Shape{-0.25, 0, 0}));
  EXPECT_EQ(session.flight().presets[0], (Shape{0, 0, 0.5}));
  // Without a change Cancel leaves the user where he went.
  run(session, "show-window shape");
  run(session, "make-current 1");
  run(session, "shape-cancel");
  EXPECT_EQ(session.current().key, 1u);
}

TEST(ShapeWindow, TheStepIsNamedAfterWhatHasChanged) {
  Session session;
  begin(session);
  run(session, "shape-set tension -0.25");
  run(session, "make-current 4");
  EXPECT_EQ(session.undoName(), Text("menu.undo", {Text("step.set-shape", {3})}));
  run(session, "shape-cancel");
  run(session, "show-window shape");
  run(session, "shape-set tension -0.25");
  run(session, "shape-ok");
  EXPECT_EQ(session.undoName(), Text("menu.undo", {Text("step.set-preset-shape", {2})}));
}

TEST(ShapeWindow, ARefusedValueChangesNothing) {
  Session session;
  begin(session);
  const Flight before = session.flight();
  refused(session, "shape-set tension 1.5", "refusal.at");
  EXPECT_EQ(session.flight(), before);
  EXPECT_FALSE(session.triesPreset());
}

TEST(ShapeWindow, ANewFlightClosesIt) {
  Session session;
  begin(session);
  run(session, "shape-set tension -0.25");
  run(session, "new");
  ASSERT_TRUE(session.question());
  EXPECT_TRUE(session.modified());
  run(session, "answer cancel");
  EXPECT_TRUE(session.inWindow());
  run(session, "new");
  run(session, "answer discard");
  EXPECT_FALSE(session.windowOpen("shape"));
  EXPECT_FALSE(session.inGesture());
  EXPECT_EQ(session.flight(), newFlight());
}

TEST(ShapeWindow, ItsCommandsNeedIt) {
  Session session;
  for (const char* line : {"shape-choose 3", "shape-set bias 1", "shape-show", "shape-ok"}) {
    refused(session, line, "refusal.not-available");
  }
  // A drag ends before it can be opened.
  session.begin("step.set-zoom");
  refused(session, "show-window shape", "refusal.in-gesture");
  session.preview(Command("set-zoom", 30));
  session.commit();
  run(session, "show-window shape");
  EXPECT_TRUE(session.inWindow());
  run(session, "shape-set bias 1");
  run(session, "shape-cancel");
  EXPECT_EQ(session.currentOrientation().zoom, 30);
  EXPECT_EQ(session.history().steps(), 1u);
}

// The picture on a preset's button: through the key, straight for full tension, with the tangents
// of the paper's formulas.
TEST(ShapePicture, ShowsWhatTheShapeDoes) {
  const ShapePicture straight = shapePicture({1, 0, 0}, 8);
  ASSERT_EQ(straight.line.size(), 17u);
  EXPECT_LT(glm::distance(straight.line[8], straight.key), 1e-12);
  const Vec2 way = straight.key - straight.line.front();
  for (std::size_t i = 1; i < 8; ++i) {
    const Vec2 p = straight.line[i] - straight.line.front();
    EXPECT_NEAR(way.x * p.y - way.y * p.x, 0.0, 1e-9) << i;
  }
  // Negative tension bulges, bias overshoots: they reach higher (y is down) and further.
  const auto highest = [](const Shape& shape) {
    double least = 1.0;
    for (const Vec2& p : shapePicture(shape, 40).line) least = std::min(least, p.y);
    return least;
  };
  EXPECT_LT(highest({-0.6, 0, 0}), highest({0, 0, 0}));
  EXPECT_LT(highest({0, 0, 0.5}), highest({0, 0, 0}));
  EXPECT_LE(highest({0, 0, 0}), straight.key.y);
}

}  // namespace
}  // namespace vides
