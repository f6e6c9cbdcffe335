// SPDX-License-Identifier: MIT
// Divides scenes into tiles of several degrees of detail, and chooses among them.
#include "scene/drawable_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <random>
#include <span>

#include "math/whole.hpp"
#include "scene/curve_flattener.hpp"

namespace vides {
namespace {

// OpenGL 3.3 promises buffer textures of 65,536 texels; an edge takes two.
constexpr std::size_t kMostInTile = 8192;
// Cells along the longest side of a large scene's grids.
constexpr std::array<std::uint32_t, 7> kGrids{1024, 512, 256, 128, 64, 32, 16};
// As many are whole even in the smallest picture.
constexpr std::size_t kAlwaysWhole = kMostSceneElements / 8;
// A coarser detail has to be so much smaller to be worth keeping.
constexpr double kWorthKeeping = 0.7;
// Pixels that a cell may cover: the first that leaves few enough elements is taken.
constexpr double kFinest = 0.5, kCoarsest = 64.0, kStep = 1.25;

using Point = glm::vec3;

// The positions joined cell by cell.
struct Grid {
  double cell = 0.0;
  std::vector<std::uint32_t> of;  // the cell of each position
  std::vector<Point> means;
};

class Maker {
 public:
  Maker(const SceneGeometry& scene, const Placement& place, const KeepGoing& keepGoing)
      : keepGoing_(keepGoing), points_(scene.positions.size()) {
    std::ranges::transform(scene.positions, points_.begin(),
                           [&](const Vec3& p) { return Point((p - place.origin) / place.unit); });
  }

  // False where it was stopped.
  bool tell(double share) { return !keepGoing_ || keepGoing_(share); }

  bool makeGrids() {
    std::vector<std::uint64_t> keys(points_.size());
    std::vector<std::uint32_t> order(points_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
    for (const std::uint32_t cells : kGrids) {
      for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = cellAt(points_[i], cells);
      // Cells within one cell of the finer grid stand side by side already.
      std::ranges::sort(order, {}, [&](std::uint32_t i) { return keys[i]; });
      Grid grid{2.0 / cells, std::vector<std::uint32_t>(points_.size()), {}};
      for (std::size_t first = 0; first < order.size();) {
        const std::uint64_t key = keys[order[first]];
        Vec3 sum(0.0);
        std::size_t last = first;
        for (; last < order.size() && keys[order[last]] == key; ++last) {
          grid.of[order[last]] = static_cast<std::uint32_t>(grid.means.size());
          sum += Vec3(points_[order[last]]);
        }
        grid.means.push_back(Point(sum / static_cast<double>(last - first)));
        first = last;
      }
      grids_.push_back(std::move(grid));
      if (!tell(0.4 * static_cast<double>(grids_.size()) / kGrids.size())) return false;
    }
    return true;
  }

  // An element has kCorners positions. `from` to `to`: the share that is told.
  template <std::size_t kCorners>
  bool divide(Primitive primitive, std::vector<std::array<std::uint32_t, kCorners>> elements,
              double from, double to, DrawableScene::Tiles& tiles) {
    const std::size_t all = elements.size();
    const bool large = all > kAlwaysWhole;
    if (large && grids_.empty() && !makeGrids()) return false;
    std::vector<std::span<std::array<std::uint32_t, kCorners>>> waiting;
    if (all > 0) waiting.emplace_back(elements);
    std::size_t done = 0;
    while (!waiting.empty()) {
      const auto part = waiting.back();
      waiting.pop_back();
      if (part.size() > kMostInTile) {
        const std::size_t half = part.size() / 2;
        halve<kCorners>(part, half);
        waiting.push_back(part.subspan(half));
        waiting.push_back(part.first(half));
      } else {
        tiles.push_back(tile<kCorners>(primitive, part, large));
        done += part.size();
      }
      const double share = static_cast<double>(done) / static_cast<double>(all);
      if (!tell(from + (to - from) * share)) return false;
    }
    return true;
  }

 private:
  static std::uint64_t cellAt(const Point& p, std::uint32_t cells) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const float at = std::floor(0.5f * (p[axis] + 1.0f) * static_cast<float>(cells));
      const auto most = static_cast<float>(cells - 1);
      key = key << 20 | static_cast<std::uint64_t>(std::clamp(at, 0.0f, most));
    }
    return key;
  }

