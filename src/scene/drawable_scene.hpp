// SPDX-License-Identifier: MIT
// A scene made ready for drawing, once, whatever looks at it: divided into tiles, and each tile of
// a large scene in several degrees of detail.
//
// A coarser detail joins the positions in each cell of a grid (their mean stands for them) and
// keeps the edges that still lead from cell to cell: what differs from the whole is smaller than a
// cell. The grids are those of all tiles, so that tiles of the same detail meet; scene_cut.hpp
// chooses what is drawn, and makes tiles of different detail meet. Scenes of an eighth of
// kMostSceneElements are always whole.
//
// Geometry is kept in coordinates of the tile's own, near which it is exact: something far away
// takes nothing from the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "scene/cell_tree.hpp"
#include "scene/draw_list.hpp"
#include "scene/scene_geometry.hpp"
#include "scene/scene_reader.hpp"

namespace vides {

// Edges or points of all scenes in one picture: in the largest; a picture of 100 × 100 pixels has
// an eighth of it.
inline constexpr std::size_t kMostSceneElements = 131072;
// As many are whole even in the smallest picture.
inline constexpr std::size_t kAlwaysWhole = kMostSceneElements / 8;

class DrawableScene {
 public:
  static constexpr int kWhole = -1;
  struct Detail {
    int level = kWhole;  // whose cells are joined, in cells().levels()
    SharedGeometry geometry;
    // Of a large scene: what the geometry's points are, cells of the level or positions.
    std::vector<std::uint32_t> corners;
  };
  // In scene units.
  struct Tile {
    Vec3 low{0.0}, high{0.0};
    Placement place;              // from the geometry's coordinates, -2 to 2
    std::vector<Detail> details;  // finest first
  };
  using Tiles = std::vector<Tile>;

  // Null where it was stopped.
  static std::shared_ptr<const DrawableScene> make(const SceneGeometry& scene,
                                                   const KeepGoing& keepGoing = {});

  const Tiles& edges() const { return edges_; }
  const Tiles& positions() const { return positions_; }
  const Tiles& points() const { return points_; }  // single points
  const CellTree& cells() const { return cells_; }
  // Of all positions.
  const BoundingBox& box() const { return box_; }
  // What its reading told.
  const SceneReport& report() const { return report_; }

 private:
  Tiles edges_, positions_, points_;
  CellTree cells_;
  BoundingBox box_;
  SceneReport report_;
};
using SharedDrawable = std::shared_ptr<const DrawableScene>;

}  // namespace vides
