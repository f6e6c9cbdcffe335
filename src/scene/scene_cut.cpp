// SPDX-License-Identifier: MIT
// Chooses cells and joins what leads to them.
#include "scene/scene_cut.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "math/whole.hpp"
#include "scene/curve_flattener.hpp"

namespace vides {
namespace {

// Pixels that a cell may cover: the first that leaves few enough elements is taken.
constexpr double kFinest = 0.5, kCoarsest = 64.0, kStep = 1.25;
// In perspective that is another number for each cell, up to so many times more or less: between
// near and far the grids change bit by bit instead of along a line.
constexpr double kSpread = 1.4;
constexpr int kWhole = DrawableScene::kWhole;

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

// How large things are seen.
class Magnification {
 public:
  explicit Magnification(const ViewProjection& view)
      : view_(&view), perUnit_(view.pixelsPerUnit()) {
    if (!view.perspective()) return;
    const ViewMapping& mapping = view.mapping();
    const double eye = mapping.projectionReferencePoint.z;
    perUnit_ *= eye - mapping.viewPlaneDistance;
    nearest_ = eye - mapping.frontPlaneDistance;
  }
  // Pixels that a unit covers at a place, or so far away from the eye's plane.
  double at(const Vec3& point) const { return atDistance(view_->weight(point)); }
  double atDistance(double away) const {
    return view_->perspective() ? perUnit_ / std::max(away, nearest_) : perUnit_;
  }

 private:
  const ViewProjection* view_;
  double perUnit_;
  double nearest_ = 0.0;
};

// From the coordinates of one placement into those of another.
Placement within(const Placement& outer, const Placement& inner) {
  return {outer.at(inner.origin), outer.unit * inner.unit, outer.turn * inner.turn};
}

// The least and the greatest distance of a box's corners from the eye's plane.
std::pair<double, double> distances(const ViewProjection& view, const Vec3& low, const Vec3& high) {
  double least = view.weight(low), greatest = least;
  for (int i = 1; i < 8; ++i) {
    const Vec3 corner((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                      (i & 4) != 0 ? high.z : low.z);
    const double away = view.weight(corner);
    least = std::min(least, away);
    greatest = std::max(greatest, away);
  }
  return {least, greatest};
}

}  // namespace

struct SceneCut::SeenTile {
  const DrawableScene::Tile* tile = nullptr;
  const PlacedTiles* group = nullptr;
  double nearest = 0.0, farthest = 0.0;  // distances of its box
  double pixels = 0.0;                   // that a scene unit covers about its middle
};

// What stands for a cell where `pixels` may be covered.
class SceneCut::Finder {
 public:
  Finder(const ViewProjection& view, double pixels)
      : size_(view), pixels_(pixels), spread_(view.perspective() ? kSpread : 1.0) {}

  void begin(const PlacedTiles& group, FoundCells& found, std::uint32_t call) {
    group_ = &group;
    levels_ = &group.scene->cells().levels();
    found_ = &found;
    call_ = call;
    found.resize(levels_->size());
    for (std::size_t i = 0; i < found.size(); ++i) found[i].resize((*levels_)[i].means.size());
  }

  // The coarsest level of which no cell of the tile is divided, and whether all cells of coarser
  // ones are.
  std::pair<int, bool> levelOf(const SeenTile& tile) const {
    bool even = true;
    const auto& levels = tile.group->scene->cells().levels();
    for (int level = static_cast<int>(levels.size()) - 1; level >= 0; --level) {
      const double cell = tile.group->place.unit * levels[static_cast<std::size_t>(level)].cell;
      // A cell's mean lies in the cell, but maybe beside the tile.
      const double beside = 1.8 * cell;
      if (cell * size_.atDistance(tile.nearest - beside) <= pixels_ / spread_) return {level, even};
      even = even && cell * size_.atDistance(tile.farthest + beside) > pixels_ * spread_;
    }
    return {kWhole, even};
  }

  // The cell itself or one that it lies in; level kWhole: not even the cell stands for itself.
  const Found& of(int level, std::uint32_t cell) {
    Found& found = (*found_)[static_cast<std::size_t>(level)][cell];
    if (found.call == call_) return found;
    const bool coarsest = level + 1 == static_cast<int>(levels_->size());
    const CellTree::Level& its = (*levels_)[static_cast<std::size_t>(level)];
    Found above{call_, 0, kWhole};
    if (!coarsest) above = of(level + 1, its.parent[cell]);
    if (above.level == kWhole && !isDivided(level, cell)) above = {call_, cell, level};
    return found = above;
  }

