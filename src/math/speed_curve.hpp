// SPDX-License-Identifier: MIT
// The hand-drawn speed of a section over its time (paper 5.2), limited so that it never leaves
// [1, 100].
//
// Ten values v_0...v_9 at the times tau = j/9, joined by cubic Hermite pieces with Catmull-Rom
// slopes; the slopes are clamped so that the curve stays in [1, 100] (2-flight-model, "Speed").
#pragma once

#include <array>
#include <optional>

namespace vides {

inline constexpr int kSpeedValues = 10;
inline constexpr double kBaseSpeed = 50.0;
inline constexpr double kMinSpeed = 1.0;
inline constexpr double kMaxSpeed = 100.0;

using SpeedValues = std::array<double, kSpeedValues>;

class SpeedCurve {
 public:
  // `before` is the last value of the previous section's curve, `after` the first of the next
  // one's; nothing where the flight ends: the curve then continues linearly.
  explicit SpeedCurve(const SpeedValues& values, std::optional<double> before = std::nullopt,
                      std::optional<double> after = std::nullopt);
  SpeedCurve();  // constant base speed
  // The curve as it is drawn by hand, without the limiter: it may leave [1, 100]. For pictures
  // only.
  static SpeedCurve unlimited(const SpeedValues& values, std::optional<double> before,
                              std::optional<double> after);

  // The speed at tau in [0, 1].
  double at(double tau) const;
  // Its derivative by tau.
  double derivative(double tau) const;
  // F(tau), the integral of the speed from 0 to tau; F(1) is the mean.
  double integral(double tau) const;
  double mean() const { return sums_[kSpeedValues - 1]; }
  // F(tau)/F(1): the share of the way that is done; exactly 0 at 0 and 1 at 1.
  double progress(double tau) const;
  // The limited slopes m_j, per interval (not per unit of tau).
  const SpeedValues& slopes() const { return slopes_; }
  const SpeedValues& values() const { return values_; }
  bool operator==(const SpeedCurve&) const = default;

 private:
  void sum();

  SpeedValues values_;
  SpeedValues slopes_;
  SpeedValues sums_;  // F(j/9)
};

// The slopes before limiting, to show where the limiter acts.
SpeedValues unlimitedSlopes(const SpeedValues& values, std::optional<double> before,
                            std::optional<double> after);

}  // namespace vides
