// SPDX-License-Identifier: MIT
// Open, save, revert, questions, other programs' changes, the clipboard: nothing is lost unasked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "edit/edit_fixture.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;
using Files = FolderTest;

TEST_F(Files, SavedIsWhatIsRead) {
  Session session;
  makeFive(session);
  EXPECT_EQ(session.title(), Text("title.modified", {Text("title.untitled")}));
  run(session, "save-as " + path("first.vid"));
  EXPECT_FALSE(session.modified());
  EXPECT_EQ(session.title(), Text("title.saved", {"first.vid"}));
  EXPECT_EQ(fileText(path("first.vid")), writeVid(session.flight()));
  Session other;
  run(other, "open " + path("first.vid"));
  EXPECT_EQ(other.flight(), session.flight());
  EXPECT_FALSE(other.modified());
  EXPECT_FALSE(other.undoName());
  EXPECT_THAT(other.recentFiles(), testing::ElementsAre(other.path()));
}

TEST_F(Files, ASampleIsNeverWrittenOver) {
  Session maker;
  makeFive(maker);
  run(maker, "save-as " + path("sample.vid"));
  Flight sample = maker.flight();
  sample.scene.emplace_back().file = "scene.obj";
  writeFile(path("sample.vid"), writeVid(sample));
  const std::string before = fileText(path("sample.vid"));

  Session session;
  ASSERT_TRUE(session.beginWithSample(path("sample.vid")));
  EXPECT_EQ(session.path(), "");
  EXPECT_FALSE(session.modified());
  EXPECT_EQ(session.title(), Text("title.saved", {Text("title.untitled")}));
  EXPECT_EQ(session.flight().keys, sample.keys);
  EXPECT_EQ(fs::path(session.flight().scene.front().file), fs::canonical(path("")) / "scene.obj");
  run(session, "set-zoom 33");
  session.execute("save");  // asks for a name
  EXPECT_EQ(fileText(path("sample.vid")), before);

  const Flight edited = session.flight();
  EXPECT_FALSE(session.beginWithSample(path("none.vid")));
  EXPECT_EQ(session.flight(), edited);
}

TEST_F(Files, ModifiedTellsWhetherTheFileDiffers) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  run(session, "set-zoom 20");
  EXPECT_TRUE(session.modified());
  run(session, "undo");
  EXPECT_FALSE(session.modified());
  run(session, "redo");
  run(session, "save");
  EXPECT_FALSE(session.modified());
  run(session, "undo");
  EXPECT_TRUE(session.modified());
}

TEST_F(Files, AnUnreadableFileIsToldAndChangesNothing) {
  Session session;
  makeFive(session);
  run(session, "save-as " + path("good.vid"));
  const Flight before = session.flight();
  writeFile(path("bad.vid"), R"({"format": "vides", "version": 1, "keys": [], "zoom": 3})");
  EXPECT_FALSE(session.execute("open " + path("bad.vid")));
  EXPECT_EQ(session.output().kind, MessageKind::kError);
  EXPECT_EQ(session.output().text.key, "output.open-failed-more");
  EXPECT_FALSE(session.execute("open " + path("none.vid")));
  EXPECT_EQ(session.output().text.key, "output.open-failed");
  EXPECT_EQ(session.flight(), before);
  EXPECT_EQ(fs::path(session.path()).filename(), "good.vid");
}

TEST_F(Files, UnsavedEditsAreAskedFor) {
  Session session;
  run(session, "set-name a");
  run(session, "save-as " + path("a.vid"));
  run(session, "set-name b");
  run(session, "new");
  ASSERT_TRUE(session.question());
  EXPECT_EQ(session.question()->kind, Question::Kind::kUnsaved);
  EXPECT_EQ(session.flight().name, "b");
  run(session, "answer cancel");
  EXPECT_EQ(session.flight().name, "b");
  run(session, "quit");
  EXPECT_FALSE(session.quitRequested());
  run(session, "answer save");
  EXPECT_TRUE(session.quitRequested());
  EXPECT_NE(fileText(path("a.vid")).find("\"b\""), std::string::npos);
}

TEST_F(Files, DiscardedEditsAreGone) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  run(session, "set-name b");
  run(session, "open " + path("a.vid"));
  ASSERT_TRUE(session.question());
  EXPECT_FALSE(session.execute("answer enlarge"));  // no answer to this question
  ASSERT_TRUE(session.question());
  run(session, "answer discard");
  EXPECT_EQ(session.flight(), newFlight());
  EXPECT_FALSE(session.modified());
}

