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
  bool operator==(const Quality&) const = default;
};

// Measures frames one by one, in order: for those who walk over them anyway.
class QualityMeter {
 public:
  explicit QualityMeter(double frameRate) : frameRate_(frameRate) {}
  void add(const Frame& frame);
  // Of the frames so far.
  const Quality& quality() const { return quality_; }

 private:
  double frameRate_;
  std::int64_t frames_ = 0;
  Camera before_;
  double speed_ = 0.0;  // between the last two frames: cube units per second
  double turn_ = 0.0;   // degrees per second
  Quality quality_;
};

// Walks over all frames.
Quality measureQuality(const Evaluation& evaluation);
// Only those from `first` up to, not including, `last`, and how they follow on those before. Parts
// that touch make up the whole, bit for bit: what many cores measure equals what one does.
Quality measureQuality(const Evaluation& evaluation, std::int64_t first, std::int64_t last);
// Of two parts together.
Quality together(const Quality& a, const Quality& b);

// The full rotation between two cameras, radians in [0, pi]; exact for small angles.
double rotationBetween(const Camera& a, const Camera& b);

}  // namespace vides
