// SPDX-License-Identifier: MIT
// Orientation: those of the current key; aim and roll of the current one.
#include <fmt/format.h>

#include "panels/left_panels.hpp"

namespace vides {
namespace {

constexpr float kRow = 22.0f;

void aimRow(Ui& ui, Stack& rows, const Session& session, Actions& actions) {
  const ThreeColumns columns = threeNumbers(ui, rows);
  ui.text(columns.label, ui.words("orientation/aim"), {.colour = ColourRole::kTextSecondary});
  aimFields(ui, "orientation", columns.values, session,
            [&](const auto& typed, Command command) { actions.number(typed, std::move(command)); });
}

}  // namespace

float orientationPanelHeight(const Ui& ui, float width) {
  return panelHeight(ui) + 3 * (ui.tall(kRow) + ui.tall(4)) +
         threeNumbersHeight(ui, rowWidth(ui, width));
}

void orientationPanel(Ui& ui, Stack& column, const Session& session, Actions& actions) {
  panel(ui, column, "panel/orientation", [&](Stack& rows) {
    auto row = split(ui, rows.row(kRow), 4);
    commandButton(ui, "orientation/insert", row[0], "insert-orientation", session, actions);
    commandButton(ui, "orientation/delete", row[1], "delete-orientation", session, actions);
    commandButton(ui, "orientation/previous", row[2], "previous-orientation", session, actions);
    commandButton(ui, "orientation/next", row[3], "next-orientation", session, actions);
    rows.gap(4);
    const ThreeColumns columns = threeColumns(ui, rows.row(kRow));
    const Rect left{columns.label.x, columns.label.y, columns.values[0].right() - columns.label.x,
                    columns.label.height};
    ui.text(
        left,
        fmt::format("{} {} {} {}", ui.words("orientation/short"), session.current().orientation + 1,
                    ui.words("of"), session.currentKey().orientations.size()),
        {.colour = ColourRole::kTextSecondary});
    const Rect roll{columns.values[1].x, columns.values[1].y,
                    columns.values[2].right() - columns.values[1].x, columns.values[1].height};
    const auto typed = ui.field("orientation/roll", roll, session.currentOrientation().roll,
                                {.decimals = 1,
                                 .prefix = ui.words("orientation/roll"),
                                 .suffix = "\u00b0",
                                 .weight = Weight::kSemibold,
                                 .differs = differs(ui, session, KeyValue::kRoll)});
    if (typed.value) actions.number(typed, Command("set-roll", typed.argument()));
    rows.gap(4);
    aimRow(ui, rows, session, actions);
    rows.gap(4);
    row = split(ui, rows.row(kRow), 2);
    const bool absolute = session.currentOrientation().aimMode == AimMode::kAbsolute;
    commandButton(ui, "orientation/absolute", row[0], "set-aim-mode absolute", session, actions,
                  {.on = absolute, .toggle = true});
    commandButton(ui, "orientation/relative", row[1], "set-aim-mode relative", session, actions,
                  {.on = !absolute, .toggle = true});
  });
}

}  // namespace vides
