// SPDX-License-Identifier: MIT
// Scenes are imported and read while the session goes on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "edit/edit_fixture.hpp"
#include "edit/texts.hpp"

namespace vides {
namespace {

class Scenes : public FolderTest {
 protected:
  Scenes() {
    writeFile(path("small.obj"), "v 0 0 0\nv 4 2 1\nl 1 2\n");
    // Takes far longer to read than anything waits, but not to draw.
    std::string text = "v 0 0 0\nv 976 330 0.125\np 1 2\n";
    for (int i = 0; i < 4000000; ++i) text += "vn 0 0 1\n";
    writeFile(path("large.obj"), text);
    SessionSeams seams;
    seams.readsInBackground = true;
    session_ = std::make_unique<Session>(std::move(seams));
  }
  // Until nothing is read any more and what was read has come in.
  void finish() {
    while (session_->reading()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    session_->advance(0.0);
  }
  Session& session() { return *session_; }

 private:
  std::unique_ptr<Session> session_;
};

TEST_F(Scenes, SmallOnesAreThereAtOnce) {
  run(session(), "import-scene " + path("small.obj"));
  EXPECT_EQ(session().flight().scene.size(), 1u);
  EXPECT_EQ(session().flight().space, (Space{{2, 1, 0.5}, 2 / 0.8}));
  ASSERT_EQ(session().scenes().size(), 1u);
  EXPECT_EQ(session().scenes()[0]->box().high, Vec3(4, 2, 1));
  run(session(), "undo");
  EXPECT_TRUE(session().scenes().empty());
}

TEST_F(Scenes, LargeOnesComeWhenTheyAreRead) {
  run(session(), "import-scene " + path("large.obj"));
  EXPECT_EQ(session().output().text, Text("output.reading-scene", {"large.obj"}));
  ASSERT_TRUE(session().reading());
  EXPECT_EQ(session().reading()->file, "large.obj");
  EXPECT_TRUE(session().flight().scene.empty());
  run(session(), "set-zoom 33");  // meanwhile
  finish();
  EXPECT_EQ(session().flight().scene.size(), 1u);
  EXPECT_DOUBLE_EQ(session().flight().space.halfSize, 488 / 0.8);
  EXPECT_EQ(session().history().steps(), 2u);
  EXPECT_EQ(session().scenes().size(), 1u);  // not read a second time
  run(session(), "undo");
  EXPECT_TRUE(session().flight().scene.empty());
  EXPECT_EQ(session().currentOrientation().zoom, 33.0);
}

TEST_F(Scenes, TheFirstImportDecidesTheSpace) {
  run(session(), "import-scene " + path("large.obj"));
  run(session(), "import-scene " + path("small.obj"));
  finish();
  ASSERT_EQ(session().flight().scene.size(), 2u);
  EXPECT_THAT(session().flight().scene[0].file, testing::EndsWith("large.obj"));
  EXPECT_DOUBLE_EQ(session().flight().space.halfSize, 488 / 0.8);
}

TEST_F(Scenes, AnImportCanBeStopped) {
  const Flight before = session().flight();
  EXPECT_FALSE(session().available("cancel-reading"));
  run(session(), "import-scene " + path("large.obj"));
  EXPECT_TRUE(session().available("cancel-reading"));
  run(session(), "cancel-reading");
  finish();
  EXPECT_EQ(session().output(),
            (OutputLine{MessageKind::kDone, Text("output.import-cancelled", {"large.obj"})}));
  EXPECT_EQ(session().flight(), before);
  EXPECT_EQ(session().history().steps(), 0u);
}

TEST_F(Scenes, AnotherFlightIsNotWhatItWasImportedInto) {
  run(session(), "import-scene " + path("large.obj"));
  run(session(), "new");
  finish();
  EXPECT_TRUE(session().flight().scene.empty());
}

TEST_F(Scenes, ADragEndsFirst) {
  run(session(), "import-scene " + path("large.obj"));
  session().begin("step.move-key");
  session().preview(Command("move-key", 0, 0.1, 0.2, 0.3));
  finish();
  EXPECT_TRUE(session().flight().scene.empty());
  session().commit();
  session().advance(0.0);
  EXPECT_EQ(session().flight().scene.size(), 1u);
  EXPECT_EQ(session().history().steps(), 2u);
}

TEST_F(Scenes, AFlightIsOpenBeforeItsScenesAre) {
  Session maker;
  run(maker, "add-scene " + path("large.obj"));
  run(maker, "add-scene " + path("none.obj"));
  run(maker, "save-as " + path("a.vid"));
  run(session(), "open " + path("a.vid"));
  EXPECT_TRUE(session().scenes().empty());
  EXPECT_EQ(session().output().kind, MessageKind::kError);
  EXPECT_EQ(session().output().text.key, "error.scene");
  ASSERT_TRUE(session().reading());
  run(session(), "cancel-reading");
  finish();
  EXPECT_TRUE(session().scenes().empty());
  EXPECT_EQ(session().output(),
            (OutputLine{MessageKind::kDone, Text("output.reading-cancelled", {"large.obj"})}));
  // Opened again it is read again.
  run(session(), "open " + path("a.vid"));
  session().scenes();
  finish();
  EXPECT_EQ(session().scenes().size(), 1u);
  EXPECT_FALSE(session().modified());
}

TEST_F(Scenes, WhatIsWrongIsToldInWords) {
  writeFile(path("bad.obj"), "v 0 0 0\nv 1\n");
  EXPECT_FALSE(session().execute("import-scene " + path("bad.obj")));
  EXPECT_EQ(session().output().kind, MessageKind::kError);
  const Text text = session().output().text;
  EXPECT_EQ(Texts(Language::kEnglish).tell(text),
            path("bad.obj") + ": line 2: expected 2, 3, 4, 6 or 7 numbers after v, found 1");
  EXPECT_EQ(
      Texts(Language::kGerman).tell(text),
      path("bad.obj") + ": Zeile 2: nach v werden 2, 3, 4, 6 oder 7 Zahlen erwartet, gefunden 1");
  EXPECT_FALSE(session().execute("import-scene " + path("small.ply")));
  EXPECT_EQ(Texts(Language::kEnglish).tell(session().output().text),
            path("small.ply") + ": scenes are read from .obj files, not from “.ply”");
  EXPECT_TRUE(session().flight().scene.empty());
}

}  // namespace
}  // namespace vides
