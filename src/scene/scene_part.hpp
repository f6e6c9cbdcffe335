// SPDX-License-Identifier: MIT
// The imported scenes as they are drawn: wireframe, or points.
#pragma once

#include <utility>
#include <vector>

#include "flight/flight.hpp"
#include "scene/draw_list.hpp"
#include "scene/drawable_scene.hpp"
#include "scene/scene_cut.hpp"
#include "scene/theme.hpp"

namespace vides {

// A scene and where it stands in scene units (3-vid-format, scene[]).
struct PlacedScene {
  SharedDrawable drawable;  // not null
  UpAxis up = UpAxis::kY;

  PlacedScene(SharedDrawable scene, UpAxis axis = UpAxis::kY)  // NOLINT: stands as its file has it
      : drawable(std::move(scene)), up(axis) {}
  // From the file's coordinates to the cube.
  Placement placeIn(const Space& space) const;
  // Of what is drawn, in scene units.
  BoundingBox box() const;
};

struct ScenesInput {
  std::vector<PlacedScene> scenes;
  Space space;  // from scene units to the cube
  bool asPoints = false;
  float lineWidth = 1.2f;  // pixels
};

// Keeps its geometry for as long as the view and the scenes stay the same.
class ScenePart {
 public:
  // What of them the list's view shows.
  void add(DrawList& list, const ScenesInput& input, const Theme& theme);

 private:
  SceneCut main_, points_;  // edges, or all positions; single points beside the edges
};

}  // namespace vides
