// SPDX-License-Identifier: MIT
// How VPN and VUP go through one section: the three orientation curves of 2-flight-model.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "flight/flight.hpp"
#include "math/cubic_segment.hpp"
#include "math/quaternion.hpp"

namespace vides {

struct ViewDirection {
  Vec3 viewPlaneNormal{0.0, 0.0, 1.0};
  Vec3 viewUpVector{0.0, 1.0, 0.0};
};

ViewDirection viewDirection(const Quaternion& q);

// A move that keeps looking at one point: VPN from the position, roll by a cubic in the progress.
struct TrackingPath {
  Vec3 aim{0.0};            // cube coordinates
  double rollStart = 0.0;   // radians
  double rollChange = 0.0;  // radians
  double slopeStart = 0.0;  // d roll / d progress at both ends, radians
  double slopeEnd = 0.0;
  Quaternion start{1.0, 0.0, 0.0, 0.0};  // taken where the camera stands on the aim

  ViewDirection at(double progress, const Vec3& position) const;
};

struct ConstantPath {
  Quaternion q{1.0, 0.0, 0.0, 0.0};
};

class OrientationPath {
 public:
  OrientationPath() = default;
  template <class Curve>
  explicit OrientationPath(Curve curve) : curve_(std::move(curve)) {}

  // progress in [0, 1); `position` is the VRP there.
  ViewDirection at(double progress, const Vec3& position) const;

 private:
  std::variant<ConstantPath, SlerpArc, SchlagCurve, SphericalBezier, TrackingPath> curve_;
};

// What the orientation curve needs to know of a section: its ends with the sign that makes them
// neighbours, how much work it is, and, for moves, the curve.
struct PathSection {
  Quaternion start{1.0, 0.0, 0.0, 0.0};
  Quaternion end{1.0, 0.0, 0.0, 0.0};
  double work = 0.0;                    // h = exact frames times mean speed
  bool hold = false;                    // nothing differs
  bool tracking = false;                // a move between absolute aims on one point
  Vec3 aim{0.0};                        // where tracking
  double rollStart = 0.0;               // radians, as the start orientation has it
  double rollChange = 0.0;              // radians, in [-pi, pi]
  const CubicSegment* curve = nullptr;  // where tracking
  double length = 0.0;                  // where tracking

  bool still() const;
  // log(end start^-1) / work: half the angular velocity per unit of work, world axes.
  Vec3 turnRate() const;
  double rollRate() const { return rollChange / work; }
};

// A section with its neighbours, if it has any. The neighbours' ends carry signs such that
// previous->end is the same sheet of the 3-sphere as section.start, next->start as section.end.
struct PathInput {
  OrientationCurve curve = OrientationCurve::kSmooth;
  PathSection section;
  std::optional<PathSection> previous;
  std::optional<PathSection> next;
  bool restsBefore = false;  // a hold lies in the joint (or the open end) before the section
  bool restsAfter = false;
};

OrientationPath makeOrientationPath(const PathInput& input);

}  // namespace vides
