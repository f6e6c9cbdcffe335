// SPDX-License-Identifier: MIT
// From the zoom to focal length and field of view (2-flight-model, "Lens").
#pragma once

namespace vides {

inline constexpr double kMinZoom = 1.0;
inline constexpr double kMaxZoom = 100.0;

struct Lens {
  double sensorWidth = 36.0;         // millimetres, > 0
  double focalLengthAtZoom1 = 12.0;  // millimetres, > 0
  double focalLengthAtZoom100 = 210.0;
  bool operator==(const Lens&) const = default;

  // Millimetres; linear in the zoom.
  double focalLength(double zoom) const;
  // Radians, across the picture's width.
  double horizontalFieldOfView(double zoom) const;
  // Radians, over the picture's height; `width` and `height` in the same unit.
  double verticalFieldOfView(double zoom, double width, double height) const;
};

}  // namespace vides
