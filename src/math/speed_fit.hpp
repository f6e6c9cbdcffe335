// SPDX-License-Identifier: MIT
// Speed curves that run through their sections as wished: what dividing a section needs.
//
// The ten values are found by damped least squares over the curves as they are used, limiter and
// neighbours included.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "math/speed_curve.hpp"

namespace vides {

// A curve that is looked for, and where it stands among the others.
struct SpeedWish {
  static constexpr int kSteps = 45;
  // The shares of the way that are to be run at the times 1/kSteps ... (kSteps - 1)/kSteps.
  std::array<double, kSteps - 1> shares{};
  double weight = 1.0;         // how much they count beside the other curves'
  std::optional<double> mean;  // that it must have; nothing where any will do
  // To begin with, and not to be left without need; the result stands here too.
  SpeedValues values{};
  // The curves that it continues: others of the list, or values that stay as they are, or none.
  std::optional<std::size_t> previous, next;
  std::optional<double> before, after;
  // A curve outside the list continues with these values: they stay as they are.
  bool keepsFirst = false;
  bool keepsLast = false;
};

// The largest difference between the shares that `curve` runs and the wished ones.
double shareError(const SpeedCurve& curve, const SpeedWish& wish);

// Fits all of them together, each value in [1, 100].
void fitSpeeds(std::vector<SpeedWish>& wishes);

}  // namespace vides