  template <std::size_t kCorners>
  Point middle(const std::array<std::uint32_t, kCorners>& element) const {
    Point sum(0.0f);
    for (const std::uint32_t corner : element) sum += points_[corner];
    return sum;
  }

  // Across the axis in which the middles lie farthest apart.
  template <std::size_t kCorners>
  void halve(std::span<std::array<std::uint32_t, kCorners>> part, std::size_t half) const {
    Point low = middle(part.front()), high = low;
    for (const auto& element : part) {
      low = glm::min(low, middle(element));
      high = glm::max(high, middle(element));
    }
    const Point size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::ranges::nth_element(part, part.begin() + static_cast<std::ptrdiff_t>(half), {},
                             [&](const auto& element) { return middle(element)[axis]; });
  }

  template <std::size_t kCorners>
  static SharedGeometry geometry(Primitive primitive, const std::vector<Point>& points,
                                 std::span<const std::array<std::uint32_t, kCorners>> elements) {
    auto result = std::make_shared<Geometry>(Geometry{primitive, {}});
    result->points.reserve(kCorners * elements.size());
    for (const auto& element : elements) {
      for (const std::uint32_t corner : element) {
        const Point& p = points[corner];
        result->points.push_back({p.x, p.y, p.z, 0.0f});
      }
    }
    return result;
  }

  template <std::size_t kCorners>
  DrawableScene::Tile tile(Primitive primitive,
                           std::span<const std::array<std::uint32_t, kCorners>> elements,
                           bool large) const {
    DrawableScene::Tile tile;
    Point low = points_[elements.front()[0]], high = low;
    for (const auto& element : elements) {
      for (const std::uint32_t corner : element) {
        low = glm::min(low, points_[corner]);
        high = glm::max(high, points_[corner]);
      }
    }
    tile.low = low;
    tile.high = high;
    tile.details.push_back({0.0, geometry<kCorners>(primitive, points_, elements)});
    if (!large) return tile;
    std::vector<std::array<std::uint32_t, kCorners>> joined;
    for (const Grid& grid : grids_) {
      joined.clear();
      for (const auto& element : elements) {
        std::array<std::uint32_t, kCorners> cells;
        std::ranges::transform(element, cells.begin(), [&](std::uint32_t i) { return grid.of[i]; });
        std::ranges::sort(cells);
        if (kCorners == 1 || cells.front() != cells.back()) joined.push_back(cells);
      }
      std::ranges::sort(joined);
      joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
      const double before = static_cast<double>(tile.details.back().geometry->elements());
      // However small it is seen, something of it stays.
      if (joined.empty()) break;
      if (static_cast<double>(joined.size()) > kWorthKeeping * before) continue;
      // The first of them stand for all where even the coarsest is too much.
      std::ranges::shuffle(joined, std::minstd_rand(1));
      tile.details.push_back({grid.cell, geometry<kCorners>(primitive, grid.means, joined)});
    }
    return tile;
  }

