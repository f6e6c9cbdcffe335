// SPDX-License-Identifier: MIT
// What the `.vid` reader makes of a text: every member, every default.
#include "io/vid_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "flight/validation.hpp"
#include "io/problem_text.hpp"
#include "io/vid_writer.hpp"
#include "support/files.hpp"

namespace vides {
namespace {

using testing::ElementsAre;

std::string problemLines(const std::vector<Problem>& problems) {
  std::string lines;
  for (const Problem& problem : problems) lines += problemLine("f.vid", problem) + "\n";
  return lines;
}

Flight flightOf(std::string_view text) {
  ReadFlight flight = readVid(text);
  if (!flight) {
    ADD_FAILURE() << problemLines(flight.error());
    return newFlight();
  }
  return *flight;
}

std::string problemsOf(std::string_view text) {
  const ReadFlight flight = readVid(text);
  return flight ? "read" : problemLines(flight.error());
}

// The least that is a flight, with more members put into each place.
std::string smallest(const std::string& members = {}, const std::string& key = {},
                     const std::string& orientation = {}) {
  const std::string keyText =
      R"({"position":[0,0,0],"orientations":[{"aim":[0,0,1])" + orientation + "}]" + key + "}";
  return R"({"format":"vides","version":1,"keys":[)" + keyText +
         R"(,{"position":[1,0,0],"orientations":[{"aim":[0,0,1]}]}])" + members + "}";
}

TEST(VidReader, DefaultsOfAbsentMembers) {
  const Flight flight = flightOf(smallest());
  Flight expected;
  Key key;
  key.orientations[0].aim = {0, 0, 1};
  expected.keys.push_back(key);
  key.position = {1, 0, 0};
  expected.keys.push_back(key);
  EXPECT_EQ(flight, expected);
  EXPECT_EQ(flight.name, "");
  EXPECT_EQ(flight.frameRate, 25);
  EXPECT_EQ(flight.picture.width, 1920);
  EXPECT_EQ(flight.picture.height, 1080);
  EXPECT_EQ(flight.lens.sensorWidth, 36);
  EXPECT_EQ(flight.lens.focalLengthAtZoom1, 12);
  EXPECT_EQ(flight.lens.focalLengthAtZoom100, 210);
  EXPECT_EQ(flight.space.center, Vec3(0, 0, 0));
  EXPECT_EQ(flight.space.halfSize, 1);
  EXPECT_EQ(flight.rates.move, 100);
  EXPECT_EQ(flight.rates.zoom, 100);
  EXPECT_FALSE(flight.closed);
  EXPECT_EQ(flight.orientationCurve, orientationMethod("smooth"));
  EXPECT_EQ(flight.presets[6], (Shape{0, 0.5, 0}));
  const Orientation& o = flight.keys[0].orientations[0];
  EXPECT_EQ(flight.keys[0].shape.preset, 0);
  EXPECT_EQ(o.aimMode, AimMode::kAbsolute);
  EXPECT_EQ(o.roll, 0);
  EXPECT_EQ(o.zoom, 12);
  EXPECT_THAT(o.speed, ElementsAre(50, 50, 50, 50, 50, 50, 50, 50, 50, 50));
  EXPECT_FALSE(o.duration.has_value());
  EXPECT_EQ(o.hold, 0);
}

TEST(VidReader, EveryMember) {
  const Flight flight = flightOf(R"({
    "format": "vides", "version": 1, "name": "Flug über Öl 🛩", "frame_rate": 29.97,
    "picture": { "width": 640, "height": 480 },
    "lens": { "sensor_width_mm": 24.5, "focal_length_mm": [10, 300] },
    "space": { "center": [1, -2, 3.5], "half_size": 250 },
    "rates": { "move": 10, "pan": 20, "roll": 30, "zoom": 40 },
    "closed": true, "orientation_curve": "catmull_rom",
    "presets": [
      {"tension": 0.1, "continuity": 0.2, "bias": 0.3}, {"tension": 0, "continuity": 0, "bias": 0},
      {"tension": 0, "continuity": 0, "bias": 0}, {"tension": 0, "continuity": 0, "bias": 0},
      {"tension": 0, "continuity": 0, "bias": 0}, {"tension": 0, "continuity": 0, "bias": 0},
      {"tension": 0, "continuity": 0, "bias": 0}, {"tension": 0, "continuity": 0, "bias": 0},
      {"tension": 0, "continuity": 0, "bias": 0}, {"tension": -1, "continuity": 1, "bias": -1}],
    "keys": [
      {"position": [0.25, -0.5, 1], "shape": {"preset": 9}, "orientations": [
        {"aim": [1, 2, 3], "aim_mode": "relative", "roll": -720.5, "zoom": 99.5,
         "speed": [1, 2, 3, 4, 5, 6, 7, 8, 9, 100], "duration": 2.5, "hold": 1.25},
        {"aim": [0, 0, 0]}]},
      {"position": [0, 0, 1], "shape": {"tension": 0.5, "continuity": -0.5, "bias": 1},
       "orientations": [{"aim": [0, 0, 0], "aim_mode": "absolute"}]}],
    "scene": [{"file": "a.obj"}, {"file": "../b/c.ply"}]
  })");
  EXPECT_EQ(flight.name, "Flug über Öl 🛩");
  EXPECT_EQ(flight.frameRate, 29.97);
  EXPECT_EQ(flight.picture, (PictureFormat{640, 480}));
  EXPECT_EQ(flight.lens, (Lens{24.5, 10, 300}));
  EXPECT_EQ(flight.space, (Space{{1, -2, 3.5}, 250}));
  EXPECT_EQ(flight.rates, (Rates{10, 20, 30, 40}));
  EXPECT_TRUE(flight.closed);
  EXPECT_EQ(flight.orientationCurve, orientationMethod("catmull_rom"));
  EXPECT_EQ(flight.presets[0], (Shape{0.1, 0.2, 0.3}));
  EXPECT_EQ(flight.presets[9], (Shape{-1, 1, -1}));
  ASSERT_EQ(flight.keys.size(), 2U);
  EXPECT_EQ(flight.keys[0].position, Vec3(0.25, -0.5, 1));
  EXPECT_EQ(flight.keys[0].shape.preset, 9);
  EXPECT_EQ(flight.keys[1].shape.preset, KeyShape::kOwn);
  EXPECT_EQ(flight.keys[1].shape.own, (Shape{0.5, -0.5, 1}));
  ASSERT_EQ(flight.keys[0].orientations.size(), 2U);
  const Orientation& o = flight.keys[0].orientations[0];
  EXPECT_EQ(o.aim, Vec3(1, 2, 3));
  EXPECT_EQ(o.aimMode, AimMode::kRelative);
  EXPECT_EQ(o.roll, -720.5);
  EXPECT_EQ(o.zoom, 99.5);
  EXPECT_THAT(o.speed, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 100));
  EXPECT_EQ(o.duration, 2.5);
  EXPECT_EQ(o.hold, 1.25);
  ASSERT_EQ(flight.scene.size(), 2U);
  EXPECT_EQ(flight.scene[1].file, "../b/c.ply");
}

