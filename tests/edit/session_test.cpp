// SPDX-License-Identifier: MIT
// The session: one path for every change, undo and redo, current and selection, gestures.
#include "edit/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "edit/command_table.hpp"
#include "io/vid_writer.hpp"

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
  ASSERT_TRUE(session.execute("move-key 1 0.1 0.2 0.3"));
  EXPECT_EQ(session.flight().keys[1].position, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(session.evaluation().flight(), session.flight());
  EXPECT_TRUE(session.modified());
  EXPECT_EQ(session.undoName(), Text("menu.undo", {Text("step.move-key", {2})}));
  ASSERT_TRUE(session.execute("undo"));
  EXPECT_EQ(session.flight(), newFlight());
  EXPECT_FALSE(session.modified());
  ASSERT_TRUE(session.execute("redo"));
  EXPECT_EQ(session.flight().keys[1].position, Vec3(0.1, 0.2, 0.3));
}

TEST(Session, RefusalChangesNothingAndIsTold) {
  Session session;
  EXPECT_FALSE(session.execute("move-key 0 1.5 0 0"));
  EXPECT_EQ(session.flight(), newFlight());
  EXPECT_EQ(session.output().kind, MessageKind::kRefusal);
  EXPECT_EQ(session.output().text.key, "refusal.problem");
  EXPECT_FALSE(session.undoName());
}

TEST(Session, WhatChangesNothingIsNoStep) {
  Session session;
  EXPECT_TRUE(session.execute("move-key 0 -0.5 0.2 0.8"));
  EXPECT_TRUE(session.execute("set-zoom 12"));
  EXPECT_FALSE(session.undoName());
}

}  // namespace
}  // namespace vides
