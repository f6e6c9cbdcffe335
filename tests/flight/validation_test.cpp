// SPDX-License-Identifier: MIT
// The checks of single values and keys. (That validate() tells what the reader tells is tested with
// the reader.)
#include "flight/validation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "flight/utf8.hpp"

namespace vides {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Range, EndsAndWhatIsNoNumber) {
  EXPECT_TRUE(limits::kZoom.contains(1));
  EXPECT_TRUE(limits::kZoom.contains(100));
  EXPECT_FALSE(limits::kZoom.contains(std::nextafter(1, 0)));
  EXPECT_FALSE(limits::kZoom.contains(std::nextafter(100, 200)));
  EXPECT_FALSE(limits::kDuration.contains(0));
  EXPECT_TRUE(limits::kDuration.contains(5e-324));
  for (const Range& range : {limits::kZoom, limits::kDuration, limits::kSensorWidth}) {
    EXPECT_FALSE(range.contains(kNan));
    EXPECT_FALSE(range.contains(kInfinity));
    EXPECT_FALSE(range.contains(-kInfinity));
  }
}

TEST(Validation, NewFlightIsValid) { EXPECT_THAT(validate(newFlight()), testing::IsEmpty()); }

TEST(Validation, NotANumberIsToldEverywhere) {
  Flight flight = newFlight();
  flight.frameRate = kNan;
  flight.lens.sensorWidth = kInfinity;
  flight.space.center.y = kNan;
  flight.rates.zoom = kNan;
  flight.presets[3].bias = kNan;
  Key key = flight.keys[1];
  key.position.z = kNan;
  key.orientations[0].aim.x = -kInfinity;
  key.orientations[0].speed[4] = kNan;
  key.orientations[0].duration = kNan;
  flight.keys.set(1, key);
  std::vector<std::string> pointers;
  for (const Problem& problem : validate(flight)) {
    EXPECT_EQ(problem.code, ProblemCode::kOutOfRange);
    pointers.push_back(problem.pointer);
  }
  EXPECT_THAT(pointers, testing::ElementsAre(
                            "/frame_rate", "/lens/sensor_width_mm", "/space/center", "/rates/zoom",
                            "/presets/3/bias", "/keys/1/position/2", "/keys/1/orientations/0/aim/0",
                            "/keys/1/orientations/0/speed/4", "/keys/1/orientations/0/duration"));
}

TEST(Validation, AtMostTwenty) {
  Flight flight = newFlight();
  Key key = flight.keys[0];
  key.position = {2, 2, 2};
  flight.keys = KeyList{key, key, key, key, key, key, key, key};
  EXPECT_EQ(validate(flight).size(), kMostProblems);
}

TEST(Validation, OfOneKey) {
  Flight flight = newFlight();
  EXPECT_FALSE(checkKey(flight, 1).has_value());
  Key key = flight.keys[1];
  setAimPoint(key, key.orientations[0], key.position + Vec3(0, 1e-10, 0));
  key.orientations[0].zoom = 101;
  const auto problem = checkKey(key, 7);
  ASSERT_TRUE(problem.has_value());
  EXPECT_EQ(problem->pointer, "/keys/7/orientations/0/aim");
  EXPECT_EQ(problem->code, ProblemCode::kAimAtKey);
}

TEST(Validation, AimDistance) {
  const Vec3 key(0.25, 0.5, -1);
  EXPECT_TRUE(checkAimDistance(key, AimMode::kAbsolute, key, "/p"));
  EXPECT_TRUE(checkAimDistance(key, AimMode::kRelative, Vec3(0, 9.9e-10, 0), "/p"));
  EXPECT_FALSE(checkAimDistance(key, AimMode::kRelative, Vec3(0, 1e-9, 0), "/p"));
  EXPECT_FALSE(checkAimDistance(key, AimMode::kRelative, key, "/p"));
  EXPECT_TRUE(checkAimDistance(key, AimMode::kRelative, Vec3(kNan), "/p"));
}

TEST(Validation, SingleValues) {
  EXPECT_FALSE(checkInteger(1920, limits::kPictureSize, "/p"));
  EXPECT_EQ(checkInteger(1920.5, limits::kPictureSize, "/p")->code, ProblemCode::kWrongType);
  EXPECT_EQ(checkInteger(0, limits::kPictureSize, "/p")->code, ProblemCode::kOutOfRange);
  EXPECT_FALSE(checkName(std::string(1000, 'x'), "/name"));
  EXPECT_FALSE(checkName("", "/name"));
  std::string characters;
  for (int i = 0; i < 1000; ++i) characters += "ü";
  EXPECT_FALSE(checkName(characters, "/name"));
  EXPECT_TRUE(checkName(characters + "x", "/name"));
  EXPECT_TRUE(checkName("\xff", "/name"));
  EXPECT_FALSE(checkPath("a/b.obj", "/p"));
  EXPECT_TRUE(checkPath("", "/p"));
  EXPECT_TRUE(checkPath(std::string("a\0b", 3), "/p"));
  EXPECT_FALSE(checkSpaceCenter({1e9, 0, 0}, "/p"));
  EXPECT_TRUE(checkSpaceCenter({1e9, 1e3, 0}, "/p"));
  EXPECT_TRUE(checkSpaceCenter({1e200, 1e200, 0}, "/p"));
}

TEST(Problem, PointersAreEscapedAndLongNamesCut) {
  EXPECT_EQ(pointerToken("a/b~c"), "/a~1b~0c");
  EXPECT_EQ(pointerToken(""), "/");
  const std::string token = pointerToken(std::string(119, 'x') + "üyz");
  EXPECT_EQ(token, "/" + std::string(119, 'x') + "…");  // not in the middle of the ü
  EXPECT_EQ(shortened(std::string(60, 'x')), std::string(60, 'x'));
}

TEST(Utf8, WellFormedSequencesOnly) {
  EXPECT_EQ(codePoints("aä€🛩"), 4U);
  EXPECT_EQ(codePoints("\xf4\x8f\xbf\xbf"), 1U);  // U+10FFFF
  for (const char* bad :
       {"\x80", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
        "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xc3", "\xe2\x82", "\xf0\x9f\x9b", "a\xffz"}) {
    EXPECT_FALSE(codePoints(bad).has_value()) << bad;
  }
}

}  // namespace
}  // namespace vides
