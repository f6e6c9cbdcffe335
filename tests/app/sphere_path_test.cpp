// SPDX-License-Identifier: MIT
// The path on the orientation sphere: near the exact one however long the flight, in bounded work.
#include "panels/sphere_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "flight/flight.hpp"

namespace vides {
namespace {

constexpr double kPixel = 1.0 / 100.0;  // of a sphere of 100 pixels' radius
constexpr double kTolerance = 0.5 * kPixel;

// Looks around in all directions; `sweep` is how far from one key to the next.
Flight lookingAround(int keys, double sweep, double seconds) {
  Flight flight;
  for (int i = 0; i < keys; ++i) {
    Key key;
    const double turn = 0.11 * i;
    key.position = {0.8 * std::cos(turn), 1.6 * i / keys - 0.8, 0.8 * std::sin(turn)};
    Orientation& orientation = key.orientations.front();
    orientation.aimMode = AimMode::kRelative;
    orientation.aim = {std::cos(sweep * i), 0.6 * std::sin(1.7 * sweep * i), std::sin(sweep * i)};
    orientation.duration = seconds;
    flight.keys.push_back(key);
  }
  return flight;
}

double distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length = glm::dot(way, way);
  const double share = length > 0.0 ? std::clamp(glm::dot(p - a, way) / length, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + share * way);
}

double distance(const Vec3& p, const std::vector<std::vector<Vec3>>& lines) {
  double least = 2.0;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      least = std::min(least, distance(p, line[i], line[i + 1]));
    }
  }
  return least;
}

Vec3 direction(const Evaluation& evaluation, double frame) {
  return evaluation.cameraBetween(frame).viewPlaneNormal;
}

// All of the exact path is drawn, and of what is drawn all lies on it.
TEST(SpherePath, IsTheExactOneToAPixel) {
  for (const auto& [keys, sweep, seconds] :
       {std::tuple{5, 1.1, 4000.0}, std::tuple{40, 0.9, 2.0}, std::tuple{190, 0.5, 0.4}}) {
    SCOPED_TRACE(keys);
    const Evaluation evaluation(lookingAround(keys, sweep, seconds));
    SpherePath path;
    path.follow(evaluation, {0, 0}, kTolerance);
    EXPECT_FALSE(path.thinned());
    EXPECT_EQ(path.marks().size(), static_cast<std::size_t>(keys));
    EXPECT_LT(path.evaluated(), SpherePath::kMostEvaluated);
    const double last = static_cast<double>(evaluation.frameCount() - 1);
    std::vector<std::vector<Vec3>> exact(1);
    for (int i = 0; i <= 20000; ++i) exact[0].push_back(direction(evaluation, last * i / 20000));
    for (std::size_t i = 0; i < exact[0].size(); i += 61) {
      ASSERT_LT(distance(exact[0][i], path.lines()), kPixel) << i;
    }
    for (const auto& line : path.lines()) {
      for (std::size_t i = 0; i + 1 < line.size(); i += 7) {
        ASSERT_LT(distance(0.5 * (line[i] + line[i + 1]), exact), kPixel) << i;
      }
    }
  }
}

// Of a flight with more sections than there is room for some are drawn, each as it is.
TEST(SpherePath, OfManySectionsSomeAreFollowedExactly) {
  const Evaluation evaluation(lookingAround(20000, 2.4, 0.4));
  SpherePath path;
  path.follow(evaluation, {7, 0}, kTolerance);
  EXPECT_TRUE(path.thinned());
  EXPECT_LE(path.evaluated(), SpherePath::kMostEvaluated);
  EXPECT_GE(path.lines().size(), SpherePath::kFollowedOfMany / 2);
  EXPECT_LE(path.lines().size(), SpherePath::kFollowedOfMany);
  // Each line is a section's, in the flight's order.
  std::int64_t index = 0;
  for (const auto& line : path.lines()) {
    while (index < evaluation.sectionCount() &&
           direction(evaluation, static_cast<double>(evaluation.section(index).firstFrame)) !=
               line.front()) {
      ++index;
    }
    ASSERT_LT(index, evaluation.sectionCount());
    const Section section = evaluation.section(index);
    const auto first = static_cast<double>(section.firstFrame);
    const auto frames = static_cast<double>(section.frames);
    ASSERT_EQ(direction(evaluation, first + frames), line.back());
    for (int i = 0; i <= 100; ++i) {
      ASSERT_LT(distance(direction(evaluation, first + frames * i / 100), {line}), kPixel);
    }
  }
  const auto current = evaluation.sectionFrom({7, 0});
  ASSERT_TRUE(current && path.currentLines().size() == 1);
  EXPECT_EQ(path.currentLines()[0].front(), evaluation.cameraAt({7, 0}).viewPlaneNormal);
  EXPECT_EQ(path.currentLines()[0].back(), evaluation.cameraAt({8, 0}).viewPlaneNormal);
}

TEST(SpherePath, NothingIsDoneAnewWhereNothingChanged) {
  const Evaluation evaluation(lookingAround(1000, 0.7, 0.4));
  SpherePath path;
  path.follow(evaluation, {0, 0}, kTolerance);
  EXPECT_GT(path.evaluated(), 500u);
  path.follow(evaluation, {0, 0}, kTolerance);
  EXPECT_EQ(path.evaluated(), 0u);
  // A sphere a little larger needs no finer path; another current section only its own.
  path.follow(evaluation, {0, 0}, kTolerance * 0.99);
  EXPECT_EQ(path.evaluated(), 0u);
  path.follow(evaluation, {5, 0}, kTolerance);
  EXPECT_GT(path.evaluated(), 0u);
  EXPECT_LT(path.evaluated(), 64u);
  EXPECT_EQ(path.currentLines()[0].front(), evaluation.cameraAt({5, 0}).viewPlaneNormal);
}

// The camera flies through its aim: no chord runs through the sphere.
TEST(SpherePath, AJumpIsAGap) {
  Flight flight;
  for (const double x : {-0.5, 0.5}) {
    Key key;
    key.position = {x, 0.0, 0.0};
    key.orientations.front().aim = {0.0, 0.0, 0.0};
    key.orientations.front().duration = 4.0;
    flight.keys.push_back(key);
  }
  SpherePath path;
  path.follow(Evaluation(flight), {0, 0}, kTolerance);
  for (const auto& line : path.lines()) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      EXPECT_LT(glm::distance(line[i], line[i + 1]), 0.36);
    }
  }
}

// A closed flight's path comes back to where it began.
TEST(SpherePath, ClosesOverTheSeam) {
  Flight flight = lookingAround(12, 0.6, 1.0);
  flight.closed = true;
  const Evaluation evaluation(flight);
  SpherePath path;
  path.follow(evaluation, {11, 0}, kTolerance);
  ASSERT_EQ(path.lines().size(), 1u);
  EXPECT_LT(glm::distance(path.lines()[0].front(), path.lines()[0].back()), 1e-9);
  EXPECT_LT(
      glm::distance(path.currentLines()[0].back(), evaluation.cameraAt({0, 0}).viewPlaneNormal),
      1e-9);
}

}  // namespace
}  // namespace vides
