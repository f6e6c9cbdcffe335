// SPDX-License-Identifier: MIT
// The map of what is crowded: cubic B-splines laid out and read again.
#include "scene/crowding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

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

// Weights of four cells in a row for a place `t` of the way, 0 to 1, from the second to the third.
void weights(double t, float (&w)[4]) {
  const double u = 1.0 - t;
  w[0] = static_cast<float>(u * u * u / 6.0);
  w[1] = static_cast<float>((4.0 + t * t * (3.0 * t - 6.0)) / 6.0);
  w[3] = static_cast<float>(t * t * t / 6.0);
  w[2] = 1.0f - w[0] - w[1] - w[3];
}

}  // namespace

void Crowding::begin(const PixelRectangle& area, double cell) {
  area_ = area;
  perCell_ = 1.0 / cell;
  // Two cells more on each side: a sign outside may reach into the area.
  columns_ = static_cast<std::size_t>(area.width * perCell_) + 5;
  rows_ = static_cast<std::size_t>(area.height * perCell_) + 5;
  cells_.assign(columns_ * rows_, 0.0f);
}

bool Crowding::spread(const Vec2& pixel, Spread& result) const {
  const double x = (pixel.x - area_.x) * perCell_ + 2.0, y = (pixel.y - area_.y) * perCell_ + 2.0;
  if (!(x >= 1.0 && y >= 1.0 && x < static_cast<double>(columns_ - 2) &&
        y < static_cast<double>(rows_ - 2))) {
    return false;
  }
  const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
  result.first = (row - 1) * columns_ + column - 1;
  weights(x - static_cast<double>(column), result.x);
  weights(y - static_cast<double>(row), result.y);
  return true;
}

void Crowding::add(const Vec2& pixel) {
  Spread s;
  if (!spread(pixel, s)) return;
  for (std::size_t j = 0; j < 4; ++j) {
    float* cells = cells_.data() + s.first + j * columns_;
    for (std::size_t i = 0; i < 4; ++i) cells[i] += s.y[j] * s.x[i];
  }
}

double Crowding::around(const Vec2& pixel) const {
  Spread s;
  if (!spread(pixel, s)) return 0.0;
  float sum = 0.0f, own = 0.0f;
  for (std::size_t j = 0; j < 4; ++j) {
    const float* cells = cells_.data() + s.first + j * columns_;
    for (std::size_t i = 0; i < 4; ++i) {
      const float weight = s.y[j] * s.x[i];
      sum += weight * cells[i];
      own += weight * weight;
    }
  }
  return std::max(0.0, static_cast<double>(sum - own));
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
