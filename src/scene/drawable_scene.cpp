// SPDX-License-Identifier: MIT
// Divides scenes into tiles of several degrees of detail.
#include "scene/drawable_scene.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <random>
#include <span>

namespace vides {
namespace {

// OpenGL 3.3 promises buffer textures of 65,536 texels; an edge takes two.
constexpr std::size_t kMostInTile = 8192;
// A coarser detail has to be so much smaller to be worth keeping.
constexpr double kWorthKeeping = 0.7;
// Tiles that are divided for the sake of precision, at most.
constexpr int kMostDivided = 64;
// Positions that differ have to differ in more than the last bits of a tile's coordinates.
constexpr unsigned kSpareBits = 4;

class Maker {
 public:
  Maker(const SceneGeometry& scene, const CellTree& cells, const Vec3& middle,
        const KeepGoing& keepGoing)
      : positions_(scene.positions), cells_(cells), middle_(middle), keepGoing_(keepGoing) {}

  // An element has kCorners positions. `from` to `to`: the share that is told. False where it was
  // stopped.
  template <std::size_t kCorners>
  bool divide(Primitive primitive, std::vector<std::array<std::uint32_t, kCorners>> elements,
              double from, double to, DrawableScene::Tiles& tiles) {
    const std::size_t all = elements.size();
    const bool large = all > kAlwaysWhole;
    int divided = 0;
    std::vector<std::span<std::array<std::uint32_t, kCorners>>> waiting;
    if (all > 0) waiting.emplace_back(elements);
    std::size_t done = 0;
    while (!waiting.empty()) {
      const auto part = waiting.back();
      waiting.pop_back();
      std::size_t first = 0;
      DrawableScene::Tile tile;
      if (part.size() > kMostInTile) {
        first = halve<kCorners>(part);
      } else {
        place<kCorners>(part, tile);
        if (divided < kMostDivided && isCrowded<kCorners>(part, tile.place)) {
          first = cutAtGap<kCorners>(part);
          divided += first > 0 ? 1 : 0;
        }
      }
      if (first > 0) {
        waiting.push_back(part.subspan(first));
        waiting.push_back(part.first(first));
      } else {
        addDetails<kCorners>(primitive, part, large, tile);
        tiles.push_back(std::move(tile));
        done += part.size();
      }
      const double share = static_cast<double>(done) / static_cast<double>(all);
      if (keepGoing_ && !keepGoing_(from + (to - from) * share)) return false;
    }
    return true;
  }

 private:
  // Half of it: also where the whole would be beyond a double.
  template <std::size_t kCorners>
  Vec3 middle(const std::array<std::uint32_t, kCorners>& element) const {
    Vec3 sum(0.0);
    for (const std::uint32_t corner : element) sum += 0.5 / kCorners * positions_[corner];
    return sum;
  }

