// SPDX-License-Identifier: MIT
// What windows with many settings are made of: rows with labels, choices, texts, numbers.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "panels/actions.hpp"
#include "panels/ui.hpp"

namespace vides {

class Form {
 public:
  static constexpr float kRow = 24.0f;

  // Labels take `labelWidth` (at content scale 1) of the rows' width.
  Form(Ui& ui, const Rect& room, float labelWidth)
      : ui_(&ui), rows_(ui, room.x, room.y, room.width), label_(labelWidth) {}

  // The next row: its label is drawn, the rest is returned.
  Rect row(std::string_view labelKey);
  void gap(float heightAtScale1) { rows_.gap(heightAtScale1); }
  // A line that explains something, under what stands in the rows' right part.
  void note(std::string_view words);
  float y() const { return rows_.y(); }
  Ui& ui() { return *ui_; }

 private:
  Ui* ui_;
  Stack rows_;
  float label_;
};

// One of several, side by side: identifiers ID_VALUE, labels by them. What was chosen anew.
std::optional<std::string> choice(Ui& ui, std::string_view id, const Rect& rect,
                                  std::span<const std::string_view> values,
                                  std::string_view current);

// As many decimals as a number needs for six significant digits, at least `least`.
int neededDecimals(double value, int least = 0);

}  // namespace vides
