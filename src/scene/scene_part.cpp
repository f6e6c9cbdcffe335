// SPDX-License-Identifier: MIT
// Styles for the parts of the scenes that are seen.
#include "scene/scene_part.hpp"

#include <glm/common.hpp>

namespace vides {
namespace {

// A point is a little wider than a line, so that it is seen where none leads to it.
constexpr float kPointRadius = 1.3f / 1.2f;
constexpr float kFade = 0.45f;

}  // namespace

Placement PlacedScene::placeIn(const Space& space) const {
  return {space.toCube(Vec3(0.0)), 1.0 / space.halfSize, uprightTurn(up)};
}

BoundingBox PlacedScene::box() const {
  const Mat3 turn = uprightTurn(up);
  const Vec3 a = turn * drawable->box().low, b = turn * drawable->box().high;
  return {glm::min(a, b), glm::max(a, b)};
}

void ScenePart::add(DrawList& list, const ScenesInput& input, const Theme& theme) {
  const Colour colour = theme[ColourRole::kScene];
  const float pointRadius = kPointRadius * input.lineWidth;
  using Which = const DrawableScene::Tiles& (DrawableScene::*)() const;
  const auto add = [&](SceneCut& cut, Which tiles, const auto& style) {
    std::vector<PlacedTiles> groups;
    for (const PlacedScene& scene : input.scenes) {
      groups.push_back({scene.drawable, tiles, scene.placeIn(input.space)});
    }
    for (const SeenDetail& detail : cut.see(groups, list.view, 2.0 * pointRadius)) {
      DrawItem item;
      item.geometry = detail.geometry;
      item.count = detail.count;
      item.place = detail.place;
      item.style = style;
      item.fade = kFade;
      list.items.push_back(std::move(item));
    }
  };
  const MarkerStyle disc{MarkerShape::kDisc, colour, kNoColour, pointRadius};
  if (input.asPoints) return add(main_, &DrawableScene::positions, disc);
  add(points_, &DrawableScene::points, disc);
  add(main_, &DrawableScene::edges, LineStyle{colour, input.lineWidth});
}

}  // namespace vides
