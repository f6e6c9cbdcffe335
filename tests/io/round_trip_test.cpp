// SPDX-License-Identifier: MIT
// What is written is read back the same, and written again it has the same bytes: random flights,
// members that vides doesn't know, every locale.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "flight/validation.hpp"
#include "io/problem_text.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"
#include "support/german_locale.hpp"
#include "support/property.hpp"
#include "support/random_document.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

using test::Random;

std::string lines(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) text += problemLine("f", problem) + "\n";
  return text;
}

// Empty if it is so, else what is wrong.
std::string roundTrip(const Flight& flight) {
  const std::string text = writeVid(flight);
  if (!nlohmann::json::accept(text) && text.find("1e999") == text.npos) return "not JSON\n" + text;
  const ReadFlight read = readVid(text);
  if (!read) return lines(read.error()) + text;
  if (!(*read == flight)) return "not the same flight\n" + text;
  if (writeVid(*read) != text) return "not the same bytes\n" + text;
  return {};
}

TEST(RoundTrip, RandomFlights) {
  test::holdsFor(10'000, [] {
    Random random(*test::seeds());
    const Flight flight = test::randomDocument(random, *rc::gen::inRange(2, 7));
    RC_ASSERT(validate(flight).empty());
    RC_ASSERT(roundTrip(flight) == "");
  });
}

TEST(RoundTrip, FlightsThatAreHardToEvaluate) {
  test::holdsFor(2000, [] {
    Random random(*test::seeds());
    const Flight flight = test::randomFlight(random, {.nasty = random.coin()});
    RC_ASSERT(validate(flight).empty());
    RC_ASSERT(roundTrip(flight) == "");
  });
}

TEST(RoundTrip, RandomFlightsInGerman) {
  const test::GermanLocale german;
  test::holdsFor(1000, [] {
    Random random(*test::seeds());
    const Flight flight = test::randomDocument(random, *rc::gen::inRange(2, 7));
    RC_ASSERT(roundTrip(flight) == "");
  });
}

TEST(RoundTrip, TheSameBytesInGerman) {
  Random random(1);
  const Flight flight = test::randomDocument(random, 50);
  const std::string text = writeVid(flight);
  const test::GermanLocale german;
  EXPECT_EQ(writeVid(flight), text);
  EXPECT_EQ(readVid(text).value(), flight);
}

TEST(Validation, TellsWhatTheReaderTells) {
  test::holdsFor(10'000, [] {
    Random random(*test::seeds());
    Flight flight = test::randomDocument(random, *rc::gen::inRange(2, 5));
    for (int faults = static_cast<int>(random.bits() % 3); faults >= 0; --faults) {
      test::spoil(random, flight);
      if (flight.keys.size() < 2) break;  // nothing to spoil there any more
    }
    const std::vector<Problem> problems = validate(flight);
    RC_ASSERT(!problems.empty());
    const ReadFlight read = readVid(writeVid(flight));
    RC_ASSERT(!read.has_value());
    RC_ASSERT(lines(read.error()) == lines(problems));
    RC_ASSERT(read.error() == problems);
  });
}

// An x_ member in every object, with everything that a generic parser would lose.
const std::string kKept =
    R"({ "big":1E400 , "same": [1.0,1.00, -0,1e2], "\u00e4\/":"\u00E4\ud83d\udee9",
   "deep": [[[[{}]]]] })";

std::string everywhere(const std::string& value) {
  const std::string x = R"("x_note": )" + value;
  const std::string shape = R"({ "tension": 0, "continuity": 0, "bias": 0, )" + x + " }";
  std::string presets = shape;
  for (int i = 0; i < 9; ++i) presets += ",\n    " + shape;
  const std::string orientation = R"({
          "aim": [0, 0.5, 0],
          "aim_mode": "absolute",
          "roll": 0,
          "zoom": 12,
          "speed": [50, 50, 50, 50, 50, 50, 50, 50, 50, 50],
          "hold": 0,
          )" + x + "\n        }";
  const auto key = [&](const std::string& px) {
    return "{\n      \"position\": [" + px + R"(, 0, 0],
      "shape": { "preset": 0, )" +
           x + " },\n      \"orientations\": [\n        " + orientation + "\n      ],\n      " + x +
           "\n    }";
  };
  return R"({
  "format": "vides",
  "version": 1,
  "name": "",
  "frame_rate": 25,
  "picture": { "width": 1920, "height": 1080, )" +
         x + R"( },
  "lens": { "sensor_width_mm": 36, "focal_length_mm": [12, 210], )" +
         x + R"( },
  "space": { "center": [0, 0, 0], "half_size": 1, )" +
         x + R"( },
  "rates": { "move": 100, "pan": 100, "roll": 100, "zoom": 100, )" +
         x + R"( },
  "closed": false,
  "orientation_curve": "smooth",
  "presets": [
    )" + presets +
         "\n  ],\n  \"keys\": [\n    " + key("0") + ",\n    " + key("0.5") +
         "\n  ],\n  \"scene\": [ { \"file\": \"a.obj\", " + x + " }, { \"file\": \"b.obj\", " + x +
         " } ],\n  " + x + "\n}\n";
}

TEST(RoundTrip, ExtraMembersEverywhereByteForByte) {
  for (const std::string& value : {std::string("null"), std::string("1e999"), kKept}) {
    const std::string text = everywhere(value);
    const ReadFlight flight = readVid(text);
    ASSERT_TRUE(flight) << lines(flight.error());
    EXPECT_EQ(writeVid(*flight), text);
  }
}

TEST(RoundTrip, ExtraMembersKeepTheirOrderAndTheirNames) {
  const std::string members = R"("x_z": 1,
  "x_\u0061": 2,
  "x_": 3,
  "x_ \"q\"": 4)";
  const std::string plain = writeVid(newFlight());
  const std::string text = plain.substr(0, plain.size() - 3) + ",\n  " + members + "\n}\n";
  const ReadFlight flight = readVid(text);
  ASSERT_TRUE(flight) << lines(flight.error());
  EXPECT_EQ(writeVid(*flight), text);
  // Also where they stood between the others.
  const ReadFlight mixed = readVid("{" + members + "," + plain.substr(1));
  ASSERT_TRUE(mixed) << lines(mixed.error());
  EXPECT_EQ(writeVid(*mixed), text);
}

}  // namespace
}  // namespace vides
