// SPDX-License-Identifier: MIT
// A reference grid on the cube's floor, with the steps that dragging snaps to.
#include <cmath>

#include "scene/viewport_parts.hpp"

namespace vides {
namespace {

constexpr double kFloor = -1.0;
constexpr int kStrongEvery = 5;
// Lines nearer to each other than this would be a grey plane: every fifth is left then.
constexpr double kLeastApart = 6.0;

void addLines(std::vector<GeometryPoint>& points, double at) {
  points.push_back(geometryPoint(Vec3{at, kFloor, -1.0}));
  points.push_back(geometryPoint(Vec3{at, kFloor, 1.0}));
  points.push_back(geometryPoint(Vec3{-1.0, kFloor, at}));
  points.push_back(geometryPoint(Vec3{1.0, kFloor, at}));
}

}  // namespace

void GridPart::add(const ViewportContext& context) {
  if (!context.input.shown.grid || context.input.gridStep <= 0.0) return;
  double step = context.input.gridStep;
  while (step * context.view().pixelsPerUnit() < kLeastApart * context.scale() && step < 1.0) {
    step *= kStrongEvery;
  }
  std::vector<GeometryPoint> fine, strong;
  const auto lines = static_cast<int>(std::floor(1.0 / step + 1e-9));
  for (int i = -lines; i <= lines; ++i) {
    const double at = i * step;
    // The cube's own edges are dashed behind.
    if (context.input.shown.cube && std::abs(at) > 1.0 - 1e-9) continue;
    addLines(i % kStrongEvery == 0 ? strong : fine, at);
  }
  const Colour ground = mix(context.list.groundTop, context.list.groundBottom, 0.5);
  const Colour colour = context.colour(ColourRole::kGrid);
  DrawItem item;
  item.lift = -3;
  item.fade = 0.3f;
  item.geometry = fine_.keep(Primitive::kSegments, std::move(fine));
  item.style = LineStyle{mix(colour, ground, 0.6), context.pixels(1.0)};
  context.list.items.push_back(item);
  item.geometry = strong_.keep(Primitive::kSegments, std::move(strong));
  item.style = LineStyle{colour, context.pixels(1.0)};
  context.list.items.push_back(item);
}

}  // namespace vides