TEST_F(Files, AnUnsavedNewFlightIsSavedByTheChooserBeforeItGoesOn) {
  Session session;
  run(session, "set-name a");
  run(session, "quit");
  run(session, "answer save");
  EXPECT_TRUE(session.windowOpen("chooser-save"));
  EXPECT_FALSE(session.quitRequested());
  run(session, "save-as " + path("a.vid"));
  EXPECT_TRUE(session.quitRequested());
  EXPECT_FALSE(session.windowOpen("chooser-save"));

  Session other;
  run(other, "set-name a");
  run(other, "quit");
  run(other, "answer save");
  run(other, "close-window chooser-save");
  run(other, "save-as " + path("b.vid"));
  EXPECT_FALSE(other.quitRequested());
}

TEST_F(Files, AFailedSaveLeavesTheOldFileAndSaysWhy) {
  Session session;
  run(session, "set-name a");
  EXPECT_FALSE(session.execute("save-as " + path("no/such/folder/a.vid")));
  EXPECT_EQ(session.output().kind, MessageKind::kError);
  EXPECT_EQ(session.output().text.key, "output.save-failed");
  EXPECT_TRUE(session.modified());
  EXPECT_EQ(session.path(), "");
}

TEST_F(Files, WhatAnotherProgramWroteIsNotOverwrittenUnasked) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  Flight theirs = newFlight();
  theirs.name = "theirs";
  writeFile(path("a.vid"), writeVid(theirs));
  run(session, "set-name ours");
  session.checkDisk();
  EXPECT_EQ(session.output().text.key, "output.changed-on-disk");
  session.say(MessageKind::kDone, "output.undone");
  session.checkDisk();  // told once
  EXPECT_EQ(session.output().text.key, "output.undone");

  EXPECT_FALSE(session.execute("save"));
  EXPECT_EQ(session.output().text.key, "refusal.changed-on-disk");
  EXPECT_EQ(fileText(path("a.vid")), writeVid(theirs));
  run(session, "answer cancel");
  EXPECT_EQ(fileText(path("a.vid")), writeVid(theirs));
  EXPECT_FALSE(session.execute("save"));
  run(session, "answer overwrite");
  EXPECT_EQ(fileText(path("a.vid")), writeVid(session.flight()));
  EXPECT_FALSE(session.modified());
}

TEST_F(Files, TheSameContentWrittenAgainIsNoChange) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  fs::last_write_time(path("a.vid"), fs::file_time_type::clock::now() + std::chrono::hours(1));
  run(session, "set-name a");
  run(session, "save");
  EXPECT_FALSE(session.question());
}

TEST_F(Files, ADeletedFileIsToldAndWrittenAgain) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  fs::remove(path("a.vid"));
  session.checkDisk();
  EXPECT_EQ(session.output().text.key, "output.deleted-on-disk");
  EXPECT_TRUE(session.modified());
  run(session, "save");
  EXPECT_TRUE(fs::exists(path("a.vid")));
  EXPECT_FALSE(session.modified());
}

TEST_F(Files, RevertReadsAgainAndCanBeUndone) {
  Session session;
  refused(session, "revert", "refusal.not-available");
  run(session, "save-as " + path("a.vid"));
  makeFive(session);
  const Flight edited = session.flight();
  run(session, "revert");
  EXPECT_EQ(session.flight(), newFlight());
  EXPECT_FALSE(session.modified());
  run(session, "undo");
  EXPECT_EQ(session.flight(), edited);
  EXPECT_TRUE(session.modified());
}

TEST_F(Files, ScenePathsStayRelativeToTheFlight) {
  fs::create_directories(folder_ / "flights");
  fs::create_directories(folder_ / "scenes");
  writeFile(path("scenes/pyramid.obj"), "v -1 -1 -1\nv 1 1 1\nl 1 2\n");
  Session session;
  run(session, "import-scene " + path("scenes/pyramid.obj"));
  EXPECT_EQ(session.flight().scene[0].file,
            fs::canonical(folder_).string() + "/scenes/pyramid.obj");
  run(session, "save-as " + path("flights/a.vid"));
  EXPECT_EQ(session.flight().scene[0].file, "../scenes/pyramid.obj");
  run(session, "save-as " + path("b.vid"));
  EXPECT_EQ(session.flight().scene[0].file, "scenes/pyramid.obj");
  EXPECT_FALSE(session.modified());
  // What is undone and redone lies in the new folder, too.
  run(session, "undo");
  EXPECT_TRUE(session.flight().scene.empty());
  run(session, "redo");
  EXPECT_EQ(session.flight().scene[0].file, "scenes/pyramid.obj");
  EXPECT_FALSE(session.modified());
}

// A flight written by hand may name its scene by a whole path.
TEST_F(Files, AWholePathOfASceneBecomesARelativeOne) {
  fs::create_directories(folder_ / "scenes");
  Flight flight = newFlight();
  flight.scene.emplace_back().file = fs::canonical(folder_).string() + "/scenes/none.obj";
  writeFile(path("a.vid"), writeVid(flight));
  Session session;
  run(session, "open " + path("a.vid"));
  EXPECT_EQ(session.flight(), flight);
  run(session, "save");
  EXPECT_EQ(session.flight().scene[0].file, "scenes/none.obj");
  EXPECT_EQ(fileText(path("a.vid")), writeVid(session.flight()));
  EXPECT_FALSE(session.modified());
}

