// SPDX-License-Identifier: MIT
// A scene made ready for drawing, once, whatever looks at it: divided into tiles, and each tile of
// a large scene in several degrees of detail.
//
// How much of a large scene is drawn depends on what is seen of it. A coarser detail joins the
// positions in each cell of a grid (their mean stands for them) and keeps the edges that still lead
// from cell to cell: what differs from the whole is smaller than a cell. Where a picture would show
// more than it has room for, near tiles are drawn finer than far ones, and all together so much
// that a wireframe can still be told from a grey patch. Scenes of an eighth of
// kMostSceneElements are always whole.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "math/view_projection.hpp"
#include "scene/draw_list.hpp"
#include "scene/scene_geometry.hpp"
#include "scene/scene_reader.hpp"

namespace vides {

// Edges or points of all scenes in one picture: in the largest; a picture of 100 × 100 pixels has
// an eighth of it.
inline constexpr std::size_t kMostSceneElements = 131072;

class DrawableScene {
 public:
  struct Detail {
    double cell = 0.0;  // width of the grid's cells; 0: whole
    SharedGeometry geometry;
  };
  // Finest first; boxes and geometry in the coordinates that place() leads from.
  struct Tile {
    Vec3 low{0.0}, high{0.0};
    std::vector<Detail> details;
  };
  using Tiles = std::vector<Tile>;

  // Null where it was stopped.
  static std::shared_ptr<const DrawableScene> make(const SceneGeometry& scene,
                                                   const KeepGoing& keepGoing = {});

  const Tiles& edges() const { return edges_; }
  const Tiles& positions() const { return positions_; }
  const Tiles& points() const { return points_; }  // single points that the file names
  // From the tiles' coordinates, -1 to 1, to scene units.
  const Placement& place() const { return place_; }
  // Of all positions.
  const BoundingBox& box() const { return box_; }
  // What its reading told.
  const SceneReport& report() const { return report_; }

 private:
  Tiles edges_, positions_, points_;
  Placement place_;
  BoundingBox box_;
  SceneReport report_;
};
using SharedDrawable = std::shared_ptr<const DrawableScene>;

// What of some tiles is to be drawn in a view: `count` elements of a geometry.
struct SeenDetail {
  SharedGeometry geometry;
  Placement place;
  std::size_t count = 0;
};
// At most kMostSceneElements. `place` leads from each group's coordinates to the cube's;
// `margin` in pixels: what stands so far outside the picture still shows in it.
struct PlacedTiles {
  const DrawableScene::Tiles* tiles = nullptr;
  Placement place;
};
std::vector<SeenDetail> seenDetails(const std::vector<PlacedTiles>& groups,
                                    const ViewProjection& view, double margin);

}  // namespace vides
