// SPDX-License-Identifier: MIT
// What the left column's panels have in common.
#include <algorithm>
#include <cmath>

#include "panels/left_panels.hpp"
#include "panels/windows.hpp"

namespace vides {

void commandButton(Ui& ui, std::string_view id, const Rect& rect, std::string_view command,
                   const Session& session, Actions& actions, ButtonStyle style) {
  style.enabled = style.enabled && canRun(session, command);
  if (!ui.button(id, rect, style)) return;
  if (auto parsed = parseCommand(command)) actions.run(std::move(*parsed));
}

ThreeColumns threeColumns(const Ui& ui, const Rect& row) {
  ThreeColumns result;
  const float gap = ui.px(4);
  const float label = std::round(row.width * 0.262f);
  result.label = {row.x, row.y, label, row.height};
  const Rect rest{row.x + label + gap, row.y, row.width - label - gap, row.height};
  const std::vector<Rect> parts = split(ui, rest, 3);
  std::copy(parts.begin(), parts.end(), result.values);
  return result;
}

int fittingDecimals(const Ui& ui, const Rect& box, double value, int most) {
  for (int decimals = most; decimals > 0; --decimals) {
    if (ui.textWidth(ui.number(value, decimals), Weight::kSemibold) <= box.width - ui.px(8))
      return decimals;
  }
  return 0;
}

}  // namespace vides