  double pixels() const { return pixels_; }
  const CellTree::Level& level(int index) const {
    return (*levels_)[static_cast<std::size_t>(index)];
  }
  const PlacedTiles& group() const { return *group_; }

 private:
  bool isDivided(int level, std::uint32_t cell) const {
    const CellTree::Level& its = (*levels_)[static_cast<std::size_t>(level)];
    const double covered =
        group_->place.unit * its.cell * size_.at(group_->place.at(its.means[cell]));
    return covered >
           pixels_ * (spread_ > 1.0 ? std::pow(spread_, 2.0 * chance(level, cell) - 1.0) : 1.0);
  }

  // 0 to 1, without a pattern.
  static double chance(int level, std::uint32_t cell) {
    std::uint64_t hash = (static_cast<std::uint64_t>(level + 1) << 32 | cell) * 0x9e3779b97f4a7c15u;
    hash = (hash ^ hash >> 29) * 0xbf58476d1ce4e5b9u;
    return static_cast<double>(hash >> 40) / static_cast<double>(1 << 24);
  }

  Magnification size_;
  double pixels_, spread_;
  const PlacedTiles* group_ = nullptr;
  const std::vector<CellTree::Level>* levels_ = nullptr;
  FoundCells* found_ = nullptr;
  std::uint32_t call_ = 0;
};

namespace {

// The coarsest detail that is no coarser than a level.
const DrawableScene::Detail& detailAt(const DrawableScene::Tile& tile, int level) {
  const DrawableScene::Detail* best = &tile.details.front();
  for (const auto& detail : tile.details) {
    if (detail.level <= level) best = &detail;
  }
  return *best;
}

// About how many elements a tile has where cells may cover so many pixels.
std::size_t aboutElements(const DrawableScene::Tile& tile, const CellTree& cells, double unitPixels,
                          double pixels) {
  const DrawableScene::Detail* best = &tile.details.front();
  for (const auto& detail : tile.details) {
    if (detail.level == kWhole) continue;
    const double cell = cells.levels()[static_cast<std::size_t>(detail.level)].cell;
    if (cell * unitPixels <= pixels) best = &detail;
  }
  return best->geometry->elements();
}

// Pairs of ends that have come already.
class Pairs {
 public:
  explicit Pairs(std::size_t most) : entries_(std::bit_ceil(2 * most + 1)) {}

  // False where it is there.
  bool add(std::uint64_t a, std::uint64_t b) {
    const std::size_t mask = entries_.size() - 1;
    std::size_t at = ((a * 0x9e3779b97f4a7c15u + b) * 0x9e3779b97f4a7c15u >> 20) & mask;
    for (; entries_[at] != std::pair<std::uint64_t, std::uint64_t>(); at = (at + 1) & mask) {
      if (entries_[at] == std::pair(a, b)) return false;
    }
    entries_[at] = {a, b};
    return true;
  }

