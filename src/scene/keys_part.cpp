// SPDX-License-Identifier: MIT
// Crosses of the keys, marks of the selected ones, their numbers, smaller and fewer where they
// crowd.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "scene/viewport_parts.hpp"

namespace vides {
namespace {

constexpr double kCrossRadius = 7.0, kCurrentRadius = 8.0, kSelectedRadius = 9.5;
constexpr double kHoverStep = 1.5;
// So many keys never bury the curve, also where all are seen one behind the other.
constexpr std::size_t kFewKeys = 32;
constexpr double kPlateOpacity = 0.88;
constexpr double kLeaderOpacity = 0.6;
constexpr double kEdgeInset = 14.0;
constexpr std::size_t kMostNumbers = 250;
// So many keys that changed are looked up one by one.
constexpr std::size_t kFewChanged = 64;

// The current key alone needs no mark: it has its colour.
bool showsSelection(const ViewportContext& context) {
  const ViewportState& state = context.input.state;
  return state.selected.size() > 1 ||
         (!state.selected.empty() && state.selected.front() != state.current.key);
}

}  // namespace

bool ViewportContext::sees(const Vec2& pixel, double margin) const {
  const PixelRectangle& r = view().pixels();
  return pixel.x >= r.x - margin && pixel.y >= r.y - margin && pixel.x <= r.x + r.width + margin &&
         pixel.y <= r.y + r.height + margin;
}

void ViewportContext::addLabel(DrawText text, const LabelPlacer::Place& place, const Vec2& anchor,
                               const Vec2& size, bool needed) const {
  if (place.away) {
    const Vec2 nearest = glm::clamp(anchor, place.corner, place.corner + size);
    const Vec2 way = nearest - anchor;
    const double length = glm::length(way), gap = 7.0 * handleScale();
    if (length > 1.5 * gap) {
      DrawItem line;
      line.geometry = std::make_shared<const Geometry>(
          Geometry{Primitive::kSegments,
                   {geometryPoint(anchor + way * (gap / length)), geometryPoint(nearest)}});
      line.style = LineStyle{faded(text.colour, kLeaderOpacity), pixels(1.0)};
      line.space = DrawSpace::kPixels;
      line.depth = DrawDepth::kOnTop;
      list.items.push_back(line);
    }
  }
  // What is current stands out from the scene, too, of which labels know nothing.
  text.haloed = place.covers || needed || !input.scenes.empty();
  if (needed && crowded) {
    const PixelRectangle& r = view().pixels();
    const double down = std::clamp((text.pixel.y + 0.5 * size.y - r.y) / r.height, 0.0, 1.0);
    const Vec2 edge{3.0 * scale(), 1.0 * scale()};
    const Vec2 low = text.pixel - edge, high = text.pixel + size + edge;
    DrawItem item;
    item.geometry = std::make_shared<const Geometry>(
        Geometry{Primitive::kTriangles,
                 {geometryPoint(low), geometryPoint(Vec2{high.x, low.y}), geometryPoint(high),
                  geometryPoint(low), geometryPoint(high), geometryPoint(Vec2{low.x, high.y})}});
    item.style = FillStyle{faded(mix(list.groundTop, list.groundBottom, down), kPlateOpacity)};
    item.space = DrawSpace::kPixels;
    item.depth = DrawDepth::kOnTop;
    list.items.push_back(item);
  }
  list.texts.push_back(std::move(text));
}

std::optional<KeysPart::Place> KeysPart::placeOf(const ViewportContext& context, std::size_t index,
                                                 const Key& key) const {
  const auto pixel = context.view().project(key.position);
  if (!pixel || !context.sees(*pixel, 0.0)) return std::nullopt;
  return Place{index, *pixel, geometryPoint(key.position)};
}

void KeysPart::findAll(const ViewportContext& context) {
  seen_.clear();
  std::size_t index = 0;
  context.flight().keys.forEach([&](const Key& key) {
    if (const auto place = placeOf(context, index, key)) seen_.push_back(*place);
    ++index;
  });
  if (cell_ == 0.0) return;
  crowding_.begin(context.view().pixels(), cell_);
  for (const Place& place : seen_) crowding_.add(place.pixel);
}

bool KeysPart::findChanged(const ViewportContext& context) {
  const KeyList& keys = context.flight().keys;
  const ViewProjection& view = context.view();
  if (keys.size() != keys_.size() || view.matrix() != view_.matrix() ||
      view.pixels() != view_.pixels()) {
    return false;
  }
  const auto changes = KeyList::Sequence::changes(keys_.sequence(), keys.sequence());
  std::size_t count = 0;
  for (const auto& change : changes) count += change.newLast - change.first;
  if (count > kFewChanged) return false;
  for (const auto& change : changes) {
    for (std::size_t k = change.first; k < change.newLast; ++k) {
      auto at = std::ranges::lower_bound(seen_, k, {}, &Place::key);
      if (at != seen_.end() && at->key == k) {
        if (cell_ > 0.0) crowding_.remove(at->pixel);
        at = seen_.erase(at);
      }
      if (const auto place = placeOf(context, k, keys[k])) {
        if (cell_ > 0.0) crowding_.add(place->pixel);
        seen_.insert(at, *place);
      }
    }
  }
  return true;
}

void KeysPart::find(const ViewportContext& context) {
  crowded_ = false;
  if (!context.input.shown.keys) {
    seen_.clear();
    keys_ = {};
    return;
  }
  const bool few = context.flight().keys.size() <= kFewKeys;
  const double cell = few ? 0.0 : kCrowdingRadii * kCrossRadius * context.handleScale();
  if (std::exchange(cell_, cell) != cell || !findChanged(context)) findAll(context);
  keys_ = context.flight().keys;
  view_ = context.view();
  giveRoom(context);
  const Vec2 half{5.0 * context.handleScale()};
  for (const Place& place : seen_) {
    context.list.handles.push_back(
        {{HandleKind::kKey, place.key, 0, Axis::X}, place.pixel, context.reach(10.0)});
    context.labels.blockBox(place.pixel - half, place.pixel + half, kBlockedByMark);
  }
}

void KeysPart::giveRoom(const ViewportContext& context) {
  for (Place& place : seen_) {
    if (cell_ > 0.0 && crowding_.changed(place.pixel)) {
      place.share = crossShare(crowding_.around(place.pixel), place.key);
    }
    place.point.along = static_cast<float>(1.0 - place.share);
    if (place.share < 1.0) crowded_ = true;
  }
  crowding_.settle();
  if (crowded_ && showsSelection(context)) giveRoomToSelected(context);
}

// Selected keys have room as long as they do not crowd each other.
void KeysPart::giveRoomToSelected(const ViewportContext& context) {
  crowdingOfSelected_.begin(context.view().pixels(), cell_);
  const std::vector<std::size_t>& selected = context.input.state.selected;
  const auto forEachSelected = [&](const auto& use) {
    auto at = seen_.begin();
    for (std::size_t i = 0; i < selected.size(); ++i) {
      at = std::ranges::lower_bound(at, seen_.end(), selected[i], {}, &Place::key);
      if (at == seen_.end()) return;
      if (at->key == selected[i]) use(*at, i);
    }
  };
  forEachSelected([&](Place& place, std::size_t) { crowdingOfSelected_.add(place.pixel); });
  forEachSelected([&](Place& place, std::size_t number) {
    const double share = crossShare(crowdingOfSelected_.around(place.pixel), number);
    place.point.along = std::min(place.point.along, static_cast<float>(1.0 - share));
  });
}

void KeysPart::addCrosses(const ViewportContext& context) {
  if (!context.input.shown.keys) return;
  const std::size_t current = context.input.state.current.key;
  std::vector<GeometryPoint> points;
  for (const Place& place : seen_) {
    if (place.key != current && place.point.along < 1.0f) points.push_back(place.point);
  }
  DrawItem item;
  item.depth = DrawDepth::kOnTop;
  item.geometry = crosses_.keep(Primitive::kMarkers, std::move(points));
  item.style = MarkerStyle{MarkerShape::kCross, context.colour(ColourRole::kKey), kNoColour,
                           context.handlePixels(kCrossRadius), context.handlePixels(1.7)};
  context.list.items.push_back(item);
}
void KeysPart::addSelected(const ViewportContext& context) {
  const ViewportState& state = context.input.state;
  const auto& keys = context.flight().keys;
  std::vector<GeometryPoint> points;
  if (showsSelection(context)) {
    auto at = seen_.begin();
    for (const std::size_t key : state.selected) {
      if (key >= keys.size()) break;
      at = std::ranges::lower_bound(at, seen_.end(), key, {}, &Place::key);
      const bool seen = at != seen_.end() && at->key == key;
      points.push_back(seen ? at->point : geometryPoint(keys[key].position));
      if (key == state.current.key) points.back().along = 0.0f;
    }
    std::erase_if(points, [](const GeometryPoint& point) { return point.along >= 1.0f; });
  }
  DrawItem item;
  item.depth = DrawDepth::kOnTop;
  item.geometry = selected_.keep(Primitive::kMarkers, std::move(points));
  item.style =
      MarkerStyle{MarkerShape::kSquare, context.colour(ColourRole::kKeySelected), kNoColour,
                  context.handlePixels(kSelectedRadius), context.handlePixels(1.2)};
  context.list.items.push_back(item);
}

void KeysPart::addMarks(const ViewportContext& context) {
  if (!context.input.shown.keys) return;
  addSelected(context);
  const auto& keys = context.flight().keys;
  const auto& state = context.input.state;
  const auto addCross = [&](GeometrySlot& slot, std::size_t key, ColourRole role, double radius) {
    DrawItem item;
    item.depth = DrawDepth::kOnTop;
    item.geometry = slot.keep(Primitive::kMarkers, {geometryPoint(keys[key].position)});
    item.style = MarkerStyle{MarkerShape::kCross, context.colour(role), kNoColour,
                             context.handlePixels(radius), context.handlePixels(2.2)};
    context.list.items.push_back(item);
  };
  const bool currentHovered = context.hovered({HandleKind::kKey, state.current.key, 0, Axis::X});
  addCross(current_, state.current.key, ColourRole::kAccent,
           kCurrentRadius + (currentHovered ? kHoverStep : 0.0));
  if (!state.hovered || state.hovered->kind != HandleKind::kKey || currentHovered) return;
  if (state.hovered->key >= keys.size()) return;
  addCross(hovered_, state.hovered->key, ColourRole::kKey, kCrossRadius + kHoverStep);
}

bool KeysPart::addNumber(const ViewportContext& context, const Place& place, bool needed) const {
  const bool current = place.key == context.input.state.current.key;
  const std::string text = std::to_string(place.key + 1);
  const Vec2 size{static_cast<double>(text.size()) * context.input.text.digitWidth,
                  context.input.text.lineHeight};
  const bool marked = showsSelection(context) &&
                      std::ranges::binary_search(context.input.state.selected, place.key);
  // The current key's plane squares need room.
  const double free = current && context.input.shown.planeSquares ? 20.0 : marked ? 15.0 : 9.0;
  const double gap = free * context.handleScale();
  const auto label = context.labels.place(place.pixel, gap, size, needed);
  if (!label) return false;
  const ColourRole role = current ? ColourRole::kAccent : ColourRole::kKey;
  context.addLabel({text, label->corner, context.colour(role), current}, *label, place.pixel, size,
                   needed);
  return true;
}

void KeysPart::addNumbers(const ViewportContext& context) const {
  if (!context.input.shown.keys || !context.input.shown.numbers) return;
  const bool all = !context.cramped();
  const std::size_t current = context.input.state.current.key;
  const auto own = std::ranges::lower_bound(seen_, current, {}, &Place::key);
  if (own != seen_.end() && own->key == current) addNumber(context, *own, true);
  // Which one is under the pointer is always told: here as long as it is not.
  std::size_t untold = current;
  if (const auto& id = context.input.state.hovered; id && id->kind == HandleKind::kKey) {
    untold = id->key;
  }
  // Of many every 10th, 100th, … and the first.
  std::size_t step = 1;
  while (seen_.size() / step > kMostNumbers) step *= 10;
  std::size_t round = step;
  for (const Place& place : seen_) {
    while (round < place.key + 1) round += step;
    const bool counts = all && (place.key == 0 || place.key + 1 == round);
    if (place.key == current || !counts || !addNumber(context, place, false)) continue;
    if (place.key == untold) untold = current;
  }
  if (untold == current) return;
  const auto under = std::ranges::lower_bound(seen_, untold, {}, &Place::key);
  if (under != seen_.end() && under->key == untold) addNumber(context, *under, true);
}

// As the aim's second ring does: on the way to it from the middle.
void KeysPart::addOutside(const ViewportContext& context) {
  if (!context.input.shown.keys) return;
  const Vec3& key = context.flight().keys[context.input.state.current.key].position;
  const auto pixel = context.view().project(key);
  if (pixel && context.sees(*pixel, 0.0)) return;
  const Vec2 at = edgePlace(context.view(), key, std::nullopt, kEdgeInset * context.scale());
  DrawItem item;
  item.geometry = outside_.keep(Primitive::kMarkers, {geometryPoint(at)});
  item.space = DrawSpace::kPixels;
  item.depth = DrawDepth::kOnTop;
  item.style = MarkerStyle{MarkerShape::kRing, faded(context.colour(ColourRole::kAccent), 0.6),
                           context.colour(ColourRole::kHandleFill), context.handlePixels(9.0),
                           context.handlePixels(1.2)};
  context.list.items.push_back(item);
  item.style = MarkerStyle{MarkerShape::kCross, context.colour(ColourRole::kAccent), kNoColour,
                           context.handlePixels(4.5), context.handlePixels(2.0)};
  context.list.items.push_back(item);
  if (context.input.shown.numbers)
    addNumber(context, {context.input.state.current.key, at, {}}, true);
}

}  // namespace vides
