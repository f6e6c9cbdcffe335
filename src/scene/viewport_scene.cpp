// SPDX-License-Identifier: MIT
// Puts the viewport's parts together, and finds what lies under the pointer.
#include "scene/viewport_scene.hpp"

#include <algorithm>
#include <cmath>

#include "scene/scene_part.hpp"
#include "scene/viewport_parts.hpp"

namespace vides {

namespace {

// A picture whose shorter side has so many pixels at content scale 1 has room for signs of full
// size; in the smallest they have this share of it.
constexpr double kRoomySide = 280.0;
constexpr double kLeastSigns = 0.55;

}  // namespace

double signScale(const PixelRectangle& picture, double contentScale) {
  const double side = std::min(picture.width, picture.height) / contentScale;
  return contentScale * std::clamp(side / kRoomySide, kLeastSigns, 1.0);
}

struct ViewportScene::Parts {
  DrawList list;
  Evaluation evaluation;
  CubePart cube;
  GridPart grid;
  CurvePart curve;
  KeysPart keys;
  TangentsPart tangents;
  OtherOrientationsPart others;
  AimPart aim;
  CamerasPart cameras;
  ScenePart scenes;
  DragPart drag;
};

ViewportScene::ViewportScene() : parts_(std::make_unique<Parts>()) {}
ViewportScene::~ViewportScene() = default;
ViewportScene::ViewportScene(ViewportScene&&) noexcept = default;
ViewportScene& ViewportScene::operator=(ViewportScene&&) noexcept = default;

const DrawList& ViewportScene::build(const ViewportInput& input) {
  Parts& p = *parts_;
  DrawList& list = p.list;
  p.evaluation = input.evaluation;
  list.view = viewProjection(input.view, input.rectangle);
  list.groundTop = input.theme[ColourRole::kViewportTop];
  list.groundBottom = input.theme[ColourRole::kViewportBottom];
  list.items.clear();
  list.texts.clear();
  list.handles.clear();

  const PixelRectangle& r = list.view.pixels();
  const Margins& m = input.margins;
  const PixelRectangle free{r.x + m.left, r.y + m.top, std::max(1.0, r.width - m.left - m.right),
                            std::max(1.0, r.height - m.top - m.bottom)};
  LabelPlacer labels(free, 4.0 * input.contentScale);
  for (const PixelRectangle& box : input.state.covered) {
    labels.blockBox({box.x, box.y}, {box.x + box.width, box.y + box.height}, kBlockedByLabel);
  }
  ViewportContext context{input, list, labels, signScale(r, input.contentScale)};
  p.grid.add(context);
  const float lineWidth = context.pixels(input.sizes.lines);
  if (input.shown.cube) {
    p.cube.add(list, input.theme, input.contentScale, lineWidth);
    for (const auto& [from, to] : kCubeEdges) {
      const auto a = list.view.project(cubeCorner(from)), b = list.view.project(cubeCorner(to));
      if (a && b) labels.blockLine(*a, *b, kBlockedByLine);
    }
  }
  if (input.shown.scene) {
    p.scenes.add(list, {input.scenes, context.flight().space, input.shown.sceneAsPoints, lineWidth},
                 input.theme);
  }
  p.cameras.add(context);
  // Marks block before any label is placed.
  p.keys.find(context);
  context.crowded = p.keys.crowded();
  p.curve.add(context);
  p.drag.addPlanes(context);
  p.drag.blockTriad(context);
  if (context.crowded) {
    p.keys.addCrosses(context);
    p.curve.addCurrentOnTop(context);
  }
  p.drag.addSquares(context);
  p.tangents.add(context);
  p.others.add(context);
  p.aim.add(context);
  p.others.addNumbers(context);
  if (!context.crowded) p.keys.addCrosses(context);
  p.keys.addMarks(context);
  p.keys.addNumbers(context);
  p.keys.addOutside(context);
  p.drag.addTriad(context);
  return list;
}

std::optional<CurveHit> ViewportScene::nearestOnCurve(const Vec2& pixel, double reach) const {
  const auto near = parts_->curve.flattener().nearest(pixel, reach);
  if (!near) return std::nullopt;
  const Evaluation& evaluation = parts_->evaluation;
  // The evaluator leads from the fraction of the length to the parameter: halve for the way back.
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (evaluation.pieceParameter(near->piece, middle) < near->parameter ? low : high) = middle;
  }
  return CurveHit{near->piece, near->parameter, 0.5 * (low + high),
                  evaluation.piece(near->piece).point(near->parameter), near->distance};
}

std::optional<HandleId> handleAt(const DrawList& list, const Vec2& pixel, std::size_t currentKey,
                                 double contentScale) {
  const auto distance = [&](const Handle& handle) { return glm::distance(handle.pixel, pixel); };
  const Handle* nearest = nullptr;
  for (const Handle& handle : list.handles) {
    if (distance(handle) > handle.radius) continue;
    if (nearest == nullptr || distance(handle) < distance(*nearest)) nearest = &handle;
  }
  if (nearest == nullptr) return std::nullopt;
  if (nearest->id.key == currentKey) return nearest->id;
  const Handle* preferred = nearest;
  for (const Handle& handle : list.handles) {
    if (handle.id.key != currentKey || distance(handle) > handle.radius) continue;
    if (distance(handle) > distance(*nearest) + 3.0 * contentScale) continue;
    if (preferred == nearest || distance(handle) < distance(*preferred)) preferred = &handle;
  }
  return preferred->id;
}

}  // namespace vides
