// SPDX-License-Identifier: MIT
// What is on screen, by name: `vides drive`, its list of widgets and the tests find widgets here.
//
// Filled anew in each display frame by the widgets themselves. An identifier is AREA/NAME in
// lower-case ASCII, the same in every language (5-editor).
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vides {

// Pixels of the picture, y down.
struct Rect {
  float x = 0.0f;
  float y = 0.0f;
  float width = 0.0f;
  float height = 0.0f;
  float right() const { return x + width; }
  float bottom() const { return y + height; }
  float centreX() const { return x + width / 2.0f; }
  float centreY() const { return y + height / 2.0f; }
  bool empty() const { return width < 1.0f || height < 1.0f; }
  bool contains(float px, float py) const {
    return px >= x && px < right() && py >= y && py < bottom();
  }
  Rect inset(float by) const { return {x + by, y + by, width - 2 * by, height - 2 * by}; }
  Rect intersect(const Rect& other) const;
  bool operator==(const Rect&) const = default;
};

enum class WidgetKind {
  kButton,
  kToggle,
  kSlider,
  kField,
  kEntry,  // text that takes effect while it is typed
  kText,
  kChoice,
  kMenu,
  kMenuItem,
  kArea
};
std::string_view name(WidgetKind kind);

struct Widget {
  std::string id;
  std::string label;  // as shown, in the current language
  WidgetKind kind = WidgetKind::kButton;
  Rect rect;
  Rect visible;       // the part of rect that its column doesn't hide
  std::string value;  // what it shows; empty for buttons
  bool enabled = true;
  std::string tip = {};   // what is told when the pointer rests on it
  std::string ring = {};  // of the keyboard (panels/focus.hpp): its panel or window
  std::size_t order = 0;  // in which widgets are drawn
};

// A text that was drawn, and the room that it had.
struct DrawnText {
  std::string text;
  float width = 0.0f;
  float box = 0.0f;
  bool shortened = false;  // text of the user's (a name), ended with … so that it fits
  Rect place = {};         // where it stands, as far as its column doesn't hide it
};

class WidgetRegistry {
 public:
  void beginFrame();
  void add(Widget widget);
  void addText(DrawnText text) { texts_.push_back(std::move(text)); }

  // What is added until the end of the scope belongs to this panel or window; outside of any to
  // its own area.
  class Ring {
   public:
    Ring(WidgetRegistry& registry, std::string name)
        : registry_(registry), before_(std::exchange(registry.ring_, std::move(name))) {}
    ~Ring() { registry_.ring_ = std::move(before_); }
    Ring(const Ring&) = delete;
    Ring& operator=(const Ring&) = delete;

   private:
    WidgetRegistry& registry_;
    std::string before_;
  };

  // Null where it isn't on screen.
  const Widget* find(std::string_view id) const;
  // By identifier.
  const std::map<std::string, Widget, std::less<>>& widgets() const { return widgets_; }
  const std::vector<DrawnText>& texts() const { return texts_; }

 private:
  std::map<std::string, Widget, std::less<>> widgets_;
  std::vector<DrawnText> texts_;
  std::string ring_;
};

}  // namespace vides
