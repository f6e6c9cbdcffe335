// SPDX-License-Identifier: MIT
// The rows of the Scene window: hidden, missing, found again, changed on the disk; and the paths of
// scenes when the flight moves while a window is open.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "edit/edit_fixture.hpp"
#include "edit/texts.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;
using State = SceneRow::State;

class SceneList : public FolderTest {
 protected:
  SceneList() {
    writeFile(path("a.obj"), "v 0 0 0\nv 2 2 2\nl 1 2\n");
    writeFile(path("b.obj"), "v 0 0 0\nv 8 4 2\nl 1 2\n");
  }
  void importBoth() {
    run(session_, "import-scene " + path("a.obj"));
    run(session_, "import-scene " + path("b.obj"));
    session_.scenes();
  }
  Session session_;
};

TEST_F(SceneList, HiddenScenesAreNeitherDrawnNorMeasured) {
  importBoth();
  EXPECT_EQ(session_.scenes().size(), 2u);
  EXPECT_EQ(session_.sceneBox()->high, Vec3(8, 4, 2));
  run(session_, "show-scene 1 off");
  EXPECT_EQ(session_.scenes().size(), 1u);
  EXPECT_EQ(session_.sceneBox()->high, Vec3(2));
  EXPECT_EQ(session_.sceneRows().at(1).state, State::kHidden);
  run(session_, "show-scene 1 off");  // it is so already: no step
  EXPECT_EQ(session_.history().steps(), 3u);
  run(session_, "undo");
  EXPECT_EQ(session_.scenes().size(), 2u);
  run(session_, "show-scene 0");
  EXPECT_FALSE(session_.flight().scene[0].visible);
  refused(session_, "show-scene 2 on", "refusal.no-such-scene");
}

TEST_F(SceneList, AMissingFileIsFoundAndOthersWithIt) {
  run(session_, "add-scene none/a.obj");
  run(session_, "add-scene none/b.obj");
  run(session_, "set-scene-up 0 z");
  run(session_, "save-as " + path("f.vid"));
  EXPECT_TRUE(session_.scenes().empty());
  EXPECT_EQ(session_.sceneRows().at(0).state, State::kMissing);
  EXPECT_FALSE(session_.execute("replace-scene 0 " + path("nothing.obj")));
  EXPECT_EQ(session_.output().kind, MessageKind::kError);
  run(session_, "replace-scene 0");
  EXPECT_TRUE(session_.windowOpen("chooser-find"));
  EXPECT_EQ(session_.soughtScene(), 0u);
  run(session_, "replace-scene 0 " + path("a.obj"));
  EXPECT_FALSE(session_.windowOpen("chooser-find"));
  EXPECT_EQ(session_.flight().scene[0].file, "a.obj");
  EXPECT_EQ(session_.flight().scene[0].up, UpAxis::kZ);
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(Texts(Language::kEnglish).tell(session_.question()->text),
            "Take b.obj from this folder, too?");
  run(session_, "answer replace");
  EXPECT_EQ(session_.flight().scene[1].file, "b.obj");
  EXPECT_EQ(session_.scenes().size(), 2u);
  run(session_, "undo");
  EXPECT_NE(session_.flight().scene[1].file, "b.obj");
  run(session_, "undo");
  EXPECT_NE(session_.flight().scene[0].file, "a.obj");
  refused(session_, "replace-scene 2 " + path("a.obj"), "refusal.no-such-scene");
}

TEST_F(SceneList, AFileThatChangesIsToldAndReadOnlyWhenAsked) {
  importBoth();
  session_.checkDisk();
  EXPECT_FALSE(session_.sceneRows().at(0).changedOnDisk);
  writeFile(path("a.obj"), "v 0 0 0\nv 3 3 3\nl 1 2\n# longer than before\n");
  session_.checkDisk();
  EXPECT_EQ(session_.output().text, Text("output.scene-changed", {"a.obj"}));
  EXPECT_TRUE(session_.sceneRows().at(0).changedOnDisk);
  // Nothing else reads it: neither another list of scenes nor undo.
  run(session_, "show-scene 1 off");
  EXPECT_EQ(session_.scenes().at(0).box().high, Vec3(2));
  run(session_, "undo");
  EXPECT_EQ(session_.scenes().at(0).box().high, Vec3(2));
  const std::string said = session_.output().text.key;
  session_.checkDisk();  // told once
  EXPECT_EQ(session_.output().text.key, said);
  run(session_, "reload-scene 0");
  EXPECT_EQ(session_.scenes().at(0).box().high, Vec3(3));
  EXPECT_FALSE(session_.sceneRows().at(0).changedOnDisk);
  refused(session_, "reload-scene 2", "refusal.no-such-scene");

  fs::remove(path("a.obj"));
  session_.checkDisk();
  EXPECT_EQ(session_.output().text, Text("output.scene-gone", {"a.obj"}));
  EXPECT_EQ(session_.scenes().size(), 2u);
  run(session_, "reload-scene 0");
  EXPECT_EQ(session_.scenes().size(), 1u);
  EXPECT_EQ(session_.output().kind, MessageKind::kError);
  writeFile(path("a.obj"), "v 0 0 0\nv 2 2 2\nl 1 2\n");
  session_.checkDisk();
  EXPECT_EQ(session_.output().text, Text("output.scene-changed", {"a.obj"}));
  run(session_, "reload-scene 0");
  EXPECT_EQ(session_.scenes().size(), 2u);
}

// 10-open-house, defect 1: what a window would go back to named the scene from the old folder.
TEST_F(SceneList, WhatAWindowGoesBackToMovesWithTheFlight) {
  for (const bool changedBefore : {false, true}) {
    Session session;
    fs::create_directories(folder_ / "x");
    fs::create_directories(folder_ / "y/z");
    run(session, "import-scene " + path("a.obj"));
    run(session, "save-as " + path("x/a.vid"));
    EXPECT_EQ(session.flight().scene[0].file, "../a.obj");
    run(session, "show-window shape");
    run(session, "shape-choose 3");
    if (changedBefore) run(session, "set-zoom 44");  // makes a step of what was previewed
    run(session, "save-as " + path("y/z/b.vid"));
    EXPECT_EQ(session.flight().scene[0].file, "../../a.obj");
    run(session, "shape-cancel");
    EXPECT_EQ(session.flight().scene[0].file, "../../a.obj");
    run(session, "save");
    EXPECT_THAT(fileText(path("y/z/b.vid")), testing::HasSubstr("\"../../a.obj\""));
    // Nothing of the history names another place either.
    while (session.available("undo")) {
      run(session, "undo");
      if (!session.flight().scene.empty()) {
        EXPECT_EQ(session.flight().scene[0].file, "../../a.obj");
      }
    }
  }
}

}  // namespace
}  // namespace vides
