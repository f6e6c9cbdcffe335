// SPDX-License-Identifier: MIT
// OBJ files as other programs write them: line ends, encodings, numbers, and what is left out and
// told because it changes nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scene/obj_reader.hpp"

namespace vides {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Triangle = std::array<std::uint32_t, 3>;
using testing::ElementsAre;
using testing::IsEmpty;

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

SceneGeometry sceneOf(std::string_view text) {
  auto scene = readObj(text);
  EXPECT_TRUE(scene) << "line " << scene.error().line << " of\n" << text;
  return scene ? std::move(*scene) : SceneGeometry{};
}

SceneProblem problemOf(std::string_view text) {
  const auto scene = readObj(text);
  EXPECT_FALSE(scene) << text;
  return scene ? SceneProblem{} : scene.error();
}

std::string utf16(std::string_view ascii, bool little, bool mark) {
  std::string out;
  const auto add = [&](char high, char low) {
    out += little ? low : high;
    out += little ? high : low;
  };
  if (mark) add('\xfe', '\xff');
  for (const char c : ascii) add('\0', c);
  return out;
}

TEST(ObjLineEnds, AreCrLfOrBothAlsoMixed) {
  const SceneGeometry expected = sceneOf(kThree + "f 1 2 3\n");
  for (const char* text :
       {"v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3",
        "# a\r\r\nv 0 0 0\rv 1 0 0\n\nv 0 1 0\r\n\rf 1 2 3\r\r",
        "v 0 0 0\n\rv 1 0 0\n\rv 0 1 0\n\rf 1 2 3",
        "v 0 0 0\rv 1 0\\\r 0\rv 0 1 \\ \t\r\n0\rf\\\n1 2 3\\"}) {
    const SceneGeometry scene = sceneOf(text);
    EXPECT_EQ(scene.positions, expected.positions) << text;
    EXPECT_EQ(scene.triangles, expected.triangles) << text;
    EXPECT_THAT(scene.report.notes, IsEmpty()) << text;
  }
  EXPECT_EQ(problemOf("# one\r# two\r\nv 0 0 x\r").line, 3);
}

TEST(ObjLineEnds, CommentsNeverGoOn) {
  const SceneGeometry scene = sceneOf(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n# part\\solid\\\nv 0 0 1\nv 1 0 1 # \\\nf -1 -2 -3\n"
      "g left # \\  \nf -4 -3 -2\nl 1 2\n");
  EXPECT_EQ(scene.positions.size(), 6u);
  EXPECT_THAT(scene.triangles, ElementsAre(Triangle{5, 4, 3}, Triangle{2, 3, 4}));
}

// A mark to go on counts in what is passed over, too, and backslashes elsewhere mean nothing.
TEST(ObjLineEnds, ABackslashGoesOnOnlyBeforeTheEnd) {
  const SceneGeometry scene = sceneOf(kThree +
                                      "usemtl C:\\a\\b.mtl\ng a \\ \t \n v 7 7 7\n"
                                      "f 1 \\\r\n\\\t\n2 \\\n\t3\nf 3 2 1\\");
  EXPECT_EQ(scene.positions.size(), 3u);
  EXPECT_EQ(scene.triangles.size(), 2u);
  EXPECT_EQ(problemOf("v 0 0 \\ 0\n").fault, SceneFault::kNumber);
  EXPECT_EQ(problemOf("\nv 3\\"), (SceneProblem{SceneFault::kCoordinates, 2, "1"}));
  EXPECT_EQ(problemOf("\\\n\n# c \\\n\nv 1 \\  \n x 2"),
            (SceneProblem{SceneFault::kNumber, 6, "x"}));
}

TEST(ObjEncodings, Utf16IsRead) {
  const std::string text = "# \xc3\xa4\n" + kThree + "f 1 2 3\n";
  const SceneGeometry expected = sceneOf(text);
  const std::string ascii = kThree + "f 1 2 3\n";
  for (const bool little : {true, false}) {
    for (const bool mark : {true, false}) {
      const SceneGeometry scene = sceneOf(utf16(ascii, little, mark));
      EXPECT_EQ(scene.positions, expected.positions);
      EXPECT_EQ(scene.edges, expected.edges);
    }
    // A half character at its end, or half a pair.
    const std::string whole = utf16(ascii, little, true);
    EXPECT_EQ(problemOf(whole.substr(0, whole.size() - 1)),
              (SceneProblem{SceneFault::kEncoding, 0, "UTF-16"}));
    EXPECT_EQ(
        problemOf(whole + (little ? std::string("\x00\xd8", 2) : std::string("\xd8\x00", 2))).fault,
        SceneFault::kEncoding);
    EXPECT_EQ(problemOf(utf16("v 0 0 0\rv x", little, true)),
              (SceneProblem{SceneFault::kNumber, 2, "x"}));
    EXPECT_EQ(problemOf(utf16(std::string("v 0 0 0\n\0", 9), little, true)),
              (SceneProblem{SceneFault::kNul, 2, ""}));
  }
  EXPECT_EQ(problemOf(std::string("\xff\xfe\0\0v\0\0\0", 8)),
            (SceneProblem{SceneFault::kEncoding, 0, "UTF-32"}));
  EXPECT_EQ(problemOf(std::string("\0\0\xfe\xff\0\0\0v", 8)),
            (SceneProblem{SceneFault::kEncoding, 0, "UTF-32"}));
}

TEST(ObjEncodings, ANulIsAFault) {
  const auto at = [](std::int64_t line) { return SceneProblem{SceneFault::kNul, line, ""}; };
  EXPECT_EQ(problemOf(kThree + "f 1 2 3\n" + std::string(1, '\0')), at(5));
  EXPECT_EQ(problemOf("v 0 0 0\r# a" + std::string(1, '\0') + "b\rv 1 1 1"), at(2));
  EXPECT_EQ(problemOf("v 0 0" + std::string(1, '\0') + "0"), at(1));
  // Bytes that are no UTF-8 may stand where nothing is read.
  EXPECT_EQ(sceneOf("# caf\xe9\ng t\xfcr\n" + kThree + "f 1 2 3").positions.size(), 3u);
}

TEST(ObjVertices, TakeWeightsAndColours) {
  const SceneGeometry scene =
      sceneOf("v 1 2\nv 1 2 3\nv 1 2 4 0.5\nv 1 2 5 0 0.5 1\nv 1 2 6 0 0.5 1 nan\np 1 2 3 4 5\n");
  EXPECT_THAT(scene.positions, ElementsAre(Vec3(1, 2, 0), Vec3(1, 2, 3), Vec3(1, 2, 4),
                                           Vec3(1, 2, 5), Vec3(1, 2, 6)));
  for (const char* count : {"0", "1", "5", "8", "12"}) {
    std::string line = "v";
    for (int i = 0; i < std::stoi(count); ++i) line += " 1";
    EXPECT_EQ(problemOf(kThree + line + "\nf 1 2 3"),
              (SceneProblem{SceneFault::kCoordinates, 4, count}));
  }
  EXPECT_EQ(problemOf("v 0 0 0\nv 1 0 0\nv 0 1 0 f 1 2 3\nf 1 2 3\n"),
            (SceneProblem{SceneFault::kNumber, 3, "f"}));
  EXPECT_EQ(problemOf(kThree + "v 0 0 1 hello\nf 1 2 3"),
            (SceneProblem{SceneFault::kNumber, 4, "hello"}));
}

TEST(ObjVertices, ThatAreNotFiniteMayBeThereIfNothingUsesThem) {
  for (const char* word :
       {"nan",         "NaN",    "-nan",      "nan(ind)", "-nan(ind)",     "-NAN(IND)", "nan(snan)",
        "nan(0x8000)", "inf",    "-inf",      "+Inf",     "Infinity",      "-infinity", "1.#QNAN",
        "-1.#IND",     "1.#INF", "-1.#INF00", "1.#SNAN",  "-1.#IND000000", "1.#qnan0",  "1.#J",
        "-1.#IO",      "1.#R",   "1.$",       "NaNQ",     "1e999",         "-1e99999"}) {
    const std::string bad = std::string("v ") + word + " 0 0\n";
    const SceneGeometry scene = sceneOf(bad + kThree + "v 1 1 " + word + "\nf 2 3 4\nf -2 -3 -4\n");
    EXPECT_EQ(scene.positions.size(), 3u) << word;
    EXPECT_THAT(scene.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 0})) << word;
    EXPECT_THAT(scene.report.notes, ElementsAre(SceneNote{SceneRemark::kBadVertices, 2, 1, word}))
        << word;
    EXPECT_EQ(problemOf("v 0 0 0\n" + bad + "v 1 1 1\nf 1 2 3"),
              (SceneProblem{SceneFault::kBadVertex, 2, word}));
    EXPECT_EQ(problemOf(bad + bad + "l 1 2").line, 1) << word;
    EXPECT_EQ(problemOf("v 0 0 0\n" + bad + "p 1 2").line, 2) << word;
    EXPECT_EQ(problemOf("\n" + bad), (SceneProblem{SceneFault::kNothingDrawn, 2, word}));
  }
  for (const char* word : {"nano", "nan(", "nan(a b)", "nan()x", "info", "-", "+", "1.#", "1.#x",
                           "2.#INF", "0x10", "1e", "--nan", "1.#INFx", "1.#QNANQ"}) {
    EXPECT_FALSE(readObj(kThree + "v 0 " + word + " 0\nf 1 2 3")) << word;
  }
  // Behind a point a # is no comment, elsewhere it is.
  EXPECT_EQ(problemOf("v 1 2 3.#high\np 1").fault, SceneFault::kNumber);
  EXPECT_EQ(sceneOf("v 1 2 3#INF\np 1").positions.front(), Vec3(1, 2, 3));
}

