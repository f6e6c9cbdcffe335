// SPDX-License-Identifier: MIT
// The map of what is crowded: cubic B-splines laid out and read again.
#include "scene/crowding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "math/whole.hpp"

namespace vides {
namespace {

// Up to here everything is drawn whole: a row 1.7 radii of a cross apart.
constexpr double kRoomy = 0.5;
constexpr double kAlone = 0.23;  // what a sign adds at its own place, about
// Beyond this half of the signs are left out, beyond the double three quarters, …
constexpr double kFull = 1.85;
// They have gone completely where it is so much fuller still.
constexpr double kGone = 1.35;
constexpr double kLeastShare = 0.3;
constexpr std::int64_t kMostCells = 1 << 14;  // in a row

// Weights are whole multiples of a power of two, so that sums of their products are exact: what
// was added can be taken away again.
constexpr double kWeightSteps = 8192.0;

// Weights of four cells in a row for a place `t` of the way, 0 to 1, from the second to the third.
void weights(double t, double (&w)[4]) {
  const auto rounded = [](double v) { return std::nearbyint(v * kWeightSteps) / kWeightSteps; };
  const double u = 1.0 - t;
  w[0] = rounded(u * u * u / 6.0);
  w[1] = rounded((4.0 + t * t * (3.0 * t - 6.0)) / 6.0);
  w[3] = rounded(t * t * t / 6.0);
  w[2] = 1.0 - w[0] - w[1] - w[3];
}

}  // namespace

void Crowding::begin(const PixelRectangle& area, double cell) {
  area_ = area;
  perCell_ = 1.0 / cell;
  // Two cells more on each side: a sign outside may reach into the area.
  columns_ = static_cast<std::size_t>(wholeWithin(area.width * perCell_, 0, kMostCells)) + 5;
  rows_ = static_cast<std::size_t>(wholeWithin(area.height * perCell_, 0, kMostCells)) + 5;
  cells_.assign(columns_ * rows_, 0.0);
  changed_.assign(columns_ * rows_, 0);
  allChanged_ = true;
  anyChanged_ = false;
}

Vec2 Crowding::inCells(const Vec2& pixel) const {
  return {(pixel.x - area_.x) * perCell_ + 2.0, (pixel.y - area_.y) * perCell_ + 2.0};
}

bool Crowding::spread(const Vec2& pixel, Spread& result) const {
  const Vec2 at = inCells(pixel);
  const double x = at.x, y = at.y;
  if (!(x >= 1.0 && y >= 1.0 && x < static_cast<double>(columns_ - 2) &&
        y < static_cast<double>(rows_ - 2))) {
    return false;
  }
  const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
  result.column = column - 1;
  result.row = row - 1;
  weights(x - static_cast<double>(column), result.x);
  weights(y - static_cast<double>(row), result.y);
  return true;
}

void Crowding::change(const Vec2& pixel, double sign) {
  Spread s;
  if (!spread(pixel, s)) return;
  for (std::size_t j = 0; j < 4; ++j) {
    double* cells = cells_.data() + (s.row + j) * columns_ + s.column;
    for (std::size_t i = 0; i < 4; ++i) cells[i] += sign * s.y[j] * s.x[i];
  }
  if (!allChanged_) mark(s.column, s.row);
}

// Four cells changed from this one on; a sign reads those from one before to two after its own.
void Crowding::mark(std::size_t column, std::size_t row) {
  anyChanged_ = true;
  const std::size_t left = std::max<std::size_t>(column, 2) - 2, right = column + 5;
  const std::size_t top = std::max<std::size_t>(row, 2) - 2, bottom = row + 5;
  for (std::size_t y = top; y < std::min(bottom, rows_); ++y) {
    char* const cells = changed_.data() + y * columns_;
    std::fill(cells + left, cells + std::min(right, columns_), '\1');
  }
}

bool Crowding::changed(const Vec2& pixel) const {
  if (allChanged_) return true;
  if (!anyChanged_) return false;
  const Vec2 at = inCells(pixel);
  const double x = at.x, y = at.y;
  if (!(x >= 0.0 && y >= 0.0 && x < static_cast<double>(columns_) &&
        y < static_cast<double>(rows_))) {
    return false;
  }
  return changed_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)] != 0;
}

void Crowding::settle() {
  if (anyChanged_) std::ranges::fill(changed_, '\0');
  allChanged_ = anyChanged_ = false;
}

double Crowding::around(const Vec2& pixel) const {
  Spread s;
  if (!spread(pixel, s)) return 0.0;
  double sum = 0.0, own = 0.0;
  for (std::size_t j = 0; j < 4; ++j) {
    const double* cells = cells_.data() + (s.row + j) * columns_ + s.column;
    for (std::size_t i = 0; i < 4; ++i) {
      const double weight = s.y[j] * s.x[i];
      sum += weight * cells[i];
      own += weight * weight;
    }
  }
  return std::max(0.0, sum - own);
}

double crossShare(double crowding, std::size_t number) {
  if (crowding <= kRoomy) return 1.0;
  const double room = (kRoomy + kAlone) / (std::min(crowding, kFull) + kAlone);
  const double share = std::max(kLeastShare, room * room);
  if (crowding <= kFull || number == 0) return share;
  // How full it would be if only those were left that go together with this one.
  const int level = std::countr_zero(number);
  const double left = crowding / std::ldexp(kFull, level);
  if (left <= 1.0) return share;
  return share * std::clamp((kGone - left) / (kGone - 1.0), 0.0, 1.0);
}

}  // namespace vides
