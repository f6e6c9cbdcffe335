// SPDX-License-Identifier: MIT
// Tries the places around an anchor and takes the one that covers least.
#include "scene/label_placer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/whole.hpp"

namespace vides {
namespace {

// More than this and a label that is not needed is left out: it would cover a mark or a label.
constexpr int kTooBad = 36;
constexpr int kOutside = 1000;
constexpr int kMostCells = 1 << 20;

}  // namespace

LabelPlacer::LabelPlacer(const PixelRectangle& area, double cell) : area_(area), cell_(cell) {
  while (area.width / cell_ * (area.height / cell_) > kMostCells) cell_ *= 2.0;
  columns_ = static_cast<int>(wholeWithin(std::ceil(area.width / cell_), 0, kMostCells));
  rows_ = static_cast<int>(wholeWithin(std::ceil(area.height / cell_), 0, kMostCells));
  covered_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
}

// Without std::floor: this is asked some thousand times for each display frame.
int LabelPlacer::cellOf(double value, double origin, int count) const {
  const double share = (value - origin) / cell_;
  if (!(share >= 0.0)) return -1;
  return share >= count ? count : static_cast<int>(share);
}

LabelPlacer::Cells LabelPlacer::cellsOf(const Vec2& low, const Vec2& high) const {
  return {cellOf(low.x, area_.x, columns_), cellOf(low.y, area_.y, rows_),
          cellOf(high.x, area_.x, columns_), cellOf(high.y, area_.y, rows_)};
}

void LabelPlacer::blockBox(const Vec2& low, const Vec2& high, std::uint8_t weight) {
  const Cells c = cellsOf(low, high);
  for (int y = std::max(c.top, 0); y <= std::min(c.bottom, rows_ - 1); ++y) {
    for (int x = std::max(c.left, 0); x <= std::min(c.right, columns_ - 1); ++x) {
      auto& covered = covered_[static_cast<std::size_t>(y * columns_ + x)];
      covered = std::max(covered, weight);
    }
  }
}

void LabelPlacer::blockLine(const Vec2& from, const Vec2& to, std::uint8_t weight) {
  // Only what lies in the area: a line may reach very far.
  double begin = 0.0, end = 1.0;
  const Vec2 way = to - from;
  const Vec2 low{area_.x, area_.y}, high{area_.x + area_.width, area_.y + area_.height};
  for (int i = 0; i < 2; ++i) {
    if (way[i] == 0.0) {
      if (from[i] < low[i] || from[i] > high[i]) return;
      continue;
    }
    const double a = (low[i] - from[i]) / way[i], b = (high[i] - from[i]) / way[i];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  if (!(begin <= end)) return;
  const double length = glm::length(way) * (end - begin) / cell_;
  const auto steps = static_cast<int>(1 + wholeWithin(length, 0, columns_ + rows_));
  for (int i = 0; i <= steps; ++i) {
    const Vec2 p = from + (begin + (end - begin) * i / steps) * way;
    const int x = cellOf(p.x, area_.x, columns_), y = cellOf(p.y, area_.y, rows_);
    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) continue;
    auto& covered = covered_[static_cast<std::size_t>(y * columns_ + x)];
    covered = std::max(covered, weight);
  }
}

int LabelPlacer::cost(const Vec2& low, const Vec2& high) const {
  // A place that is no number is nowhere, too.
  const bool inside = low.x >= area_.x && low.y >= area_.y && high.x <= area_.x + area_.width &&
                      high.y <= area_.y + area_.height;
  if (!inside) return kOutside;
  const Cells c = cellsOf(low, high);
  int sum = 0;
  for (int y = c.top; y <= std::min(c.bottom, rows_ - 1); ++y) {
    for (int x = c.left; x <= std::min(c.right, columns_ - 1); ++x) {
      sum += covered_[static_cast<std::size_t>(y * columns_ + x)];
    }
  }
  return sum;
}

std::optional<LabelPlacer::Place> LabelPlacer::place(const Vec2& anchor, double gap,
                                                     const Vec2& size, bool needed) {
  // The direction from the anchor to the box, the best first: right above, right below, …
  static constexpr std::array<std::array<double, 2>, 8> kWays{
      {{1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {1, 0}, {0, -1}, {0, 1}, {-1, 0}}};
  int least = std::numeric_limits<int>::max();
  Place best;
  for (int ring = 0; ring < (needed ? 3 : 2) && least > 4; ++ring) {
    for (std::size_t i = 0; i < kWays.size(); ++i) {
      const Vec2 way{kWays[i][0], kWays[i][1]};
      const bool diagonal = way.x != 0.0 && way.y != 0.0;
      const double away = (diagonal ? 0.68 : 1.0) * gap * (1.0 + 0.75 * ring);
      const Vec2 middle = anchor + way * away + way * 0.5 * size;
      const Vec2 low = middle - 0.5 * size;
      const int under = cost(low, low + size);
      const int here = under + static_cast<int>(i) / 2 + 4 * ring;
      if (here < least) least = here, best = {low, ring > 0, under > 0};
      if (least <= static_cast<int>(i) / 2) break;
    }
  }
  if (least > kTooBad && !needed) return std::nullopt;
  if (least >= kOutside) return std::nullopt;
  blockBox(best.corner, best.corner + size, kBlockedByLabel);
  return best;
}

}  // namespace vides