TEST(ObjFaces, MayStandBeforeTheirVertices) {
  const SceneGeometry scene = sceneOf("f 1 2 3\nl 3/1 4\np 4\n" + kThree + "v 1 1 1\nf -1 -2 -3");
  EXPECT_THAT(scene.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{3, 2, 1}));
  EXPECT_THAT(scene.points, ElementsAre(3u));
  EXPECT_EQ(scene.report, (SceneReport{4, 2, 1, 1, {}}));
}

TEST(ObjFaces, OfTooFewCornersAreLeftOutAndTold) {
  const SceneGeometry scene = sceneOf(kThree + "f 1 2 3\nf 1 3\nf 2//1\nf\nl 1\nl\np # none\n");
  EXPECT_EQ(scene.edges.size(), 3u);
  EXPECT_EQ(scene.report,
            (SceneReport{3, 1, 0, 0, {SceneNote{SceneRemark::kTooFewCorners, 6, 5, ""}}}));
}

TEST(ObjFaces, GroupsAreNumbers) {
  EXPECT_EQ(sceneOf(kThree + "f 1/ 2// 3/-1/+7\nf +1//0 2/99999999999999999999 3").triangles.size(),
            2u);
}

TEST(ObjUnknownLines, AreLeftOutAndTold) {
  const SceneGeometry scene = sceneOf("mtllib a.mtl\no a\n" + kThree +
                                      "vt 0 0\nvn x\nvp 1\ncstype bezier\ndeg 3 \\\n 4\ng\ns "
                                      "off\nusemtl b\nV 1 2 3\nf 1 2 3\nend\n");
  EXPECT_EQ(scene.positions.size(), 3u);
  EXPECT_THAT(scene.report.notes,
              ElementsAre(SceneNote{SceneRemark::kUnknownLines, 4, 9, "cstype"}));
}

