// SPDX-License-Identifier: MIT
// The curve in the viewport: chunks that can be seen, the current piece apart.
#include <algorithm>
#include <optional>

#include "scene/viewport_parts.hpp"

namespace vides {
namespace {

constexpr float kCurveFade = 0.4f;
// The share of the ground in the curve's colour where its crosses crowd: the current section and
// the marks stand out from the tangle.
constexpr double kCrowdedGround = 0.4;
// The current section is wider than the others: 3 pixels where they have 2.2.
constexpr double kCurrentWider = 3.0 / 2.2;
// The curve keeps labels away as long as it has at most so many chords.
constexpr std::size_t kMostBlocking = 20000;

// The piece on which the current orientation's section moves.
std::optional<std::size_t> currentPiece(const ViewportInput& input) {
  const auto section = input.evaluation.sectionFrom(input.state.current);
  if (!section || section->kind != SectionKind::kMove) return std::nullopt;
  return input.state.current.key;
}

}  // namespace

void CurvePart::add(const ViewportContext& context) {
  flattener_.update(context.input.evaluation, context.view());
  current_.reset();
  if (!context.input.shown.curve) return;
  const auto current = currentPiece(context.input);
  const double reach = 2.0 * context.input.sizes.curve * context.scale();
  DrawItem item;
  item.fade = kCurveFade;
  const auto addRange = [&](std::size_t begin, std::size_t end) {
    item.first = begin;
    item.count = end - begin;
    if (end > begin) context.list.items.push_back(item);
  };
  const Colour ground = mix(context.list.groundTop, context.list.groundBottom, 0.5);
  const Colour colour =
      mix(context.colour(ColourRole::kCurve), ground, context.crowded ? kCrowdedGround : 0.0);
  for (const auto& chunk : flattener_.chunks()) {
    if (!mayBeSeen(context.view(), chunk.low, chunk.high, reach)) continue;
    item.geometry = chunk.geometry;
    item.style = LineStyle{colour, context.pixels(context.input.sizes.curve)};
    item.lift = 1;
    const bool here = current && *current >= chunk.first && *current - chunk.first < chunk.pieces();
    if (!here) {
      addRange(0, chunk.begins.back());
      continue;
    }
    const std::size_t piece = *current - chunk.first;
    addRange(0, chunk.begins[piece]);
    addRange(chunk.begins[piece + 1], chunk.begins.back());
    item.style = LineStyle{context.colour(ColourRole::kAccent),
                           context.pixels(kCurrentWider * context.input.sizes.curve)};
    item.lift = 2;
    item.fade = 0.0f;
    addRange(chunk.begins[piece], chunk.begins[piece + 1]);
    if (item.count > 0) current_ = item;
    item.fade = kCurveFade;
  }
  block(context);
}

void CurvePart::addCurrentOnTop(const ViewportContext& context) const {
  if (!current_) return;
  context.list.items.push_back(*current_);
  context.list.items.back().depth = DrawDepth::kOnTop;
}

void CurvePart::block(const ViewportContext& context) const {
  std::size_t chords = 0;
  for (const auto& chunk : flattener_.chunks()) chords += chunk.geometry->elements();
  if (chords > kMostBlocking || !context.input.shown.numbers) return;
  for (const auto& chunk : flattener_.chunks()) {
    std::optional<Vec2> before;
    const auto& points = chunk.geometry->points;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const auto here = context.view().project({points[i].x, points[i].y, points[i].z});
      if (before && here) context.labels.blockLine(*before, *here, kBlockedByLine);
      before = here;
    }
  }
}

}  // namespace vides