  // The axis along which the middles lie farthest apart.
  template <std::size_t kCorners>
  int longestAxis(std::span<const std::array<std::uint32_t, kCorners>> part) const {
    Vec3 low = middle(part.front()), high = low;
    for (const auto& element : part) {
      low = glm::min(low, middle(element));
      high = glm::max(high, middle(element));
    }
    const Vec3 size = high - low;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  // Across the longest axis; returns how many are in the first half.
  template <std::size_t kCorners>
  std::size_t halve(std::span<std::array<std::uint32_t, kCorners>> part) const {
    const int axis = longestAxis<kCorners>(part);
    const std::size_t half = part.size() / 2;
    std::ranges::nth_element(part, part.begin() + static_cast<std::ptrdiff_t>(half), {},
                             [&](const auto& element) { return middle(element)[axis]; });
    return half;
  }

  // Where the middles along the longest axis lie farthest from each other; 0 where they are all at
  // the same place.
  template <std::size_t kCorners>
  std::size_t cutAtGap(std::span<std::array<std::uint32_t, kCorners>> part) const {
    const int axis = longestAxis<kCorners>(part);
    const auto along = [&](const auto& element) { return middle(element)[axis]; };
    std::ranges::sort(part, {}, along);
    std::size_t first = 0;
    double widest = 0.0;
    for (std::size_t i = 1; i < part.size(); ++i) {
      const double gap = along(part[i]) - along(part[i - 1]);
      if (gap > widest) {
        widest = gap;
        first = i;
      }
    }
    return first;
  }

  // The origin is the corner nearest to the scene's middle: coordinates are the more exact the
  // nearer they are to it, and what reaches out far begins there.
  template <std::size_t kCorners>
  void place(std::span<const std::array<std::uint32_t, kCorners>> part,
             DrawableScene::Tile& tile) const {
    tile.low = tile.high = tile.place.origin = positions_[part.front()[0]];
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& element : part) {
      for (const std::uint32_t corner : element) {
        const Vec3& p = positions_[corner];
        tile.low = glm::min(tile.low, p);
        tile.high = glm::max(tile.high, p);
        const Vec3 away = glm::abs(0.5 * p - 0.5 * middle_);
        const double distance = std::max({away.x, away.y, away.z});
        if (distance < nearest) {
          nearest = distance;
          tile.place.origin = p;
        }
      }
    }
    const Vec3 half = 0.5 * tile.high - 0.5 * tile.low;
    const double size = std::max({half.x, half.y, half.z});
    tile.place.unit = size > 0.0 ? size : 1.0;
  }

  static GeometryPoint pointAt(const Vec3& p, const Placement& place) {
    const Vec3 at = (0.5 * p - 0.5 * place.origin) / (0.5 * place.unit);
    return {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z), 0.0f};
  }

  // Whether positions that differ nearly fall together in the tile's coordinates.
  template <std::size_t kCorners>
  bool isCrowded(std::span<const std::array<std::uint32_t, kCorners>> part,
                 const Placement& place) const {
    struct Entry {
      std::array<std::uint32_t, 3> bits{};
      std::uint32_t position = 0;
      bool taken = false;
    };
    const std::size_t size = std::bit_ceil(2 * kCorners * part.size() + 1);
    std::vector<Entry> entries(size);
    for (const auto& element : part) {
      for (const std::uint32_t corner : element) {
        const GeometryPoint p = pointAt(positions_[corner], place);
        Entry entry{{bits(p.x), bits(p.y), bits(p.z)}, corner, true};
        std::uint64_t hash = entry.bits[0];
        hash = hash * 0x9e3779b97f4a7c15u + entry.bits[1];
        hash = hash * 0x9e3779b97f4a7c15u + entry.bits[2];
        std::size_t at = (hash * 0x9e3779b97f4a7c15u >> 20) & (size - 1);
        for (; entries[at].taken; at = (at + 1) & (size - 1)) {
          if (entries[at].bits != entry.bits) continue;
          if (positions_[entries[at].position] != positions_[corner]) return true;
          break;
        }
        entries[at] = entry;
      }
    }
    return false;
  }

  static std::uint32_t bits(float coordinate) {
    return std::bit_cast<std::uint32_t>(coordinate + 0.0f) >> kSpareBits;
  }

  template <std::size_t kCorners>
  DrawableScene::Detail detail(Primitive primitive, int level,
                               std::span<const std::array<std::uint32_t, kCorners>> elements,
                               const Placement& place, bool large) const {
    const std::vector<Vec3>& points =
        level < 0 ? positions_ : cells_.levels()[static_cast<std::size_t>(level)].means;
    auto geometry = std::make_shared<Geometry>(Geometry{primitive, {}});
    geometry->points.reserve(kCorners * elements.size());
    DrawableScene::Detail result;
    result.level = level;
    if (large) result.corners.reserve(kCorners * elements.size());
    for (const auto& element : elements) {
      for (const std::uint32_t corner : element) {
        geometry->points.push_back(pointAt(points[corner], place));
        if (large) result.corners.push_back(corner);
      }
    }
    result.geometry = std::move(geometry);
    return result;
  }

