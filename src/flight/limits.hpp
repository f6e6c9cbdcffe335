// SPDX-License-Identifier: MIT
// Every range of the file format (3-vid-format), named once: for the reader, the validation and
// the panels.
#pragma once

#include <cstddef>
#include <limits>

#include "flight/flight.hpp"

namespace vides {

// The finite numbers from min to max, without min itself where minOpen is set.
struct Range {
  double min = 0.0;
  double max = 0.0;
  bool minOpen = false;
  constexpr bool contains(double value) const {
    return value <= max && (minOpen ? value > min : value >= min);
  }
};

struct CountRange {
  std::size_t min = 0;
  std::size_t max = 0;
  constexpr bool contains(std::size_t count) const { return min <= count && count <= max; }
};

namespace limits {

inline constexpr double kFinite = std::numeric_limits<double>::max();

inline constexpr int kVersion = 1;                      // of the file format
inline constexpr std::size_t kNameCharacters = 1000;    // code points
inline constexpr Range kFrameRate{0.01, 1000};          // frames per second
inline constexpr Range kPictureSize{1, 65536};          // pixels, whole
inline constexpr Range kSensorWidth{0, kFinite, true};  // millimetres
inline constexpr Range kFocalLength{0, kFinite, true};  // millimetres
inline constexpr Range kSpaceHalfSize{1e-6, 1e9};       // scene units
inline constexpr double kSpaceCenterDistance = 1e9;     // scene units, from the origin
inline constexpr Range kRate{1e-3, 1e6};                // frames
inline constexpr Range kShape{-1, 1};                   // tension, continuity, bias
inline constexpr Range kPosition{-1, 1};                // cube coordinates
inline constexpr Range kPreset{0, kPresets - 1};        // whole
inline constexpr Range kAim{-1e6, 1e6};                 // cube coordinates
inline constexpr double kAimDistance = 1e-9;            // of the aim point from its key, at least
inline constexpr Range kRoll{-36000, 36000};            // degrees
inline constexpr Range kZoom{kMinZoom, kMaxZoom};
inline constexpr Range kSpeed{kMinSpeed, kMaxSpeed};
inline constexpr Range kDuration{0, 86400, true};  // seconds
inline constexpr Range kHold{0, 86400};            // seconds
inline constexpr CountRange kKeys{2, 1'000'000};
inline constexpr CountRange kOrientations{1, kMostOrientations};
inline constexpr std::size_t kFrames = 2'000'000'000;           // of a whole flight
inline constexpr std::size_t kNesting = 32;                     // objects and arrays in one another
inline constexpr std::size_t kFileSize = std::size_t{1} << 30;  // bytes

}  // namespace limits
}  // namespace vides
