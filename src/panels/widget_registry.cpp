// SPDX-License-Identifier: MIT
// What is on screen, by name.
#include "panels/widget_registry.hpp"

#include <algorithm>
#include <utility>

namespace vides {

Rect Rect::intersect(const Rect& other) const {
  const float left = std::max(x, other.x);
  const float top = std::max(y, other.y);
  return {left, top, std::max(0.0f, std::min(right(), other.right()) - left),
          std::max(0.0f, std::min(bottom(), other.bottom()) - top)};
}

std::string_view name(WidgetKind kind) {
  switch (kind) {
    case WidgetKind::kButton:
      return "button";
    case WidgetKind::kToggle:
      return "toggle";
    case WidgetKind::kSlider:
      return "slider";
    case WidgetKind::kField:
      return "field";
    case WidgetKind::kEntry:
      return "entry";
    case WidgetKind::kText:
      return "text";
    case WidgetKind::kChoice:
      return "choice";
    case WidgetKind::kMenu:
      return "menu";
    case WidgetKind::kMenuItem:
      return "menu item";
    case WidgetKind::kArea:
      return "area";
  }
  return "";
}

void WidgetRegistry::beginFrame() {
  widgets_.clear();
  texts_.clear();
}

void WidgetRegistry::add(Widget widget) {
  std::string id = widget.id;
  widget.ring = ring_.empty() ? id.substr(0, id.find('/')) : ring_;
  widget.order = widgets_.size();
  widgets_.insert_or_assign(std::move(id), std::move(widget));
}

const Widget* WidgetRegistry::find(std::string_view id) const {
  const auto found = widgets_.find(id);
  return found == widgets_.end() ? nullptr : &found->second;
}

}  // namespace vides
