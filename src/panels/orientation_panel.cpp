// SPDX-License-Identifier: MIT
// Orientation: those of the current key; aim and roll of the current one.
#include <fmt/format.h>

#include "panels/left_panels.hpp"

namespace vides {
namespace {

constexpr float kRow = 22.0f;

void aimRow(Ui& ui, const Rect& row, const Session& session, Actions& actions) {
  const ThreeColumns columns = threeColumns(ui, row);
  ui.text(columns.label, ui.words("orientation/aim"), {.colour = ColourRole::kTextSecondary});
  const Orientation& orientation = session.currentOrientation();
  const bool scene = session.display().units == Units::kScene;
  const bool relative = orientation.aimMode == AimMode::kRelative;
  const Space& space = session.flight().space;
  // A relative aim is an offset: units scale it, the centre doesn't move it.
  const auto toUnits = [&](const Vec3& v) {
    return !scene ? v : relative ? v * space.halfSize : space.toWorld(v);
  };
  const auto toCube = [&](const Vec3& v) {
    return !scene ? v : relative ? v / space.halfSize : space.toCube(v);
  };
  const Vec3 shownAt = toUnits(orientation.aim);
  constexpr const char* kIds[] = {"orientation/aim_x", "orientation/aim_y", "orientation/aim_z"};
  for (int axis = 0; axis < 3; ++axis) {
    const Rect& box = columns.values[axis];
    const auto typed = ui.field(
        kIds[axis], box, shownAt[axis],
        {.decimals = fittingDecimals(ui, box, shownAt[axis], 3), .weight = Weight::kSemibold});
    actions.typed(typed, [&](double value) {
      Vec3 aim = shownAt;
      aim[axis] = value;
      // The command takes the point, whatever the mode.
      const Vec3 cube = toCube(aim);
      return Command("set-aim", relative ? session.currentKey().position + cube : cube);
    });
  }
}

}  // namespace

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
                                 .weight = Weight::kSemibold});
    actions.typed(typed, [&](double value) { return Command("set-roll", value); });
    rows.gap(4);
    aimRow(ui, rows.row(kRow), session, actions);
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
