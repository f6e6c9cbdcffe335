// SPDX-License-Identifier: MIT
// Values set in several keys at once; which orientation is each key's current one.
#include <gtest/gtest.h>

#include "edit/command_table.hpp"
#include "edit/key_values.hpp"
#include "edit_fixture.hpp"

namespace vides {
namespace {

double zoomOf(const Session& session, std::size_t key, std::size_t orientation) {
  return session.flight().keys[key].orientations[orientation].zoom;
}

TEST(SeveralKeys, EachHasTheOrientationThatWasCurrentLast) {
  Session session;
  makeFive(session);
  run(session, "select-key 1 2");
  run(session, "select-key 0");
  run(session, "select-all");
  run(session, "set-zoom 77");
  EXPECT_EQ(zoomOf(session, 1, 2), 77.0);
  EXPECT_EQ(zoomOf(session, 1, 0), 12.0);
  EXPECT_EQ(zoomOf(session, 4, 0), 77.0);
  EXPECT_EQ(session.undoName(), Text("menu.undo", {Text("step.set-zooms", {5})}));
  // Keys that come and go before it leave it with its key.
  run(session, "select-key 0");
  run(session, "insert-keys 3");
  run(session, "select-all");
  run(session, "set-roll 5");
  EXPECT_EQ(session.flight().keys[4].orientations[2].roll, 5.0);
  EXPECT_EQ(session.flight().keys[4].orientations[0].roll, 0.0);
  run(session, "undo");
  run(session, "undo");
  run(session, "select-all");
  run(session, "set-roll 6");
  EXPECT_EQ(session.flight().keys[1].orientations[2].roll, 6.0);
  // Stepped to, its first is the current one.
  run(session, "select-key 1");
  run(session, "select-all");
  run(session, "set-roll 7");
  EXPECT_EQ(session.flight().keys[1].orientations[0].roll, 7.0);
}

TEST(SeveralKeys, RefusedForOneIsRefusedForAll) {
  Session session;
  makeFive(session);
  run(session, "select-key 3");
  run(session, "set-zoom 60");
  run(session, "select-all");
  const Flight before = session.flight();
  EXPECT_FALSE(session.execute("set-zoom *2"));
  EXPECT_FALSE(session.execute("set-focal-length *3"));
  EXPECT_EQ(session.output().text.key, "refusal.focal-length");
  EXPECT_FALSE(session.execute("set-coordinate x +=1.5"));
  EXPECT_EQ(session.flight(), before);
}

TEST(SeveralKeys, TheLensEndsAreReached) {
  Session session;
  for (const char* line : {"set-focal-length 12", "set-field-of-view 112.6"}) {
    run(session, line);
    EXPECT_NEAR(zoomOf(session, 0, 0), 1.0, 0.01) << line;
  }
  for (const char* line : {"set-focal-length 210", "set-field-of-view 9.8"}) {
    run(session, line);
    EXPECT_NEAR(zoomOf(session, 0, 0), 100.0, 0.05) << line;
  }
  refused(session, "set-focal-length 210.1", "refusal.focal-length");
  refused(session, "set-field-of-view 9.7", "refusal.field-of-view");
  refused(session, "set-field-of-view 180", "refusal.field-of-view");
  // A lens with one focal length.
  run(session, "set-lens 36 50 50");
  run(session, "set-zoom 30");
  refused(session, "set-focal-length 60", "refusal.focal-length");
}

TEST(SeveralKeys, WhatDiffersIsKnown) {
  Session session;
  makeFive(session);
  DifferingValues differing;
  EXPECT_FALSE(differing.differs(session.state(), KeyValue::kX));
  run(session, "select-all");
  EXPECT_TRUE(differing.differs(session.state(), KeyValue::kX));
  EXPECT_FALSE(differing.differs(session.state(), KeyValue::kZoom));
  run(session, "set-coordinate x 0.5");
  EXPECT_FALSE(differing.differs(session.state(), KeyValue::kX));
  run(session, "undo");
  EXPECT_TRUE(differing.differs(session.state(), KeyValue::kX));
}

// In a drag nothing but its end follows, whatever is asked for.
TEST(SeveralKeys, DuringADragEveryCommandIsRefusedInOneWay) {
  Session session;
  makeFive(session);
  for (const CommandSpecification& specification : commandTable()) {
    if (specification.name == "escape") continue;
    Command command(specification.name);
    for (const ArgumentSpecification& argument : specification.arguments) {
      if (argument.optional) break;
      if (argument.kind == ArgumentKind::kText) {
        command.add("a");
      } else if (argument.kind == ArgumentKind::kChoice) {
        command.add(argument.choices.front());
      } else {
        command.add(1);
      }
    }
    session.begin("step.move-key");
    EXPECT_FALSE(session.execute(command)) << specification.name;
    EXPECT_EQ(session.output().text, Text("refusal.in-gesture")) << specification.name;
    EXPECT_TRUE(session.inDrag()) << specification.name;
    EXPECT_TRUE(session.execute("escape"));
    EXPECT_FALSE(session.inDrag());
  }
}

// A run of notches of the wheel is one step; what comes between begins another one.
TEST(SeveralKeys, ARunIsOneStep) {
  Session session;
  makeFive(session);
  const std::size_t steps = session.history().steps();
  const Flight before = session.flight();
  EXPECT_TRUE(session.execute(Command("set-zoom", 13)));
  EXPECT_TRUE(session.execute(Command("set-zoom", 14), true));
  EXPECT_FALSE(session.execute(Command("set-zoom", 101), true));
  EXPECT_TRUE(session.execute(Command("set-zoom", 15), true));
  EXPECT_EQ(session.history().steps(), steps + 1);
  run(session, "undo");
  EXPECT_EQ(session.flight(), before);
  run(session, "redo");
  EXPECT_EQ(session.currentOrientation().zoom, 15.0);
  // Undone and redone in between: it doesn't go on.
  EXPECT_TRUE(session.execute(Command("set-zoom", 16), true));
  EXPECT_EQ(session.history().steps(), steps + 2);
  // What was refused at its beginning goes on with no other step.
  EXPECT_TRUE(session.execute(Command("set-roll", 5)));
  EXPECT_FALSE(session.execute(Command("set-zoom", 101)));
  EXPECT_TRUE(session.execute(Command("set-zoom", 17), true));
  EXPECT_EQ(session.history().steps(), steps + 4);
}

}  // namespace
}  // namespace vides