TEST_F(Files, TheRecentOnesAreFewAndNewestFirst) {
  Session session;
  for (int i = 0; i < 13; ++i) run(session, "save-as " + path(std::to_string(i) + ".vid"));
  run(session, "save-as " + path("11.vid"));
  ASSERT_EQ(session.recentFiles().size(), Session::kRecentFiles);
  EXPECT_EQ(fs::path(session.recentFiles()[0]).filename(), "11.vid");
  EXPECT_EQ(fs::path(session.recentFiles()[1]).filename(), "12.vid");
  run(session, "open-recent 1");
  EXPECT_EQ(fs::path(session.path()).filename(), "12.vid");
  refused(session, "open-recent 10", "refusal.no-such-recent");
}

TEST_F(Files, ARecoveredFlightIsUnsaved) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  Flight edited = newFlight();
  edited.name = "edited";
  Session next;
  next.recover(edited, path("a.vid"));
  EXPECT_EQ(next.flight(), edited);
  EXPECT_TRUE(next.modified());
  run(next, "save");
  EXPECT_EQ(fileText(path("a.vid")), writeVid(edited));
}

// --- Clipboard ---

struct SharedClipboard {
  std::string text;
  SessionSeams seams() {
    SessionSeams s;
    s.clipboard = [this] { return text; };
    s.setClipboard = [this](const std::string& t) { text = t; };
    return s;
  }
};

TEST(Clipboard, KeysGoFromOneEditorToAnother) {
  SharedClipboard clipboard;
  Session one(clipboard.seams()), two(clipboard.seams());
  makeFive(one);
  run(one, "select-keys 1 3");
  run(one, "copy");
  run(two, "paste");
  ASSERT_EQ(two.flight().keys.size(), 4u);
  EXPECT_EQ(two.flight().keys[1], one.flight().keys[1]);
  EXPECT_EQ(two.flight().keys[2], one.flight().keys[3]);
  EXPECT_EQ(two.current().key, 2u);
  EXPECT_THAT(two.selected().keys(), testing::ElementsAre(1, 2));
  EXPECT_EQ(two.history().steps(), 1u);
}

TEST(Clipboard, ASingleKeyIsPastedOnce) {
  SharedClipboard clipboard;
  Session session(clipboard.seams());
  makeFive(session);
  run(session, "select-key 2");
  run(session, "copy");
  run(session, "paste");
  EXPECT_EQ(session.flight().keys.size(), 6u);
  EXPECT_EQ(session.flight().keys[3], session.flight().keys[2]);
  // The clipboard holds a file that any vides opens.
  EXPECT_NE(clipboard.text.find("\"format\": \"vides\""), std::string::npos);
}

TEST(Clipboard, CutTakesAway) {
  SharedClipboard clipboard;
  Session session(clipboard.seams());
  refused(session, "cut", "refusal.two-keys");
  EXPECT_EQ(clipboard.text, "");
  makeFive(session);
  const Flight before = session.flight();
  run(session, "select-keys 1 2");
  run(session, "cut");
  EXPECT_EQ(session.flight().keys.size(), 3u);
  run(session, "select-key 0");
  run(session, "paste");
  EXPECT_EQ(session.flight(), before);
}

TEST(Clipboard, PastedKeysKeepShapeAndPlace) {
  SharedClipboard clipboard;
  Session one(clipboard.seams()), two(clipboard.seams());
  run(one, "set-preset-shape 4 0.7 0 0");
  run(one, "set-preset 4");
  run(one, "set-space 0 0 0 2");
  run(one, "copy");
  run(two, "set-space 0 0 0 4");
  run(two, "paste");
  const Key& key = two.flight().keys[1];
  EXPECT_EQ(shapeOf(two.flight(), key).tension, 0.7);
  EXPECT_EQ(key.shape.preset, KeyShape::kOwn);
  EXPECT_NEAR(glm::length(two.flight().space.toWorld(key.position) - Vec3(-0.5, 0.2, 0.8)), 0,
              1e-12);
  Session three(clipboard.seams());
  run(one, "move-key 0 1 1 1");
  run(one, "copy");
  refused(three, "paste", "refusal.space-too-small");
}

TEST(Clipboard, WhatIsNoFlightIsRefused) {
  SharedClipboard clipboard;
  Session session(clipboard.seams());
  refused(session, "paste", "refusal.clipboard-empty");
  clipboard.text = "hello";
  refused(session, "paste", "refusal.clipboard");
}

}  // namespace
}  // namespace vides
