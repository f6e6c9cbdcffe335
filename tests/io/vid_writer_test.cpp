// SPDX-License-Identifier: MIT
// The bytes of `.vid` files.
#include "io/vid_writer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/vid_reader.hpp"
#include "support/files.hpp"

namespace vides {
namespace {

TEST(VidWriter, LayoutOfTheSpecification) {
  Flight flight = newFlight();
  flight.name = "Around the \"pyramid\"";
  Key key = flight.keys[0];
  key.shape.preset = KeyShape::kOwn;
  key.shape.own = {0.5, -0.25, 1};
  key.orientations[0].duration = 2.5;
  Orientation second;
  second.aim = {1e-7, -0.0, 1e6};
  second.aimMode = AimMode::kRelative;
  second.roll = -0.0;
  key.orientations.push_back(second);
  flight.keys.set(0, key);
  flight.scene = {{"pyramid.obj"}};
  EXPECT_EQ(writeVid(flight), R"({
  "format": "vides",
  "version": 1,
  "name": "Around the \"pyramid\"",
  "frame_rate": 25,
  "picture": { "width": 1920, "height": 1080 },
  "lens": { "sensor_width_mm": 36, "focal_length_mm": [12, 210] },
  "space": { "center": [0, 0, 0], "half_size": 1 },
  "rates": { "move": 100, "pan": 100, "roll": 100, "zoom": 100 },
  "closed": false,
  "orientation_curve": "smooth",
  "presets": [
    { "tension": 0, "continuity": 0, "bias": 0 },
    { "tension": 0.3, "continuity": 0, "bias": 0 },
    { "tension": 0.6, "continuity": 0, "bias": 0 },
    { "tension": -0.3, "continuity": 0, "bias": 0 },
    { "tension": -0.6, "continuity": 0, "bias": 0 },
    { "tension": 0, "continuity": -0.5, "bias": 0 },
    { "tension": 0, "continuity": 0.5, "bias": 0 },
    { "tension": 0, "continuity": 0, "bias": 0.5 },
    { "tension": 0, "continuity": 0, "bias": -0.5 },
    { "tension": 0, "continuity": 0, "bias": 0 }
  ],
  "keys": [
    {
      "position": [-0.5, 0.2, 0.8],
      "shape": { "tension": 0.5, "continuity": -0.25, "bias": 1 },
      "orientations": [
        {
          "aim": [0, 0, 0],
          "aim_mode": "absolute",
          "roll": 0,
          "zoom": 12,
          "speed": [50, 50, 50, 50, 50, 50, 50, 50, 50, 50],
          "duration": 2.5,
          "hold": 0
        },
        {
          "aim": [1e-07, 0, 1000000],
          "aim_mode": "relative",
          "roll": 0,
          "zoom": 12,
          "speed": [50, 50, 50, 50, 50, 50, 50, 50, 50, 50],
          "hold": 0
        }
      ]
    },
    {
      "position": [0.5, 0.2, 0.8],
      "shape": { "preset": 0 },
      "orientations": [
        {
          "aim": [0, 0, 0],
          "aim_mode": "absolute",
          "roll": 0,
          "zoom": 12,
          "speed": [50, 50, 50, 50, 50, 50, 50, 50, 50, 50],
          "hold": 0
        }
      ]
    }
  ],
  "scene": [ { "file": "pyramid.obj" } ]
}
)");
}

TEST(VidWriter, EmptySceneAndSeveralFiles) {
  Flight flight = newFlight();
  EXPECT_NE(writeVid(flight).find("\n  \"scene\": []\n}\n"), std::string::npos);
  flight.scene = {{"a.obj"}, {"b/ü.ply"}};
  EXPECT_NE(writeVid(flight).find(
                "\n  \"scene\": [ { \"file\": \"a.obj\" }, { \"file\": \"b/ü.ply\" } ]\n}\n"),
            std::string::npos);
}

// Only where they aren't at their default, before what vides doesn't know.
TEST(VidWriter, HowAScenePointsUpAndWhetherItIsShown) {
  Flight flight = newFlight();
  flight.scene = {{"a.obj", UpAxis::kY, false}, {"b.obj", UpAxis::kMinusX}, {"c.obj"}};
  flight.scene[0].up = UpAxis::kZ;
  const std::string text = writeVid(flight);
  EXPECT_NE(
      text.find("\n  \"scene\": [ { \"file\": \"a.obj\", \"up\": \"z\", \"visible\": false }, "
                "{ \"file\": \"b.obj\", \"up\": \"-x\" }, { \"file\": \"c.obj\" } ]\n}\n"),
      std::string::npos);
  const std::string extra =
      "{ \"file\": \"a.obj\", \"up\": \"z\", \"visible\": false, \"x_a\": 1 }";
  std::string more = text;
  more.replace(more.find("{ \"file\": \"a.obj\""), extra.size() - 10, extra);
  const auto read = readVid(more);
  ASSERT_TRUE(read);
  EXPECT_EQ(writeVid(*read), more);
}

TEST(VidWriter, StringsWithEveryCharacter) {
  std::string name;
  for (int c = 0; c < 0x80; ++c) name += static_cast<char>(c);
  name += "äß€🛩\u2028";
  std::string text;
  appendJsonString(text, name);
  // Another reader agrees.
  EXPECT_EQ(nlohmann::json::parse(text).get<std::string>(), name);
  EXPECT_NE(text.find("\\u0000\\u0001"), std::string::npos);
  EXPECT_NE(text.find("\\b\\t\\n\\u000b\\f\\r"), std::string::npos);
}

TEST(VidWriter, NumbersReadBackTheSame) {
  for (const double value : {20.0, 0.1, 1e15, 1e16, 1e21, 1e-4, 1e-5, 1e-7, 5e-324, 1.0 / 3.0,
                             1.7976931348623157e308, 123456789012345680.0, -2.5e-300}) {
    std::string text;
    appendJsonNumber(text, value);
    EXPECT_EQ(nlohmann::json::parse(text).get<double>(), value) << text;
  }
  std::string zero;
  appendJsonNumber(zero, -0.0);
  EXPECT_EQ(zero, "0");
}

TEST(VidWriter, StopsWhenTheSinkIsFull) {
  Flight flight = newFlight();
  for (int i = 0; i < 2000; ++i) flight.keys.push_back(flight.keys[0]);
  int pieces = 0;
  EXPECT_FALSE(writeVid(flight, [&](std::string_view) { return ++pieces < 3; }));
  EXPECT_EQ(pieces, 3);
}

TEST(SaveVid, SavesWhatIsRead) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "new.vid").string();
  EXPECT_FALSE(saveVid(newFlight(), path).has_value());
  EXPECT_EQ(test::readAll(path), writeVid(newFlight()));
  EXPECT_EQ(readVidFile(path).value(), newFlight());
}

TEST(SaveVid, RefusesWhatCouldNotBeReadBack) {
  const test::TemporaryFolder folder;
  Flight flight = newFlight();
  flight.frameRate = 0;
  const auto problem = saveVid(flight, (folder / "bad.vid").string());
  ASSERT_TRUE(problem.has_value());
  EXPECT_EQ(problem->pointer, "/frame_rate");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace vides