 private:
  std::vector<std::pair<std::uint64_t, std::uint64_t>> entries_;  // of zeros: none
};

}  // namespace

// The elements of the nearest finer detail with the cells that stand for their ends, each once.
SharedGeometry SceneCut::joined(const SeenTile& seen, Finder& finder) {
  const auto [level, even] = finder.levelOf(seen);
  const DrawableScene::Tile& tile = *seen.tile;
  const DrawableScene::Detail& from = detailAt(tile, level);
  const std::size_t corners = from.geometry->primitive == Primitive::kSegments ? 2 : 1;
  auto result = std::make_shared<Geometry>(Geometry{from.geometry->primitive, {}});
  result->points.reserve(from.corners.size());
  Pairs known(from.corners.size() / corners);
  std::array<std::uint64_t, 2> ends{};
  std::array<GeometryPoint, 2> points{};
  for (std::size_t i = 0; i + corners <= from.corners.size(); i += corners) {
    for (std::size_t k = 0; k < corners; ++k) {
      const std::uint32_t corner = from.corners[i + k];
      const CellTree& cells = finder.group().scene->cells();
      const Found found = from.level == kWhole ? finder.of(0, cells.cells()[corner])
                                               : finder.of(from.level, corner);
      if (found.level == kWhole || (found.level == from.level && found.cell == corner)) {
        // Level 1 stands for positions, from 2 on for the cells of level 0 on.
        ends[k] = static_cast<std::uint64_t>(from.level + 2) << 32 | corner;
        points[k] = from.geometry->points[i + k];
      } else {
        ends[k] = static_cast<std::uint64_t>(found.level + 2) << 32 | found.cell;
        points[k] = geometryPoint(
            (finder.level(found.level).means[found.cell] - tile.place.origin) / tile.place.unit);
      }
    }
    if (corners == 2) {
      if (ends[0] == ends[1]) continue;
      if (!known.add(std::min(ends[0], ends[1]), std::max(ends[0], ends[1]))) continue;
    } else if (!known.add(ends[0], 0)) {
      continue;
    }
    result->points.insert(result->points.end(), points.begin(),
                          points.begin() + static_cast<std::ptrdiff_t>(corners));
  }
  // However small it is seen, something of it stays.
  return result->points.empty() ? tile.details.back().geometry : result;
}

const std::vector<SeenDetail>& SceneCut::see(std::vector<PlacedTiles> groups,
                                             const ViewProjection& view, double margin) {
  const bool same = groups == groups_ && view.matrix() == view_.matrix() &&
                    view.pixels() == view_.pixels() && margin == margin_ &&
                    view.perspective() == view_.perspective();
  if (same) return seen_;
  if (!(groups == groups_)) {
    found_.assign(groups.size(), {});
    even_.clear();
  }
  groups_ = std::move(groups);
  view_ = view;
  margin_ = margin;
  ++call_;

  const Magnification size(view);
  std::vector<SeenTile> tiles;
  for (const PlacedTiles& group : groups_) {
    for (const DrawableScene::Tile& tile : ((*group.scene).*group.tiles)()) {
      const Vec3 a = group.place.at(tile.low), b = group.place.at(tile.high);
      const Vec3 low = glm::min(a, b), high = glm::max(a, b);  // a turn may have changed them
      if (!mayBeSeen(view, low, high, margin)) continue;
      const auto [nearest, farthest] = distances(view, low, high);
      // Where the eye is close to it or in it, some of it is seen larger.
      const double away =
          std::max(view.weight(0.5 * (low + high)), 0.25 * glm::distance(low, high));
      tiles.push_back({&tile, &group, nearest, farthest, group.place.unit * size.atDistance(away)});
    }
  }
  double pixels = kFinest;
  const auto count = [&] {
    std::size_t sum = 0;
    for (const SeenTile& tile : tiles) {
      sum += aboutElements(*tile.tile, tile.group->scene->cells(), tile.pixels, pixels);
    }
    return sum;
  };
  std::size_t about = count();
  const Limits limits = limitsOf(view);
  std::size_t most = about > limits.whole ? limits.joined : limits.whole;
  for (; about > most && pixels < kCoarsest; about = count()) pixels *= kStep;

  seen_.clear();
  Finder finder(view, pixels);
  std::map<std::pair<const DrawableScene::Tile*, int>, SharedGeometry> even;
  std::size_t all = 0;
  for (const SeenTile& tile : tiles) {
    const auto [level, isEven] = finder.levelOf(tile);
    const DrawableScene::Detail& detail = detailAt(*tile.tile, level);
    SharedGeometry geometry = detail.geometry;
    if (!isEven || detail.level != level) {
      const auto key = std::pair(tile.tile, level);
      const auto known = isEven ? even_.find(key) : even_.end();
      if (known != even_.end()) {
        geometry = known->second;
      } else if (!detail.corners.empty()) {
        const auto group = static_cast<std::size_t>(tile.group - groups_.data());
        finder.begin(*tile.group, found_[group], call_);
        geometry = joined(tile, finder);
      }
      if (isEven) even[key] = geometry;
    }
    all += geometry->elements();
    seen_.push_back({geometry, within(tile.group->place, tile.tile->place), geometry->elements()});
  }
  even_ = std::move(even);

  // Where joining doesn't help, as with long lines across each other: an even share of all.
  most = pixels < kCoarsest ? kMostSceneElements : most;
  const double share = all > most ? static_cast<double>(most) / static_cast<double>(all) : 1.0;
  for (SeenDetail& detail : seen_) {
    detail.count = static_cast<std::size_t>(std::floor(share * static_cast<double>(detail.count)));
  }
  std::erase_if(seen_, [](const SeenDetail& detail) { return detail.count == 0; });
  return seen_;
}

}  // namespace vides