TEST(VidReader, NumbersInEveryNotation) {
  const Flight flight = flightOf(smallest(
      R"(,"picture":{"width":1920.0,"height":1.08e3},"frame_rate":2400e-2,"rates":{"move":1E+2})",
      {}, R"(,"roll":-0,"hold":-0.0e5,"zoom":12000000000000000000000e-21)"));
  EXPECT_EQ(flight.picture, (PictureFormat{1920, 1080}));
  EXPECT_EQ(flight.frameRate, 24);
  EXPECT_EQ(flight.rates.move, 100);
  const Orientation& o = flight.keys[0].orientations[0];
  EXPECT_FALSE(std::signbit(o.roll));
  EXPECT_FALSE(std::signbit(o.hold));
  EXPECT_EQ(o.zoom, 12);
}

TEST(VidReader, NumbersTooSmallForDoubleAreZero) {
  const Flight flight = flightOf(smallest({}, {}, R"(,"hold":1e-999,"roll":-0.00001e-330)"));
  EXPECT_EQ(flight.keys[0].orientations[0].hold, 0);
  EXPECT_FALSE(std::signbit(flight.keys[0].orientations[0].roll));
  EXPECT_EQ(problemsOf(smallest({}, {}, R"(,"duration":1e-999)")),
            "f.vid: /keys/0/orientations/0/duration: expected a number greater than 0, up to "
            "86400, found 1e-999\n");
}

