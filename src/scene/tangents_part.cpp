// SPDX-License-Identifier: MIT
// The curve's two tangents at the current key, while its shape is edited.
#include "scene/viewport_parts.hpp"

namespace vides {
namespace {

// A third of a tangent reaches to the control point of the piece's Bezier form.
constexpr double kShare = 1.0 / 3.0;
// Shorter ones (full tension) would only smear the key's cross.
constexpr double kShortest = 1e-6;

}  // namespace

void TangentsPart::add(const ViewportContext& context) {
  if (!context.input.shown.tangents) return;
  const Evaluation& evaluation = context.input.evaluation;
  const std::size_t key = context.input.state.current.key;
  const std::size_t keys = context.flight().keys.size();
  const std::size_t pieces = evaluation.pieceCount();
  if (key >= keys) return;
  const Vec3& place = context.flight().keys[key].position;
  std::vector<GeometryPoint> lines, incoming, outgoing;
  const auto add = [&](const Vec3& tangent, std::vector<GeometryPoint>& ends) {
    if (glm::length(tangent) < kShortest) return;
    const Vec3 tip = place + kShare * tangent;
    lines.push_back(geometryPoint(place));
    lines.push_back(geometryPoint(tip));
    ends.push_back(geometryPoint(tip));
  };
  const bool closed = pieces == keys;
  if (key > 0 || closed) {
    const std::size_t before = key > 0 ? key - 1 : pieces - 1;
    if (evaluation.pieceLength(before) > 0.0)
      add(-evaluation.piece(before).derivative(1.0), incoming);
  }
  if (key < pieces && evaluation.pieceLength(key) > 0.0) {
    add(evaluation.piece(key).derivative(0.0), outgoing);
  }
  DrawItem item;
  item.depth = DrawDepth::kOnTop;
  item.geometry = lines_.keep(Primitive::kSegments, std::move(lines));
  item.style = LineStyle{context.colour(ColourRole::kCurve), context.handlePixels(1.4)};
  context.list.items.push_back(item);
  // The one that arrives ends hollow, the one that leaves filled.
  const auto addEnds = [&](GeometrySlot& slot, std::vector<GeometryPoint> ends, ColourRole fill) {
    item.geometry = slot.keep(Primitive::kMarkers, std::move(ends));
    item.style =
        MarkerStyle{MarkerShape::kSquare, context.colour(ColourRole::kCurve), context.colour(fill),
                    context.handlePixels(3.0), context.handlePixels(1.6)};
    context.list.items.push_back(item);
  };
  addEnds(incoming_, std::move(incoming), ColourRole::kHandleFill);
  addEnds(outgoing_, std::move(outgoing), ColourRole::kCurve);
}

}  // namespace vides