  template <std::size_t kCorners>
  void addDetails(Primitive primitive, std::span<std::array<std::uint32_t, kCorners>> elements,
                  bool large, DrawableScene::Tile& tile) const {
    using Elements = std::vector<std::array<std::uint32_t, kCorners>>;
    // The first of them stand for all where even the coarsest is too much.
    if (large) std::ranges::shuffle(elements, std::minstd_rand(1));
    tile.details.push_back(detail<kCorners>(primitive, -1, elements, tile.place, large));
    if (!large) return;
    Elements joined(elements.begin(), elements.end());
    for (std::size_t level = 0; level < cells_.levels().size(); ++level) {
      join<kCorners>(level == 0 ? cells_.cells() : cells_.levels()[level - 1].parent, joined);
      // However small it is seen, something of it stays.
      if (joined.empty()) break;
      const auto before = static_cast<double>(tile.details.back().geometry->elements());
      if (static_cast<double>(joined.size()) > kWorthKeeping * before) continue;
      Elements mixed = joined;
      std::ranges::shuffle(mixed, std::minstd_rand(1));
      tile.details.push_back(
          detail<kCorners>(primitive, static_cast<int>(level), mixed, tile.place, large));
    }
  }

  // Each element once, with the cells of its corners; none that shrinks into one.
  template <std::size_t kCorners>
  static void join(const std::vector<std::uint32_t>& cellOf,
                   std::vector<std::array<std::uint32_t, kCorners>>& elements) {
    for (auto& element : elements) {
      for (std::uint32_t& corner : element) corner = cellOf[corner];
      std::ranges::sort(element);
    }
    if (kCorners > 1) {
      std::erase_if(elements, [](const auto& e) { return e.front() == e.back(); });
    }
    std::ranges::sort(elements);
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  }

  const std::vector<Vec3>& positions_;
  const CellTree& cells_;
  Vec3 middle_;
  const KeepGoing& keepGoing_;
};

// The share of the cells in making a large scene.
constexpr double kCellsShare = 0.4;

}  // namespace

std::shared_ptr<const DrawableScene> DrawableScene::make(const SceneGeometry& scene,
                                                         const KeepGoing& keepGoing) {
  auto result = std::make_shared<DrawableScene>();
  result->report_ = scene.report;
  const auto bounds = boundsOf(scene.positions);
  if (!bounds) return result;
  result->box_ = *bounds;

  const std::size_t most = std::max({scene.edges.size(), scene.positions.size()});
  if (most > kAlwaysWhole) {
    bool stopped = false;
    result->cells_ = CellTree(scene.positions, [&](double share) {
      stopped = keepGoing && !keepGoing(kCellsShare * share);
      return !stopped;
    });
    if (stopped) return nullptr;
  }
  Maker maker(scene, result->cells_, bodyOf(scene.positions).center(), keepGoing);
  const auto single = [](std::size_t count, auto index) {
    std::vector<std::array<std::uint32_t, 1>> elements(count);
    for (std::size_t i = 0; i < count; ++i) elements[i] = {static_cast<std::uint32_t>(index(i))};
    return elements;
  };
  if (!maker.divide<2>(Primitive::kSegments, scene.edges, kCellsShare, 0.9, result->edges_) ||
      !maker.divide<1>(Primitive::kMarkers,
                       single(scene.positions.size(), [](std::size_t i) { return i; }), 0.9, 1.0,
                       result->positions_) ||
      !maker.divide<1>(Primitive::kMarkers,
                       single(scene.points.size(), [&](std::size_t i) { return scene.points[i]; }),
                       1.0, 1.0, result->points_)) {
    return nullptr;
  }
  return result;
}

}  // namespace vides
