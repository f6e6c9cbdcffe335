// SPDX-License-Identifier: MIT
// Measures of quality over a flight's frames (2-flight-model, "Measures").
#pragma once

#include <cstdint>

#include "evaluate/evaluation.hpp"

namespace vides {

struct Quality {
  double maxSpeed = 0.0;         // cube units per second
  double maxAngularSpeed = 0.0;  // degrees per second of the full rotation
  double maxSpeedJump = 0.0;     // largest |b - a| / max(a, b) of neighbouring intervals
  double maxAngularSpeedJump = 0.0;
  std::int64_t framesOutsideCube = 0;
};

// Walks over all frames.
Quality measureQuality(const Evaluation& evaluation);

// The full rotation between two cameras, radians in [0, pi]; exact for small angles.
double rotationBetween(const Camera& a, const Camera& b);

}  // namespace vides
