// SPDX-License-Identifier: MIT
// What happens between two consecutive orientations, and one moment of it: sections and frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "math/vector.hpp"

namespace vides {

enum class SectionKind : std::uint8_t { kMove, kPan, kRoll, kZoom, kHold };

// "move", "pan", "roll", "zoom" or "hold".
std::string_view name(SectionKind kind);

// The place of an orientation in the chain of all keys' orientations; both count from 0.
struct OrientationPlace {
  std::size_t key = 0;
  std::size_t orientation = 0;
  auto operator<=>(const OrientationPlace&) const = default;
};

// Where the camera is and looks: cube coordinates, unit vectors, zoom 1 to 100.
struct Camera {
  Vec3 viewReferencePoint{0.0};
  Vec3 viewPlaneNormal{0.0, 0.0, 1.0};  // the viewing direction
  Vec3 viewUpVector{0.0, 1.0, 0.0};
  double zoom = 12.0;
  bool operator==(const Camera&) const = default;
};

struct Frame {
  std::int64_t number = 0;   // from 0
  double time = 0.0;         // seconds, number / frame rate
  std::int64_t section = 0;  // index into the list of sections, from 0
  SectionKind kind = SectionKind::kHold;
  Camera camera;
  bool operator==(const Frame&) const = default;
};

// An entry in the list of sections. A hold before a section is an entry of its own, with from ==
// to; sections without frames are left out.
struct Section {
  std::int64_t index = 0;
  SectionKind kind = SectionKind::kHold;
  OrientationPlace from;
  OrientationPlace to;
  double length = 0.0;      // cube units; 0 except for moves
  double angle = 0.0;       // degrees, the full rotation between the end orientations
  std::int64_t frames = 0;  // without the one last frame of an open flight
  std::int64_t firstFrame = 0;
};

}  // namespace vides
