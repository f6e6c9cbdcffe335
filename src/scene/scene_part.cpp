// SPDX-License-Identifier: MIT
// Styles for the parts of the scenes that are seen.
#include "scene/scene_part.hpp"

namespace vides {
namespace {

// A point is a little wider than a line, so that it is seen where none leads to it.
constexpr float kPointRadius = 1.3f / 1.2f;
constexpr float kFade = 0.45f;

Placement inCube(const Placement& place, const Space& space) {
  return {space.toCube(place.origin), place.unit / space.halfSize};
}

}  // namespace

void addScenes(DrawList& list, const ScenesInput& input, const Theme& theme) {
  const Colour colour = theme[ColourRole::kScene];
  const float pointRadius = kPointRadius * input.lineWidth;
  const auto add = [&](const DrawableScene::Tiles& (DrawableScene::*tiles)() const,
                       const auto& style) {
    std::vector<PlacedTiles> groups;
    for (const SharedDrawable& scene : input.scenes) {
      groups.push_back({&(*scene.*tiles)(), inCube(scene->place(), input.space)});
    }
    for (SeenDetail& detail : seenDetails(groups, list.view, 2.0 * pointRadius)) {
      DrawItem item;
      item.geometry = std::move(detail.geometry);
      item.count = detail.count;
      item.place = detail.place;
      item.style = style;
      item.fade = kFade;
      list.items.push_back(std::move(item));
    }
  };
  const MarkerStyle disc{MarkerShape::kDisc, colour, kNoColour, pointRadius};
  if (input.asPoints) return add(&DrawableScene::positions, disc);
  add(&DrawableScene::points, disc);
  add(&DrawableScene::edges, LineStyle{colour, input.lineWidth});
}

}  // namespace vides
