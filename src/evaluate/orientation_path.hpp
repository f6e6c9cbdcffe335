// SPDX-License-Identifier: MIT
// How VPN and VUP go through one section: what the orientation methods (2-flight-model,
// "Orientation curves") are given, and what they make of it.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>

#include "flight/flight.hpp"
#include "math/cubic_segment.hpp"
#include "math/quaternion.hpp"

namespace vides {

struct ViewDirection {
  Vec3 viewPlaneNormal{0.0, 0.0, 1.0};
  Vec3 viewUpVector{0.0, 1.0, 0.0};
};

ViewDirection viewDirection(const Quaternion& q);

// Where in its section a camera stands.
struct PathContext {
  double progress = 0.0;  // in [0, 1)
  Vec3 position{0.0};     // the VRP there, cube coordinates
};

// The way through one section, of whatever method made it: any value that can be copied bit by bit
// and has `ViewDirection at(const PathContext&) const`. Small ones lie in the path itself.
class OrientationPath {
 public:
  OrientationPath() : OrientationPath(ConstantPath{}) {}
  template <class Way>
  explicit OrientationPath(const Way& way) : at_(&atOf<Way>) {
    static_assert(std::is_trivially_copyable_v<Way> && alignof(Way) <= alignof(double));
    if constexpr (sizeof(Way) <= kRoom) {
      new (room_.data()) Way(way);
    } else {
      shared_ = std::make_shared<const Way>(way);
    }
  }

  ViewDirection at(const PathContext& context) const {
    return at_(shared_ ? shared_.get() : room_.data(), context);
  }

 private:
  // Three arcs of a sphere, which is what most methods come to.
  static constexpr std::size_t kRoom = 3 * sizeof(SlerpArc);
  struct ConstantPath {
    ViewDirection at(const PathContext&) const { return {}; }
  };
  template <class Way>
  static ViewDirection atOf(const void* way, const PathContext& context) {
    return std::launder(static_cast<const Way*>(way))->at(context);
  }

  ViewDirection (*at_)(const void* way, const PathContext& context);
  std::shared_ptr<const void> shared_;
  alignas(double) std::array<std::byte, kRoom> room_{};
};

// A curve of quaternions as a way: `Quaternion at(double progress) const`.
template <class Curve>
struct TurningPath {
  Curve curve;
  ViewDirection at(const PathContext& context) const {
    return viewDirection(curve.at(context.progress));
  }
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
  PathSection section;
  std::optional<PathSection> previous;
  std::optional<PathSection> next;
  bool restsBefore = false;  // a hold lies in the joint (or the open end) before the section
  bool restsAfter = false;
};

}  // namespace vides
