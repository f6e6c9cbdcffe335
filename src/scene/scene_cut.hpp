// SPDX-License-Identifier: MIT
// What of large scenes is drawn in a view: a cut through the grids' cells.
//
// How much it is depends on what is seen. Where a picture would show more than it has room for,
// cells that cover no more than so many pixels stand for what is in them: near ones are finer than
// far ones, and all together so many that a wireframe can still be told from a grey patch. Which
// cell stands for a position depends on the cell alone, not on the tile whose edge leads there: so
// tiles meet wherever their detail differs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "math/view_projection.hpp"
#include "scene/drawable_scene.hpp"

namespace vides {

// What is to be drawn of a tile: `count` elements of a geometry.
struct SeenDetail {
  SharedGeometry geometry;
  Placement place;  // in the cube
  std::size_t count = 0;
};

struct PlacedTiles {
  SharedDrawable scene;  // not null
  const DrawableScene::Tiles& (DrawableScene::*tiles)() const = nullptr;
  Placement place;  // from scene units to the cube
  bool operator==(const PlacedTiles&) const = default;
};

class SceneCut {
 public:
  // At most kMostSceneElements. `margin` in pixels: what stands so far outside the picture still
  // shows in it. Valid until the next call; the same view of the same tiles has the same geometry.
  const std::vector<SeenDetail>& see(std::vector<PlacedTiles> groups, const ViewProjection& view,
                                     double margin);

 private:
  // Which cell stands for each cell that was asked for, found once a call.
  struct Found {
    std::uint32_t call = 0;
    std::uint32_t cell = 0;
    int level = 0;
  };
  using FoundCells = std::vector<std::vector<Found>>;  // by level
  class Finder;
  struct SeenTile;

  SharedGeometry joined(const SeenTile& tile, Finder& finder);

  std::vector<PlacedTiles> groups_;
  ViewProjection view_;
  double margin_ = -1.0;
  std::vector<SeenDetail> seen_;
  std::uint32_t call_ = 0;
  std::vector<FoundCells> found_;  // of each group
  // Tiles joined to one level that has no detail of its own: they are the same in other views.
  std::map<std::pair<const DrawableScene::Tile*, int>, SharedGeometry> even_;
};

}  // namespace vides
