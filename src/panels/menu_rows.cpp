// SPDX-License-Identifier: MIT
// What menus are made of: names in the bar, rows.
#include <algorithm>
#include <cmath>

#include "panels/ui.hpp"

namespace vides {

bool Ui::menuName(std::string_view id, const Rect& rect, std::string_view label,
                  const MenuName& state) {
  const Press pressed = press(id, rect, WidgetKind::kMenu, state.enabled);
  registerWidget(id, label, WidgetKind::kMenu, rect, state.enabled, state.open ? "open" : "");
  if (state.open || state.marked) {
    fill(rect, ColourRole::kControlHovered);
  } else if (pressed.hovered) {
    fill(rect, ColourRole::kControl);
  }
  text(rect, label, {.align = Align::kCentre});
  return pressed.held && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

bool Ui::menuRow(std::string_view id, const Rect& rect, std::string_view label,
                 const MenuRow& row) {
  const Press state = press(id, rect, WidgetKind::kMenuItem, row.enabled);
  if (row.opens) {
    registerWidget(id, label, WidgetKind::kMenu, rect, row.enabled, row.open ? "open" : "");
  } else {
    registerWidget(id, label, WidgetKind::kMenuItem, rect, row.enabled, row.on ? "on" : "",
                   tip(id));
  }
  if (row.marked || row.open) fill(rect, ColourRole::kControlHovered, 3.0f);
  const ColourRole words = row.enabled ? ColourRole::kText : ColourRole::kTextDisabled;
  const float sign = px(16);  // at the right end, for the tick
  const float keys = textWidth(row.keys);
  const Rect room{rect.x + row.inset, rect.y, rect.width - 2 * row.inset - sign, rect.height};
  text({room.x, room.y, room.width - keys - (keys > 0.0f ? px(8) : 0.0f), room.height}, label,
       {.colour = words, .mayShorten = true});
  text({room.right() - keys, room.y, keys, room.height}, row.keys,
       {.colour = row.enabled ? ColourRole::kTextSecondary : ColourRole::kTextDisabled});
  const Rect end{room.right(), rect.y, sign, rect.height};
  if (row.opens) icon(Icon::kChevronRight, end, words);
  if (row.on) {
    const float side = px(11);
    const float x = std::round(end.right() - side), y = std::round(end.centreY() - side / 2);
    const ImVec2 tick[] = {{x + side * 0.05f, y + side * 0.52f},
                           {x + side * 0.37f, y + side * 0.85f},
                           {x + side * 0.95f, y + side * 0.15f}};
    ImGui::GetWindowDrawList()->AddPolyline(tick, 3, colour(words), 0, 1.6f * scale());
  }
  if (!row.opens) tooltip(id, rect, state, {}, true);
  return state.pressed;
}

}  // namespace vides