TEST(ObjVertices, AloneAreDrawnAsPoints) {
  const SceneGeometry scene =
      sceneOf("v 0 0 0\nv nan 0 0\nv 1 0 0\nv 1 0 0\nf 1 3\ncurv 0 1 1 2\n");
  EXPECT_THAT(scene.positions, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0)));
  EXPECT_THAT(scene.points, ElementsAre(0u, 1u, 2u));
  EXPECT_THAT(scene.edges, IsEmpty());
  EXPECT_EQ(scene.report.vertices, 3);
  EXPECT_EQ(scene.report.points, 3);
  EXPECT_THAT(scene.report.notes, ElementsAre(SceneNote{SceneRemark::kUnknownLines, 1, 6, "curv"},
                                              SceneNote{SceneRemark::kTooFewCorners, 1, 5, ""},
                                              SceneNote{SceneRemark::kBadVertices, 1, 2, "nan"},
                                              SceneNote{SceneRemark::kVerticesOnly, 3, 0, ""}));
  // A face that shrinks to a point draws nothing either.
  EXPECT_EQ(sceneOf(kThree + "f 1 1 1").points.size(), 3u);
}

TEST(ObjVertices, ThatNothingUsesAreNeitherDrawnNorCounted) {
  const SceneGeometry scene =
      sceneOf("v 1e6 0 0\n" + kThree + "v -1e6 0 0\nf 2 3 4\nf 2 2 2\nf 5 5 5");
  EXPECT_EQ(scene.positions.size(), 3u);
  EXPECT_EQ(scene.report.vertices, 3);
  EXPECT_EQ(scene.box, (BoundingBox{{0, 0, 0}, {1, 1, 0}}));
  EXPECT_THAT(scene.edges, ElementsAre(Edge{0, 1}, Edge{0, 2}, Edge{1, 2}));
  EXPECT_THAT(scene.triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_EQ(sceneOf(kThree + "v 9 9 9\np 4 1").positions.size(), 2u);
}

}  // namespace
}  // namespace vides
