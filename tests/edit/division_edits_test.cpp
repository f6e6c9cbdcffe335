// SPDX-License-Identifier: MIT
// Inserting at the playhead and at a place of the curve, as commands (5-editor: shortcuts,
// viewport, camera view).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "edit/edit_fixture.hpp"
#include "edit/shortcuts.hpp"

namespace vides {
namespace {

TEST(InsertAtPlayhead, ThePlayheadStaysAndOneStepTakesItBack) {
  Session session;
  run(session, "go-to-frame 30");
  const Flight before = session.flight();
  run(session, "insert-at-playhead");
  EXPECT_EQ(session.flight().keys.size(), 3u);
  EXPECT_EQ(session.frame(), 30);
  EXPECT_EQ(session.current(), (OrientationPlace{1, 0}));
  EXPECT_EQ(session.evaluation().frameOf({1, 0}), 30);
  EXPECT_EQ(session.evaluation().frameCount(), 101);
  EXPECT_EQ(session.history().steps(), 1u);
  EXPECT_EQ(session.history().undoStep().name, Text("step.insert-key", {2}));
  const Flight after = session.flight();
  run(session, "undo");
  EXPECT_EQ(session.flight(), before);
  EXPECT_EQ(session.frame(), 30);
  EXPECT_EQ(session.current(), (OrientationPlace{0, 0}));
  run(session, "redo");
  EXPECT_EQ(session.flight(), after);
  EXPECT_EQ(session.frame(), 30);
  // Again at once: there is a key now.
  refused(session, "insert-at-playhead", "refusal.section-begins");
}

TEST(InsertAtPlayhead, IsRefusedWithTheReason) {
  Session session;
  refused(session, "insert-at-playhead", "refusal.section-begins");
  run(session, "last-frame");
  refused(session, "insert-at-playhead", "refusal.flight-ends");
  refused(session, "insert-key-at 0 0", "refusal.key-is-there");
  refused(session, "insert-key-at 0 1", "refusal.key-is-there");
  refused(session, "insert-key-at 0 1.5", "refusal.fraction");
  refused(session, "insert-key-at 1 0.5", "refusal.after-last-key");
  refused(session, "insert-key-at 2 0.5", "refusal.no-such-key");
  run(session, "set-duration-frames 1");
  refused(session, "insert-key-at 0 0.5", "refusal.one-frame");
  run(session, "set-duration-frames 10");
  run(session, "go-to-frame 5");
  session.begin("step.move-key");
  refused(session, "insert-at-playhead", "refusal.in-gesture");
  session.cancel();
  run(session, "insert-at-playhead");
}

TEST(InsertAtPlayhead, InATurnAddsAnOrientationUpToTen) {
  Session session;
  run(session, "insert-orientation");
  run(session, "set-zoom 90");
  for (std::size_t count = 3; count <= 10; ++count) {
    run(session, "go-to-frame " + std::to_string(2 * count));
    run(session, "insert-at-playhead");
    EXPECT_EQ(session.flight().keys[0].orientations.size(), count);
    EXPECT_EQ(session.current().orientation, count - 2);
    EXPECT_EQ(session.history().undoStep().name, Text("step.insert-orientation", {1}));
  }
  run(session, "go-to-frame 50");
  refused(session, "insert-at-playhead", "refusal.ten-orientations");
}

TEST(InsertAtPlayhead, WithTheShapeWindowOpenItIsAStepOfItsOwn) {
  Session session;
  run(session, "show-window shape");
  run(session, "shape-set tension 0.5");
  run(session, "go-to-frame 40");
  run(session, "insert-at-playhead");
  EXPECT_EQ(session.history().steps(), 2u);
  EXPECT_EQ(session.history().undoStep().name, Text("step.insert-key", {2}));
  run(session, "shape-cancel");
}

TEST(NewKey, WithoutAFreeViewDoesWhatInsertAtPlayheadDoes) {
  Session one, other;
  for (Session* session : {&one, &other}) {
    makeFive(*session);
    run(*session, "go-to-frame 77");
  }
  run(one, "insert-at-playhead");
  run(other, "new-key-from-view");
  EXPECT_EQ(writeVid(one.flight()), writeVid(other.flight()));
  refused(other, "new-key-from-view", "refusal.section-begins");
}

TEST(NewKey, FromAFreeViewComesAfterThePlayheadsSection) {
  Session session;
  makeFive(session);
  const std::string view = "set-free-view 0.1 0.2 0.3 1 0 0 0 1 0 40";
  run(session, "select-key 0");
  run(session, "go-to-frame " + std::to_string(session.evaluation().frameOf({3, 0}) + 3));
  run(session, view);
  run(session, "new-key-from-view");
  EXPECT_EQ(session.current(), (OrientationPlace{4, 0}));
  EXPECT_EQ(session.flight().keys[4].position, Vec3(0.1, 0.2, 0.3));
  run(session, "undo");
  // Inside a turn of the key, and at the end.
  run(session, "select-key 4");
  run(session, "go-to-frame " + std::to_string(session.evaluation().frameOf({1, 0}) + 2));
  run(session, view);
  run(session, "new-key-from-view");
  EXPECT_EQ(session.current(), (OrientationPlace{2, 0}));
  run(session, "undo");
  run(session, "select-key 0");
  run(session, "last-frame");
  run(session, view);
  run(session, "new-key-from-view");
  EXPECT_EQ(session.current(), (OrientationPlace{5, 0}));
  EXPECT_EQ(session.flight().keys.size(), 6u);
}

TEST(InsertAtPlayhead, OutsideTheCubeTheSpaceCanBeEnlarged) {
  for (const std::string command :
       {"insert-at-playhead", "new-key-from-view", "insert-key-at 1 0.5"}) {
    Session session;  // the curve through -1, 1, 1, -1 reaches 1.25
    run(session, "insert-keys 2");
    for (const char* line : {"move-key 0 -1 -0.5 0.5", "move-key 1 1 -0.2 0.5",
                             "move-key 2 1 0.2 0.5", "move-key 3 -1 0.5 0.5"}) {
      run(session, line);
    }
    const std::int64_t n =
        (session.evaluation().frameOf({1, 0}) + session.evaluation().frameOf({2, 0})) / 2;
    run(session, "go-to-frame " + std::to_string(n));
    const Flight before = session.flight();
    const std::int64_t frames = session.evaluation().frameCount();
    const Vec3 place = session.evaluation().frame(n).camera.viewReferencePoint;
    const std::size_t steps = session.history().steps();
    EXPECT_FALSE(session.execute(command));
    EXPECT_EQ(session.output().text.key, "refusal.curve-outside-cube");
    ASSERT_TRUE(session.question());
    EXPECT_EQ(session.question()->kind, Question::Kind::kOutsideCube);
    EXPECT_EQ(session.flight(), before);
    run(session, "answer enlarge");
    EXPECT_EQ(session.history().steps(), steps + 1);
    EXPECT_EQ(session.flight().keys.size(), 5u);
    EXPECT_EQ(session.current(), (OrientationPlace{2, 0}));
    EXPECT_EQ(session.evaluation().frameCount(), frames);
    EXPECT_NEAR(glm::length(session.flight().space.toWorld(session.currentKey().position) -
                            before.space.toWorld(place)),
                0.0, command == "insert-key-at 1 0.5" ? 0.1 : 1e-9);
    run(session, "undo");
    EXPECT_EQ(session.flight(), before);
    EXPECT_FALSE(session.execute(command));
    run(session, "answer cancel");
    EXPECT_EQ(session.flight(), before);
  }
}

TEST(InsertAtPlayhead, HasTheKeyAndPosPlusNone) {
  const Shortcut* shortcut = shortcutFor(KeyboardKey::kI, {}, false);
  ASSERT_NE(shortcut, nullptr);
  EXPECT_EQ(shortcut->command, Command("insert-at-playhead"));
  EXPECT_EQ(shortcutOf(Command("insert-key")), nullptr);
}

}  // namespace
}  // namespace vides