TEST(VidReader, NumbersBeyondDoubleAreToldAtTheirPlace) {
  EXPECT_EQ(problemsOf(smallest({}, {}, R"(,"roll":1e999,"hold":-1e999)")),
            "f.vid: /keys/0/orientations/0/roll: expected a number from -36000 to 36000, found "
            "1e999\n"
            "f.vid: /keys/0/orientations/0/hold: expected a number from 0 to 86400, found "
            "-1e999\n");
}

TEST(VidReader, ByteOrderMark) {
  EXPECT_EQ(flightOf("\xEF\xBB\xBF" + smallest()), flightOf(smallest()));
  EXPECT_EQ(problemsOf("\xEF\xBB\xBF{]"),
            "f.vid:1:2: expected a member's name in quotes or '}', found ']'\n");
}

TEST(VidReader, EscapedNamesAreTheSameNames) {
  EXPECT_EQ(flightOf(smallest(R"(,"n\u0061me":"a\u00e4\ud83d\udee9\n\"")")).name, "aä🛩\n\"");
}

TEST(VidReader, NewerVersionIsTheOnlyProblem) {
  const std::string told =
      "f.vid: /version: written by a newer vides (format 2; this one reads up to 1)\n";
  EXPECT_EQ(problemsOf(R"({"version":2})"), told);
  EXPECT_EQ(problemsOf(R"({"format":"other","keys":7,"zoom":{},"zoom":1,"version":2.0,"x":)"),
            told);
  EXPECT_EQ(problemsOf(R"({"version":1e300})"),
            "f.vid: /version: written by a newer vides (format 1e300; this one reads up to 1)\n");
}

TEST(VidReader, AtMostTwentyProblemsInTheOrderOfTheFile) {
  std::string members;
  for (int i = 0; i < 30; ++i) members += ",\"unknown" + std::to_string(i) + "\":0";
  const ReadFlight flight = readVid(smallest(members, {}, R"(,"zoom":0)"));
  ASSERT_FALSE(flight);
  ASSERT_EQ(flight.error().size(), 20U);
  EXPECT_EQ(flight.error()[0].pointer, "/keys/0/orientations/0/zoom");
  EXPECT_EQ(flight.error()[1].pointer, "/unknown0");
  EXPECT_EQ(flight.error()[19].pointer, "/unknown18");
}

TEST(VidReader, ReferenceFlightsAreRead) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(VIDES_TEST_DATA "/flights")) {
    if (entry.path().extension() != ".vid") continue;
    ++count;
    const ReadFlight flight = readVidFile(entry.path().string());
    ASSERT_TRUE(flight) << entry.path() << problemLines(flight.error());
    EXPECT_THAT(validate(*flight), testing::IsEmpty()) << entry.path();
    const std::string written = writeVid(*flight);
    EXPECT_EQ(flightOf(written), *flight) << entry.path();
    EXPECT_EQ(writeVid(flightOf(written)), written) << entry.path();
  }
  EXPECT_GE(count, 23);
}

TEST(VidReader, FilesThatCannotBeRead) {
  const test::TemporaryFolder folder;
  const auto problem = [](const ReadFlight& flight) {
    return flight ? "read" : problemLine("f", flight.error().at(0));
  };
  EXPECT_EQ(problem(readVidFile((folder / "none.vid").string())),
            "f: can't be read: No such file or directory");
  EXPECT_EQ(problem(readVidFile(folder.path().string())), "f: can't be read: Is a directory");
  // A sparse file: nothing of it is read.
  test::writeAll(folder / "large.vid", "");
  std::filesystem::resize_file(folder / "large.vid", (std::uintmax_t{1} << 30) + 1);
  EXPECT_EQ(problem(readVidFile((folder / "large.vid").string())),
            "f: the file has more than 1073741824 bytes");
}

}  // namespace
}  // namespace vides
