// SPDX-License-Identifier: MIT
// What goes on after an answer dies with any failure: a later success never runs it.
#include <gtest/gtest.h>

#include "edit/edit_fixture.hpp"
#include "edit/frame_job.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

class DialogueTest : public FolderTest {
 protected:
  // An edited flight in a file whose folder has gone since.
  void editThenLoseFolder(Session& session) {
    fs::create_directory(folder_ / "gone");
    run(session, "save-as " + path("gone/a.vid"));
    run(session, "set-name ours");
    fs::remove_all(folder_ / "gone");
  }
  // The flight with all its steps is still there, and so is the window.
  static void expectUntouched(const Session& session) {
    EXPECT_EQ(session.flight().name, "ours");
    EXPECT_TRUE(session.undoName());
    EXPECT_FALSE(session.quitRequested());
  }
};

// Defect 2: answer save, and the save fails; the next one that succeeds must not go on.
TEST_F(DialogueTest, AFailedSaveEndsWhatWasToFollow) {
  writeFile(path("other.vid"), writeVid(newFlight()));
  for (const std::string& then :
       {std::string("new"), std::string("quit"), "open " + path("other.vid")}) {
    SCOPED_TRACE(then);
    Session session;
    editThenLoseFolder(session);
    run(session, then);
    EXPECT_FALSE(session.execute("answer save"));
    EXPECT_EQ(session.output().text.key, "output.save-failed");
    EXPECT_FALSE(session.question());
    run(session, "save-as " + path("b.vid"));
    expectUntouched(session);
    run(session, "set-zoom 20");
    run(session, "save");
    expectUntouched(session);
  }
}

// The same where the name is chosen first, in the chooser that stays open.
TEST_F(DialogueTest, AFailedSaveUnderAChosenNameEndsItToo) {
  for (const char* then : {"new", "quit"}) {
    SCOPED_TRACE(then);
    Session session;
    run(session, "set-name ours");
    run(session, then);
    run(session, "answer save");
    EXPECT_TRUE(session.windowOpen("chooser-save"));
    EXPECT_FALSE(session.execute("save-as " + path("no/such/folder.vid")));
    EXPECT_TRUE(session.windowOpen("chooser-save"));  // another name may be given
    run(session, "save-as " + path("b.vid"));
    expectUntouched(session);
    fs::remove(path("b.vid"));
  }
}

TEST_F(DialogueTest, WhatAnotherProgramHasWrittenIsAskedAboutOnTheWay) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  run(session, "set-name ours");
  writeFile(path("a.vid"), "theirs");
  run(session, "new");
  EXPECT_FALSE(session.execute("answer save"));
  ASSERT_TRUE(session.question());
  EXPECT_EQ(session.question()->kind, Question::Kind::kChangedOnDisk);
  run(session, "answer cancel");
  run(session, "save-as " + path("b.vid"));
  expectUntouched(session);

  // Answered it goes on.
  run(session, "set-name again");
  writeFile(path("b.vid"), "theirs");
  run(session, "new");
  EXPECT_FALSE(session.execute("answer save"));
  run(session, "answer overwrite");
  EXPECT_EQ(session.flight(), newFlight());
  EXPECT_NE(fileText(path("b.vid")).find("again"), std::string::npos);
}

TEST_F(DialogueTest, SavingUnderAnotherNameGoesOnOnce) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  run(session, "set-name ours");
  writeFile(path("a.vid"), "theirs");
  run(session, "new");
  EXPECT_FALSE(session.execute("answer save"));
  run(session, "answer save-as");
  run(session, "save-as " + path("b.vid"));
  EXPECT_EQ(session.flight(), newFlight());
  EXPECT_EQ(fileText(path("a.vid")), "theirs");
  // It is over: nothing follows the next saving.
  run(session, "set-name ours");
  run(session, "save-as " + path("c.vid"));
  expectUntouched(session);
}

TEST_F(DialogueTest, AClosedChooserOrAnotherFlightEndsIt) {
  for (const char* end : {"close-window", "escape", "close-window chooser-save"}) {
    SCOPED_TRACE(end);
    Session session;
    run(session, "set-name ours");
    run(session, "quit");
    run(session, "answer save");
    run(session, end);
    run(session, "save-as " + path("b.vid"));
    expectUntouched(session);
    fs::remove(path("b.vid"));
  }
  Session session;
  run(session, "set-name ours");
  run(session, "quit");
  run(session, "answer save");
  run(session, "new");
  run(session, "answer discard");
  run(session, "set-name ours");
  run(session, "save-as " + path("b.vid"));
  expectUntouched(session);
}

// What follows a saving may fail itself: the saving is done all the same.
TEST_F(DialogueTest, AnUnreadableFileAfterTheSavingIsToldAndLosesNothing) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  run(session, "set-name ours");
  run(session, "open " + path("none.vid"));
  run(session, "answer save");
  EXPECT_EQ(session.output().kind, MessageKind::kError);
  EXPECT_EQ(session.output().text.key, "output.open-failed");
  EXPECT_NE(fileText(path("a.vid")).find("ours"), std::string::npos);
  expectUntouched(session);
}

// Quitting waits for frames: where they can't be written it doesn't go on, or nobody would know.
TEST_F(DialogueTest, FramesThatFailEndTheQuitting) {
  Session session;
  run(session, "frames-file " + path("missing/frames.txt"));
  run(session, "write-frames");
  run(session, "quit");
  session.finishFrames();
  EXPECT_EQ(session.output().text.key, "output.frames-failed");
  EXPECT_FALSE(session.question());
  EXPECT_FALSE(session.quitRequested());
}

// What was agreed for one file holds for no other, and not after a failure.
TEST_F(DialogueTest, AnAgreedOverwritingDiesWithAFailure) {
  writeFile(path("frames.txt"), "precious");
  Session session;
  run(session, "frames-file " + path("frames.txt"));
  run(session, "write-frames");
  ASSERT_TRUE(session.question());
  fs::remove(path("frames.txt"));
  fs::create_directory(path("frames.txt"));
  EXPECT_FALSE(session.execute("answer overwrite"));
  fs::remove(path("frames.txt"));
  writeFile(path("frames.txt"), "precious again");
  run(session, "write-frames");
  ASSERT_TRUE(session.question());
  EXPECT_EQ(session.question()->kind, Question::Kind::kFramesExist);
  // Another file is chosen while it asks about the first one.
  writeFile(path("other.txt"), "precious too");
  run(session, "frames-file " + path("other.txt"));
  run(session, "answer overwrite");
  EXPECT_TRUE(session.question());
  EXPECT_EQ(fileText(path("other.txt")), "precious too");
}

TEST_F(DialogueTest, AnExceptionEndsIt) {
  Session session;
  run(session, "set-name ours");
  run(session, "quit");
  session.abandon("output.went-wrong");
  EXPECT_FALSE(session.question());
  EXPECT_EQ(session.output().kind, MessageKind::kError);
  run(session, "save-as " + path("b.vid"));
  expectUntouched(session);
  // A drag goes back to where it began.
  const Flight before = session.flight();
  session.begin("step.move-keys");
  session.preview(Command("set-zoom", 70));
  session.abandon("output.went-wrong");
  EXPECT_EQ(session.flight(), before);
  EXPECT_FALSE(session.inGesture());
}

}  // namespace
}  // namespace vides
