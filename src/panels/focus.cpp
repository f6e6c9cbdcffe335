// SPDX-License-Identifier: MIT
// The ring of a panel or window, made of what the registry holds.
#include "panels/focus.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace vides {
namespace {

bool takesPart(const Widget& widget) {
  switch (widget.kind) {
    case WidgetKind::kButton:
    case WidgetKind::kToggle:
    case WidgetKind::kSlider:
    case WidgetKind::kField:
    case WidgetKind::kEntry:
      return widget.enabled;
    default:
      return false;
  }
}

// In the order in which they are drawn.
std::vector<const Widget*> ringOf(const WidgetRegistry& registry, std::string_view name) {
  std::vector<const Widget*> ring;
  for (const auto& [id, widget] : registry.widgets()) {
    if (widget.ring == name && takesPart(widget)) ring.push_back(&widget);
  }
  std::sort(ring.begin(), ring.end(),
            [](const Widget* a, const Widget* b) { return a->order < b->order; });
  return ring;
}

// The one that is drawn next after (before) that place in the order, round and round.
const Widget* nextOf(const std::vector<const Widget*>& ring, std::size_t order, int step) {
  const auto after = std::upper_bound(ring.begin(), ring.end(), order,
                                      [](std::size_t o, const Widget* w) { return o < w->order; });
  if (step > 0) return after == ring.end() ? ring.front() : *after;
  const auto from = std::lower_bound(ring.begin(), ring.end(), order,
                                     [](const Widget* w, std::size_t o) { return w->order < o; });
  return from == ring.begin() ? ring.back() : *(from - 1);
}

}  // namespace

void KeyboardFocus::drop() {
  if (!widget_.empty()) last_ = widget_;
  widget_.clear();
}

bool KeyboardFocus::operable(const WidgetRegistry& registry) const {
  const Widget* const widget = registry.find(widget_);
  return widget != nullptr && takesPart(*widget) && widget->kind != WidgetKind::kEntry;
}

bool KeyboardFocus::settle(const WidgetRegistry& registry) {
  operates_ = arrives_ = false;
  // One that is gone hasn't got it; one that is greyed keeps it, so that Enter hits no other.
  // A window that has opened takes it from what was operated.
  const Widget* from = registry.find(widget_);
  if (from != nullptr && !window_.empty() && from->ring != window_) from = nullptr;
  if (from == nullptr) widget_.clear();
  if (step_ == 0) return false;
  const int step = std::exchange(step_, 0);
  const std::string name = from != nullptr ? from->ring : window_;
  const std::vector<const Widget*> ring = ringOf(registry, name);
  if (name.empty() || ring.empty()) return false;
  if (from == nullptr) from = registry.find(last_);
  // What takes text for as long as its window is open is where a window begins.
  if (from == nullptr || from->ring != name) {
    const auto entry = std::find_if(ring.begin(), ring.end(), [](const Widget* widget) {
      return widget->kind == WidgetKind::kEntry;
    });
    from = entry == ring.end() ? nullptr : *entry;
  }
  const Widget* const next = from != nullptr ? nextOf(ring, from->order, step)
                             : step > 0      ? ring.front()
                                             : ring.back();
  widget_ = next->id;
  arrives_ = true;
  return true;
}

bool KeyboardFocus::takeArrival(std::string_view widget) {
  if (widget_ != widget) return false;
  return std::exchange(arrives_, false);
}

bool KeyboardFocus::takeOperation(std::string_view widget) {
  if (widget_ != widget) return false;
  return std::exchange(operates_, false);
}

}  // namespace vides
