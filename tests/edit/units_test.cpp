// SPDX-License-Identifier: MIT
// Limits and refusals are told in the units that are shown, and frames begin with them.
#include <gtest/gtest.h>

#include "edit/edit_fixture.hpp"
#include "edit/problem_units.hpp"
#include "edit/texts.hpp"

namespace vides {
namespace {

class SceneUnits : public FolderTest {
 protected:
  SceneUnits() {
    run(session_, "add-scene a.obj 8.8 -3.2 -7.2 15.2 3.2 -0.8");
    run(session_, "units scene");
  }
  std::string refusal(const std::string& line) {
    EXPECT_FALSE(session_.execute(line)) << line;
    return Texts(Language::kEnglish).tell(session_.output().text);
  }
  Session session_;
};

TEST_F(SceneUnits, RangesOfPlaces) {
  EXPECT_EQ(refusal("move-key 0 2 0 0"),
            "Key 1, position x: expected a number from 8 to 16, found 20");
  EXPECT_EQ(refusal("move-key 1 0 0 -1.5"),
            "Key 2, position z: expected a number from -8 to 0, found -10");
  run(session_, "units cube");
  EXPECT_EQ(refusal("move-key 0 2 0 0"),
            "Key 1, position x: expected a number from -1 to 1, found 2");
  EXPECT_EQ(refusal("set-zoom 200"),
            "Key 1, orientation 1, zoom: expected a number from 1 to 100, found 200");
  run(session_, "units scene");
  EXPECT_EQ(refusal("set-zoom 200"),
            "Key 1, orientation 1, zoom: expected a number from 1 to 100, found 200");
}

TEST_F(SceneUnits, RangesOfAims) {
  EXPECT_EQ(refusal("set-aim 2e6 0 0"),
            "Key 1, orientation 1, aim x: expected a number from -3999988 to 4000012, found "
            "8000012");
  run(session_, "set-aim-mode relative");
  // An offset: the centre doesn't move it.
  EXPECT_EQ(refusal("set-aim 2e6 0 0"),
            "Key 1, orientation 1, aim x: expected a number from -4000000 to 4000000, found "
            "8000002");
  const Vec3 place = session_.currentKey().position;
  EXPECT_EQ(refusal("set-aim " + std::to_string(place.x) + " 0.2 0.8").find("at least 4e-09"),
            std::string("Key 1, orientation 1, aim: expected an aim point ").size());
}

TEST_F(SceneUnits, TheGrid) {
  EXPECT_EQ(refusal("grid-step 1"), "The grid's step goes from 0.004 to 2, not 4");
  run(session_, "units cube");
  EXPECT_EQ(refusal("grid-step 1"), "The grid's step goes from 0.001 to 0.5, not 1");
}

TEST_F(SceneUnits, NothingElseChanges) {
  Problem problem;
  problem.pointer = "/keys/0/orientations/0/zoom";
  problem.code = ProblemCode::kOutOfRange;
  problem.expected.min = 1;
  problem.expected.max = 100;
  problem.found = "200";
  EXPECT_EQ(inSceneUnits(problem, session_.flight()), problem);
  problem.pointer = "/keys/9/position/0";  // there is none
  EXPECT_EQ(inSceneUnits(problem, session_.flight()), problem);
  problem.pointer = "/space/half_size";
  EXPECT_EQ(inSceneUnits(problem, session_.flight()), problem);
}

TEST_F(SceneUnits, FramesBeginWithThem) {
  EXPECT_EQ(spaceOf(session_.frameOptions()), FrameSpace::kWorld);
  run(session_, "units cube");
  EXPECT_EQ(spaceOf(session_.frameOptions()), FrameSpace::kCube);
  run(session_, "frames-format chan");
  EXPECT_EQ(spaceOf(session_.frameOptions()), FrameSpace::kWorld);
  run(session_, "frames-format csv");
  run(session_, "frames-space world");
  EXPECT_EQ(spaceOf(session_.frameOptions()), FrameSpace::kWorld);
  run(session_, "units scene");
  run(session_, "frames-space cube");
  EXPECT_EQ(spaceOf(session_.frameOptions()), FrameSpace::kCube);
}

TEST_F(SceneUnits, AFailedExportIsToldWithTheFolderThatIsMissing) {
  run(session_, "frames-file " + path("none/deep/a.txt"));
  run(session_, "write-frames");
  session_.finishFrames();
  EXPECT_EQ(session_.output().kind, MessageKind::kError);
  const std::string told = Texts(Language::kEnglish).tell(session_.framesTrouble());
  EXPECT_NE(told.find("No such file or directory: " + path("none")), std::string::npos) << told;
  EXPECT_EQ(told.find("none/deep"), std::string::npos) << told;
  run(session_, "frames-file " + path("a.txt"));
  EXPECT_TRUE(session_.framesTrouble().empty());
  run(session_, "write-frames");
  session_.finishFrames();
  EXPECT_TRUE(session_.framesTrouble().empty());
  // A save likewise.
  EXPECT_FALSE(session_.execute("save-as " + path("none/a.vid")));
  EXPECT_NE(Texts(Language::kEnglish).tell(session_.output().text).find(": " + path("none")),
            std::string::npos);
}

}  // namespace
}  // namespace vides
