// SPDX-License-Identifier: MIT
// The hand-drawn speed of a section: slopes, limiter, exact integral.
#include "math/speed_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vides {
namespace {

constexpr std::size_t kLast = kSpeedValues - 1;
constexpr double kIntervals = kSpeedValues - 1;

SpeedValues constant(double value) {
  SpeedValues values;
  values.fill(value);
  return values;
}

// Clamps the slopes so that no Bezier ordinate v +- m/3 inside the section leaves [1, 100]; the
// curve then lies in their hull.
void limit(const SpeedValues& values, SpeedValues& slopes) {
  for (std::size_t j = 0; j < values.size(); ++j) {
    const double down = 3.0 * (values[j] - kMinSpeed), up = 3.0 * (kMaxSpeed - values[j]);
    if (j < kLast) slopes[j] = std::clamp(slopes[j], -down, up);
    if (j > 0) slopes[j] = std::clamp(slopes[j], -up, down);
  }
}

// One Hermite piece in its own parameter u in [0, 1], as powers of u.
struct Piece {
  double v, m, c2, c3;

  double at(double u) const { return v + u * (m + u * (c2 + u * c3)); }
  double slope(double u) const { return m + u * (2.0 * c2 + u * (3.0 * c3)); }
  double integral(double u) const {
    return u * (v + u * (0.5 * m + u * (c2 / 3.0 + u * (0.25 * c3))));
  }
};

Piece pieceAt(const SpeedValues& values, const SpeedValues& slopes, std::size_t j) {
  const double rise = values[j + 1] - values[j];
  return {values[j], slopes[j], 3.0 * rise - 2.0 * slopes[j] - slopes[j + 1],
          slopes[j] + slopes[j + 1] - 2.0 * rise};
}

struct Place {
  std::size_t interval;
  double u;
};

Place placeOf(double tau) {
  const double x = tau * kIntervals;
  const std::size_t j = std::min(static_cast<std::size_t>(x), kLast - 1);
  return {j, x - static_cast<double>(j)};
}

}  // namespace

SpeedValues unlimitedSlopes(const SpeedValues& values, std::optional<double> before,
                            std::optional<double> after) {
  const double first = before.value_or(2.0 * values[0] - values[1]);
  const double last = after.value_or(2.0 * values[kLast] - values[kLast - 1]);
  SpeedValues slopes;
  slopes[0] = 0.5 * (values[1] - first);
  for (std::size_t j = 1; j < kLast; ++j) slopes[j] = 0.5 * (values[j + 1] - values[j - 1]);
  slopes[kLast] = 0.5 * (last - values[kLast - 1]);
  return slopes;
}

SpeedCurve::SpeedCurve() : SpeedCurve(constant(kBaseSpeed)) {}

SpeedCurve::SpeedCurve(const SpeedValues& values, std::optional<double> before,
                       std::optional<double> after)
    : values_(values), slopes_(unlimitedSlopes(values, before, after)) {
  limit(values_, slopes_);
  sum();
}

SpeedCurve SpeedCurve::unlimited(const SpeedValues& values, std::optional<double> before,
                                 std::optional<double> after) {
  SpeedCurve curve;
  curve.values_ = values;
  curve.slopes_ = unlimitedSlopes(values, before, after);
  curve.sum();
  return curve;
}

void SpeedCurve::sum() {
  sums_[0] = 0.0;
  double sum = 0.0;
  for (std::size_t j = 0; j < kLast; ++j) {
    sum += 0.5 * (values_[j] + values_[j + 1]) + (slopes_[j] - slopes_[j + 1]) / 12.0;
    sums_[j + 1] = sum / kIntervals;
  }
}

double SpeedCurve::at(double tau) const {
  if (!(tau > 0.0)) return values_.front();
  if (tau >= 1.0) return values_.back();
  const Place place = placeOf(tau);
  return pieceAt(values_, slopes_, place.interval).at(place.u);
}

double SpeedCurve::derivative(double tau) const {
  const Place place = placeOf(std::clamp(tau, 0.0, 1.0));
  return pieceAt(values_, slopes_, place.interval).slope(place.u) * kIntervals;
}

double SpeedCurve::integral(double tau) const {
  if (!(tau > 0.0)) return 0.0;
  if (tau >= 1.0) return sums_.back();
  const Place place = placeOf(tau);
  return sums_[place.interval] +
         pieceAt(values_, slopes_, place.interval).integral(place.u) / kIntervals;
}

double SpeedCurve::progress(double tau) const {
  if (!(tau > 0.0)) return 0.0;
  if (tau >= 1.0) return 1.0;
  return std::min(integral(tau) / sums_.back(), 1.0);
}

}  // namespace vides