  const KeepGoing& keepGoing_;
  std::vector<Point> points_;
  std::vector<Grid> grids_;
};

// Pixels that a unit covers about the middle of a box. Where the eye is close to it or in it, some
// of it is seen larger.
double pixelsPerUnit(const ViewProjection& view, const Vec3& low, const Vec3& high) {
  if (!view.perspective()) return view.pixelsPerUnit();
  const ViewMapping& mapping = view.mapping();
  const double eye = mapping.projectionReferencePoint.z;
  const double away = std::max({view.weight(0.5 * (low + high)), 0.25 * glm::distance(low, high),
                                eye - mapping.frontPlaneDistance});
  return view.pixelsPerUnit() * (eye - mapping.viewPlaneDistance) / away;
}

// A picture is whole with so many elements, else it has far fewer: what is joined is easy to read.
struct Limits {
  std::size_t whole, joined;
};
Limits limitsOf(const ViewProjection& view) {
  const double area = view.pixels().width * view.pixels().height;
  constexpr std::int64_t kAll = kAlwaysWhole, kMost = kMostSceneElements;
  return {static_cast<std::size_t>(wholeWithin(area / 3.0, kAll, kMost)),
          static_cast<std::size_t>(wholeWithin(area / 10.0, kAll / 4, kMost / 2))};
}

struct SeenTile {
  const DrawableScene::Tile* tile = nullptr;
  Placement place;
  double pixels = 0.0;  // that a unit of the tile's coordinates covers

  // The coarsest whose cells cover no more.
  const DrawableScene::Detail& detail(double mostPixels) const {
    const DrawableScene::Detail* best = &tile->details.front();
    for (const auto& detail : tile->details) {
      if (detail.cell * pixels <= mostPixels) best = &detail;
    }
    return *best;
  }
};

}  // namespace

std::shared_ptr<const DrawableScene> DrawableScene::make(const SceneGeometry& scene,
                                                         const KeepGoing& keepGoing) {
  auto result = std::make_shared<DrawableScene>();
  result->report_ = scene.report;
  const auto bounds = boundsOf(scene.positions);
  if (!bounds) return result;
  const BoundingBox& box = result->box_ = *bounds;
  // Halved first: also where the difference would be beyond a double.
  const Vec3 half = 0.5 * box.high - 0.5 * box.low;
  result->place_.origin = 0.5 * box.low + 0.5 * box.high;
  const double size = std::max({half.x, half.y, half.z});
  result->place_.unit = size > 0.0 ? size : 1.0;

  Maker maker(scene, result->place_, keepGoing);
  const auto single = [](std::size_t count, auto index) {
    std::vector<std::array<std::uint32_t, 1>> elements(count);
    for (std::size_t i = 0; i < count; ++i) elements[i] = {static_cast<std::uint32_t>(index(i))};
    return elements;
  };
  if (!maker.divide<2>(Primitive::kSegments, scene.edges, 0.4, 0.9, result->edges_) ||
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

std::vector<SeenDetail> seenDetails(const std::vector<PlacedTiles>& groups,
                                    const ViewProjection& view, double margin) {
  std::vector<SeenTile> seen;
  for (const PlacedTiles& group : groups) {
    for (const DrawableScene::Tile& tile : *group.tiles) {
      const Vec3 low = group.place.at(tile.low), high = group.place.at(tile.high);
      if (!mayBeSeen(view, low, high, margin)) continue;
      seen.push_back({&tile, group.place, group.place.unit * pixelsPerUnit(view, low, high)});
    }
  }
  double pixels = kFinest;
  const auto count = [&] {
    std::size_t sum = 0;
    for (const SeenTile& tile : seen) sum += tile.detail(pixels).geometry->elements();
    return sum;
  };
  std::size_t all = count();
  const Limits limits = limitsOf(view);
  const std::size_t most = all > limits.whole ? limits.joined : limits.whole;
  for (; all > most && pixels < kCoarsest; all = count()) pixels *= kStep;
  // Where joining doesn't help, as with long lines across each other: an even share of all.
  const double share = all > most ? static_cast<double>(most) / static_cast<double>(all) : 1.0;

  std::vector<SeenDetail> result;
  for (const SeenTile& tile : seen) {
    const SharedGeometry& geometry = tile.detail(pixels).geometry;
    const auto elements = static_cast<double>(geometry->elements());
    const auto taken = static_cast<std::size_t>(std::floor(share * elements));
    if (taken > 0) result.push_back({geometry, tile.place, taken});
  }
  return result;
}

}  // namespace vides
