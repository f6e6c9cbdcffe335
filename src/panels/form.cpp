// SPDX-License-Identifier: MIT
// Windows with many settings.
#include "panels/form.hpp"

#include <algorithm>
#include <cmath>

namespace vides {

Rect Form::row(std::string_view labelKey) {
  const Rect all = rows_.row(kRow);
  rows_.gap(4);
  const float width = ui_->px(label_);
  ui_->text({all.x, all.y, width - ui_->px(8), all.height}, ui_->words(labelKey),
            {.colour = ColourRole::kTextSecondary});
  return {all.x + width, all.y, all.width - width, all.height};
}

void Form::note(std::string_view words) {
  const Rect all = rows_.row(20);
  rows_.gap(4);
  const float width = ui_->px(label_);
  ui_->text({all.x + width, all.y, all.width - width, all.height}, words,
            {.colour = ColourRole::kTextSecondary, .mayShorten = true});
}

std::optional<std::string> choice(Ui& ui, std::string_view id, const Rect& rect,
                                  std::span<const std::string_view> values,
                                  std::string_view current) {
  std::optional<std::string> chosen;
  ui.choice(id, rect, current);
  const auto boxes = split(ui, rect, static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string button = std::string(id) + "_" + std::string(values[i]);
    const bool on = values[i] == current;
    if (ui.button(button, boxes[i], {.on = on, .toggle = true}) && !on) chosen = values[i];
  }
  return chosen;
}

int neededDecimals(double value, int least) {
  constexpr int kMost = 9;
  for (int decimals = least; decimals < kMost; ++decimals) {
    const double unit = std::pow(10.0, decimals);
    if (std::abs(std::round(value * unit) / unit - value) <= 1e-6 * std::abs(value)) {
      return decimals;
    }
  }
  return kMost;
}

}  // namespace vides
