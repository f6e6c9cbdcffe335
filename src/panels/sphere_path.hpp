// SPDX-License-Identifier: MIT
// The way of the VPN on the unit sphere as polylines that stray less than a tolerance from it.
//
// Sections are followed whole or not at all: of a flight with many of them as many as there is room
// for are taken, evenly over the flight, so that the work has a bound and no chord cuts across.
// Where the VPN jumps (the camera flies through its aim) there is a gap.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evaluate/evaluation.hpp"

namespace vides {

class SpherePath {
 public:
  // With more sections, or keys, only some are followed, or marked.
  static constexpr std::size_t kMostFollowed = 200;
  static constexpr std::size_t kFollowedOfMany = 60;
  // Cameras that are evaluated for a path, about: past that, what is not yet exact has gaps.
  static constexpr std::size_t kMostEvaluated = 6000;

  struct Mark {
    OrientationPlace place;
    Vec3 direction{0.0};
  };

  // Call before the rest. `tolerance` is a distance in radii; it is taken as the power of two
  // below. Nothing is done anew unless the evaluation, that power or `current` is another one.
  void follow(const Evaluation& evaluation, const OrientationPlace& current, double tolerance);

  // Polylines of unit vectors, no two of them touching.
  const std::vector<std::vector<Vec3>>& lines() const { return lines_; }
  // That of the current orientation's section, always there where it has frames.
  const std::vector<std::vector<Vec3>>& currentLines() const { return currentLines_; }
  const std::vector<Mark>& marks() const { return marks_; }
  // Whether only some are followed and marked.
  bool thinned() const { return thinned_; }
  // Cameras evaluated by the last follow().
  std::size_t evaluated() const { return evaluated_; }

 private:
  using Lines = std::vector<std::vector<Vec3>>;
  struct Point {
    double frame = 0.0;
    Vec3 direction{0.0};
  };
  Point at(const Section& section, double frame);
  void add(Lines& lines, const Section& section);
  void refine(Lines& lines, const Section& section, const Point& a, const Point& b, int depth);
  void addPath();
  void addMarks();

  std::optional<Evaluation> evaluation_;
  OrientationPlace current_;
  double tolerance_ = 0.0;
  Lines lines_, currentLines_;
  std::vector<Mark> marks_;
  bool thinned_ = false;
  std::size_t evaluated_ = 0;
};

}  // namespace vides
