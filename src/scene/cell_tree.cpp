// SPDX-License-Identifier: MIT
// Sorts positions along a curve that runs through the cells of all grids, one cell after the other.
#include "scene/cell_tree.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace vides {
namespace {

// The coarsest grid has so many cells along the body's longest side; each finer one has half the
// width.
constexpr double kCoarsest = 16.0;
constexpr unsigned kHalvings = 24;
// A grid has to have so many fewer cells than what it joins.
constexpr double kWorthKeeping = 0.7;
// Cells that can be told apart, beside the body as well.
constexpr double kMostCells = 4611686018427387904.0;  // 2^62

using Place = std::array<std::uint64_t, 3>;

// In which bit two places differ first; -1 where they don't.
int firstDifference(const Place& a, const Place& b) {
  const std::uint64_t differs = (a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2]);
  return static_cast<int>(std::bit_width(differs)) - 1;
}

bool isHigherBit(std::uint64_t a, std::uint64_t b) { return a < b && a < (a ^ b); }

// Of the bits of x, y and z, the highest that differs decides.
bool isBefore(const Place& a, const Place& b) {
  std::size_t axis = 0;
  std::uint64_t highest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t differs = a[i] ^ b[i];
    if (isHigherBit(highest, differs)) {
      highest = differs;
      axis = i;
    }
  }
  return a[axis] < b[axis];
}

double longestSide(const Body& body) {
  const Vec3 half = 0.5 * body.high - 0.5 * body.low;
  return std::max({half.x, half.y, half.z});  // halved: not beyond a double
}

}  // namespace

Body bodyOf(const std::vector<Vec3>& positions) {
  constexpr std::size_t kMost = 4096;
  constexpr double kLeftOut = 0.02;  // at either end
  Body body;
  const std::size_t step = 1 + positions.size() / kMost;
  std::vector<double> values;
  for (int axis = 0; axis < 3; ++axis) {
    values.clear();
    for (std::size_t i = 0; i < positions.size(); i += step) values.push_back(positions[i][axis]);
    if (values.empty()) continue;
    std::ranges::sort(values);
    const auto left = static_cast<std::size_t>(kLeftOut * static_cast<double>(values.size()));
    body.low[axis] = values[left];
    body.high[axis] = values[values.size() - 1 - left];
  }
  return body;
}

CellTree::CellTree(const std::vector<Vec3>& positions, const std::function<bool(double)>& tell) {
  const auto stopped = [&](double share) { return tell && !tell(share); };
  if (positions.empty()) return;
  const Body body = bodyOf(positions);
  const double side = longestSide(body);
  const double finest = std::ldexp((side > 0.0 ? side : 1.0) / kCoarsest, -int{kHalvings});  // half
  std::vector<Place> places(positions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = (0.5 * positions[i][axis] - 0.5 * body.low[axis]) / finest;
      const double at = std::clamp(std::floor(cells), -kMostCells, kMostCells) + kMostCells;
      places[i][static_cast<std::size_t>(axis)] = static_cast<std::uint64_t>(at);
    }
  }
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return isBefore(places[a], places[b]); });
  if (stopped(0.6)) return;

  // How many cells each grid has: the next position in the order begins a new one in all grids that
  // are fine enough.
  std::vector<std::int8_t> begins(order.size(), 63);
  std::array<std::size_t, 64> count{};
  for (std::size_t i = 1; i < order.size(); ++i) {
    const int first = firstDifference(places[order[i - 1]], places[order[i]]);
    begins[i] = static_cast<std::int8_t>(first);
    if (first >= 0) ++count[static_cast<std::size_t>(first)];
  }
  std::size_t cells = 1;
  for (std::size_t shift = 64; shift-- > 0;) count[shift] = cells += count[shift];

  std::size_t before = order.size();
  std::vector<std::uint32_t> last;  // the cell of each place in the order, in the grid before
  for (unsigned shift = 0; shift <= kHalvings; ++shift) {
    if (static_cast<double>(count[shift]) > kWorthKeeping * static_cast<double>(before)) continue;
    before = count[shift];
    Level level;
    level.cell = 2.0 * std::ldexp(finest, static_cast<int>(shift));
    level.means.reserve(before);
    std::vector<std::uint32_t> now(order.size());
    for (std::size_t first = 0; first < order.size();) {
      std::size_t end = first;
      Vec3 mean = positions[order[first]];
      do {
        now[end] = static_cast<std::uint32_t>(level.means.size());
        mean += (positions[order[end]] - mean) / static_cast<double>(end - first + 1);
        ++end;
      } while (end < order.size() && begins[end] < static_cast<int>(shift));
      level.means.push_back(mean);
      first = end;
    }
    if (levels_.empty()) {
      cells_.resize(order.size());
      for (std::size_t i = 0; i < order.size(); ++i) cells_[order[i]] = now[i];
    } else {
      levels_.back().parent.resize(levels_.back().means.size());
      for (std::size_t i = 0; i < order.size(); ++i) levels_.back().parent[last[i]] = now[i];
    }
    levels_.push_back(std::move(level));
    last = std::move(now);
    if (stopped(0.6 + 0.4 * shift / kHalvings)) return;
  }
}

}  // namespace vides
