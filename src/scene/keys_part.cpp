// SPDX-License-Identifier: MIT
// Crosses of the keys, marks of the selected ones, their numbers, thinned where they are dense.
#include <algorithm>
#include <cmath>
#include <string>

#include "scene/viewport_parts.hpp"

namespace vides {
namespace {

constexpr double kCrossRadius = 7.0, kCurrentRadius = 8.0, kSelectedRadius = 9.5;
constexpr double kHoverStep = 1.5;
// Crosses nearer to each other than this cannot be told apart.
constexpr double kDenseCell = 5.0;
constexpr std::size_t kMostNumbers = 250;
// So many keys that changed are looked up one by one.
constexpr std::size_t kFewChanged = 64;

// A map of what a cross has already been drawn in.
class Density {
 public:
  Density(const PixelRectangle& area, double cell) : area_(area), cell_(cell) {
    columns_ = static_cast<std::size_t>(area.width / cell) + 3;
    const std::size_t rows = static_cast<std::size_t>(area.height / cell) + 3;
    taken_.assign(columns_ * rows, false);
  }
  // True for the first in a cell. The pixel lies in the area, or less than a cell outside.
  bool take(const Vec2& pixel) {
    const auto x = static_cast<std::size_t>((pixel.x - area_.x) / cell_ + 1.0);
    const auto y = static_cast<std::size_t>((pixel.y - area_.y) / cell_ + 1.0);
    const std::size_t at = y * columns_ + x;
    if (at >= taken_.size() || taken_[at]) return false;
    taken_[at] = true;
    return true;
  }

 private:
  PixelRectangle area_;
  double cell_;
  std::size_t columns_ = 0;
  std::vector<bool> taken_;
};

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
      if (at != seen_.end() && at->key == k) at = seen_.erase(at);
      if (const auto place = placeOf(context, k, keys[k])) seen_.insert(at, *place);
    }
  }
  return true;
}

void KeysPart::find(const ViewportContext& context) {
  if (!context.input.shown.keys) {
    seen_.clear();
    keys_ = {};
    return;
  }
  if (!findChanged(context)) findAll(context);
  keys_ = context.flight().keys;
  view_ = context.view();
  const Vec2 half{5.0 * context.handleScale()};
  for (const Place& place : seen_) {
    context.list.handles.push_back(
        {{HandleKind::kKey, place.key, 0, Axis::X}, place.pixel, 10.0 * context.handleScale()});
    context.labels.blockBox(place.pixel - half, place.pixel + half, kBlockedByMark);
  }
}

void KeysPart::addCrosses(const ViewportContext& context) {
  if (!context.input.shown.keys) return;
  const std::size_t current = context.input.state.current.key;
  Density density(context.view().pixels(), kDenseCell * context.scale());
  std::vector<GeometryPoint> points;
  for (const Place& place : seen_) {
    if (place.key == current || !density.take(place.pixel)) continue;
    points.push_back(place.point);
  }
  DrawItem item;
  item.depth = DrawDepth::kOnTop;
  item.geometry = crosses_.keep(Primitive::kMarkers, std::move(points));
  item.style = MarkerStyle{MarkerShape::kCross, context.colour(ColourRole::kKey), kNoColour,
                           context.handlePixels(kCrossRadius), context.handlePixels(1.7)};
  context.list.items.push_back(item);
  addMarks(context);
}

void KeysPart::addMarks(const ViewportContext& context) {
  const auto& keys = context.flight().keys;
  const auto& state = context.input.state;
  DrawItem item;
  item.depth = DrawDepth::kOnTop;

  std::vector<GeometryPoint> points;
  if (showsSelection(context)) {
    for (const std::size_t key : state.selected) {
      if (key < keys.size()) points.push_back(geometryPoint(keys[key].position));
    }
  }
  item.geometry = selected_.keep(Primitive::kMarkers, std::move(points));
  item.style =
      MarkerStyle{MarkerShape::kSquare, context.colour(ColourRole::kKeySelected), kNoColour,
                  context.handlePixels(kSelectedRadius), context.handlePixels(1.2)};
  context.list.items.push_back(item);

  const auto addCross = [&](GeometrySlot& slot, std::size_t key, ColourRole role, double radius,
                            double width) {
    item.geometry = slot.keep(Primitive::kMarkers, {geometryPoint(keys[key].position)});
    item.style = MarkerStyle{MarkerShape::kCross, context.colour(role), kNoColour,
                             context.handlePixels(radius), context.handlePixels(width)};
    context.list.items.push_back(item);
  };
  const bool currentHovered = context.hovered({HandleKind::kKey, state.current.key, 0, Axis::X});
  addCross(current_, state.current.key, ColourRole::kAccent,
           kCurrentRadius + (currentHovered ? kHoverStep : 0.0), 2.2);
  if (!state.hovered || state.hovered->kind != HandleKind::kKey || currentHovered) return;
  if (state.hovered->key >= keys.size()) return;
  addCross(hovered_, state.hovered->key, ColourRole::kKey, kCrossRadius + kHoverStep, 2.2);
}

void KeysPart::addNumber(const ViewportContext& context, const Place& place, bool current) const {
  const std::string text = std::to_string(place.key + 1);
  const Vec2 size{static_cast<double>(text.size()) * context.input.text.digitWidth,
                  context.input.text.lineHeight};
  const bool marked = showsSelection(context) &&
                      std::ranges::binary_search(context.input.state.selected, place.key);
  // The current key's plane squares need room.
  const double free = current && context.input.shown.planeSquares ? 20.0 : marked ? 15.0 : 9.0;
  const double gap = free * context.handleScale();
  const auto pixel = context.labels.place(place.pixel, gap, size, current);
  if (!pixel) return;
  const ColourRole role = current ? ColourRole::kAccent : ColourRole::kKey;
  context.list.texts.push_back({text, *pixel, context.colour(role), current});
}

void KeysPart::addNumbers(const ViewportContext& context) const {
  if (!context.input.shown.keys || !context.input.shown.numbers) return;
  const std::size_t current = context.input.state.current.key;
  const auto own = std::ranges::lower_bound(seen_, current, {}, &Place::key);
  if (own != seen_.end() && own->key == current) addNumber(context, *own, true);
  // Of many every 10th, 100th, … and the first.
  std::size_t step = 1;
  while (seen_.size() / step > kMostNumbers) step *= 10;
  std::size_t round = step;
  for (const Place& place : seen_) {
    while (round < place.key + 1) round += step;
    const bool counts = place.key == 0 || place.key + 1 == round;
    if (place.key != current && counts) addNumber(context, place, false);
  }
}

}  // namespace vides
