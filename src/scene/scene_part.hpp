// SPDX-License-Identifier: MIT
// The imported scenes as they are drawn: wireframe, or points.
#pragma once

#include <vector>

#include "flight/flight.hpp"
#include "scene/draw_list.hpp"
#include "scene/drawable_scene.hpp"
#include "scene/theme.hpp"

namespace vides {

struct ScenesInput {
  std::vector<SharedDrawable> scenes;  // none of them null
  Space space;                         // from scene units to the cube
  bool asPoints = false;
  float lineWidth = 1.2f;  // pixels
};

// What of them the list's view shows.
void addScenes(DrawList& list, const ScenesInput& input, const Theme& theme);

}  // namespace vides
