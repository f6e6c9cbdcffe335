// SPDX-License-Identifier: MIT
// The current key's other orientations: where they look and which way is up, dim, with their
// numbers.
#include <algorithm>
#include <string>

#include "scene/viewport_parts.hpp"

namespace vides {
namespace {

constexpr double kStrength = 0.5;
constexpr double kRingRadius = 3.6;
constexpr double kSamePlace = 8.0;  // pixels: marks closer than that have one label
constexpr double kReach = 8.0;

}  // namespace

void OtherOrientationsPart::add(const ViewportContext& context) {
  marks_.clear();
  const OrientationPlace current = context.input.state.current;
  const auto& keys = context.flight().keys;
  if (current.key >= keys.size() || context.cramped()) return;
  const Key& key = keys[current.key];
  if (current.orientation >= key.orientations.size()) return;
  const ViewProjection& view = context.view();
  const double scale = context.input.contentScale;
  const Evaluation& evaluation = context.input.evaluation;
  const Vec3 currentAim = aimPoint(key, key.orientations[current.orientation]);
  const Vec3 currentTip = upTip(view, evaluation.cameraAt(current), scale);
  std::vector<GeometryPoint> aims, ups, rings;
  for (std::size_t o = 0; o < key.orientations.size(); ++o) {
    if (o == current.orientation) continue;
    Mark mark{o, {}, false};
    if (context.input.shown.aim) {
      const Vec3 aim = aimPoint(key, key.orientations[o]);
      const AimMark at = aimMark(view, key.position, aim, scale);
      mark = {o, at.pixel, !at.atEdge};
      if (glm::distance(aim, currentAim) > 1e-9) {
        aims.insert(aims.end(), {geometryPoint(key.position), geometryPoint(aim)});
        rings.push_back(geometryPoint(aim));
      }
    }
    if (context.input.shown.up) {
      const Vec3 tip = upTip(view, evaluation.cameraAt({current.key, o}), scale);
      const auto pixel = view.project(tip), other = view.project(currentTip);
      if (pixel && (!other || glm::distance(*pixel, *other) > kSamePlace * context.scale()))
        ups.insert(ups.end(), {geometryPoint(key.position), geometryPoint(tip)});
    }
    if (context.input.shown.aim) marks_.push_back(mark);
  }
  const auto line = [&](GeometrySlot& slot, std::vector<GeometryPoint> points, ColourRole role) {
    if (points.empty()) return;
    DrawItem item;
    item.geometry = slot.keep(Primitive::kSegments, std::move(points));
    item.style = LineStyle{faded(context.colour(role), kStrength), context.handlePixels(1.4)};
    item.depth = context.depthOfCurrent();
    item.lift = 2;
    context.list.items.push_back(item);
  };
  line(aims_, std::move(aims), ColourRole::kAim);
  line(ups_, std::move(ups), ColourRole::kUp);
  if (rings.empty()) return;
  DrawItem item;
  item.geometry = rings_.keep(Primitive::kMarkers, std::move(rings));
  item.style = MarkerStyle{MarkerShape::kRing, faded(context.colour(ColourRole::kAim), kStrength),
                           context.colour(ColourRole::kHandleFill),
                           context.handlePixels(kRingRadius), context.handlePixels(1.6)};
  item.depth = DrawDepth::kOnTop;
  context.list.items.push_back(item);
}

void OtherOrientationsPart::addNumbers(const ViewportContext& context) {
  const std::size_t key = context.input.state.current.key;
  std::vector<bool> told(marks_.size(), false);
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const Mark& mark = marks_[i];
    if (mark.inside && context.sees(mark.pixel, 0.0)) {
      context.list.handles.push_back(
          {{HandleKind::kAim, key, mark.orientation, Axis::X}, mark.pixel, context.reach(kReach)});
    }
    if (told[i]) continue;
    std::string words;
    double digits = 0.0, letters = 0.0;
    for (std::size_t j = i; j < marks_.size(); ++j) {
      if (glm::distance(marks_[j].pixel, mark.pixel) > kSamePlace * context.scale()) continue;
      told[j] = true;
      if (!words.empty()) words += ", ", letters += 1.0;
      const std::string number = std::to_string(marks_[j].orientation + 1);
      words += number;
      digits += static_cast<double>(number.size());
    }
    const ViewportText& text = context.input.text;
    const Vec2 size{digits * text.digitWidth + letters * text.letterWidth, text.lineHeight};
    const auto place = context.labels.place(mark.pixel, 9.0 * context.handleScale(), size, false);
    if (!place) continue;
    context.addLabel({words, place->corner, faded(context.colour(ColourRole::kAim), 0.75)}, *place,
                     mark.pixel, size, false);
  }
}

}  // namespace vides
