// SPDX-License-Identifier: MIT
// What the left column's panels have in common.
#include <algorithm>
#include <cmath>
#include <functional>

#include "panels/left_panels.hpp"
#include "panels/quantities.hpp"
#include "panels/windows.hpp"

namespace vides {

void commandButton(Ui& ui, std::string_view id, const Rect& rect, std::string_view command,
                   const Session& session, Actions& actions, ButtonStyle style) {
  style.command = command;
  style.enabled = style.enabled && canRun(session, command);
  if (!ui.button(id, rect, style)) return;
  if (auto parsed = parseCommand(command)) actions.run(std::move(*parsed));
}

std::string progressBar(Ui& ui, const Rect& track, double share) {
  const double done = std::clamp(share, 0.0, 1.0);
  const float radius = 0.5f * track.height / ui.scale();
  ui.fill(track, ColourRole::kSliderTrack, radius);
  ui.fill({track.x, track.y, std::round(track.width * static_cast<float>(done)), track.height},
          ColourRole::kSlider, radius);
  return ui.tell(Text("frames.progress", {std::floor(100.0 * done)}));
}

ThreeColumns threeColumns(const Ui& ui, const Rect& row) {
  ThreeColumns result;
  const float gap = ui.px(4);
  // In a narrow column the labels keep what they need.
  const float label = std::max(std::round(row.width * 0.262f), std::min(ui.px(68), row.width / 3));
  result.label = {row.x, row.y, label, row.height};
  const Rect rest{row.x + label + gap, row.y, row.width - label - gap, row.height};
  const std::vector<Rect> parts = split(ui, rest, 3);
  std::copy(parts.begin(), parts.end(), result.values);
  return result;
}

namespace {

constexpr float kNumberRow = 22.0f, kLabelRow = 18.0f;

bool fitsBeside(const Ui& ui, float width) {
  const ThreeColumns beside = threeColumns(ui, {0.0f, 0.0f, width, ui.tall(kNumberRow)});
  const float needed =
      ui.textWidth(ui.number(-1.0, 3), Weight::kSemibold) + 2 * Ui::kTightInset * ui.scale();
  return beside.values[0].width >= needed;
}

}  // namespace

float threeNumbersHeight(const Ui& ui, float width) {
  return ui.tall(kNumberRow) + (fitsBeside(ui, width) ? 0.0f : ui.tall(kLabelRow));
}

float rowWidth(const Ui& ui, float columnWidth) { return columnWidth - 2 * ui.px(8); }

ThreeColumns threeNumbers(const Ui& ui, Stack& rows) {
  if (fitsBeside(ui, rows.width())) return threeColumns(ui, rows.row(kNumberRow));
  ThreeColumns above;
  above.label = rows.row(kLabelRow);
  const std::vector<Rect> parts = split(ui, rows.row(kNumberRow), 3);
  std::copy(parts.begin(), parts.end(), above.values);
  return above;
}

namespace {

// As many decimals as fit, but two at least: a field that has no room even for these goes on alone.
int fittingDecimals(const Ui& ui, const Rect& box, double value, int most) {
  int decimals = most;
  const float room = box.width - 2 * Ui::kTightInset * ui.scale();
  while (decimals > 2 && ui.textWidth(ui.number(value, decimals), Weight::kSemibold) > room) {
    --decimals;
  }
  return decimals;
}

// Three numbers of which each is set alone, by `command AXIS VALUE UNITS`.
struct Coordinates {
  std::string prefix;
  const char* command;
  KeyValue first;
};
void coordinateFields(Ui& ui, const Coordinates& coordinates, const Rect (&boxes)[3],
                      const Session& session, const SetCoordinate& set) {
  const Units units = session.display().units;
  const auto which = [&](int axis) {
    return static_cast<KeyValue>(static_cast<int>(coordinates.first) + axis);
  };
  // A relative aim is an offset: the centre doesn't move it.
  const bool offset = coordinates.first == KeyValue::kAimX &&
                      session.currentOrientation().aimMode == AimMode::kRelative;
  const Vec3 base = offset ? Vec3(0.0) : farCentre(session).value_or(Vec3(0.0));
  double shownAt[3];
  // All three with as many decimals if they can, and as many when one of them changes its sign.
  int decimals = 3;
  for (int axis = 0; axis < 3; ++axis) {
    shownAt[axis] = valueOf(session.state(), session.current().key, which(axis), units);
    decimals = std::min(decimals, fittingDecimals(ui, boxes[axis],
                                                  -std::abs(shownAt[axis] - base[axis]), decimals));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const auto typed = ui.field(coordinates.prefix + name, boxes[axis], shownAt[axis],
                                {.decimals = decimals,
                                 .weight = Weight::kSemibold,
                                 .differs = differs(ui, session, which(axis)),
                                 .base = base[axis]});
    if (!typed.value) continue;
    Command command(coordinates.command, name, typed.argument());
    if (units == Units::kScene) command.add("scene");
    set(typed, std::move(command));
  }
}

}  // namespace

bool differs(Ui& ui, const Session& session, KeyValue which) {
  return ui.memory().differing.differs(session.state(), which);
}

void positionFields(Ui& ui, std::string_view area, const Rect (&boxes)[3], const Session& session,
                    const SetCoordinate& set) {
  coordinateFields(ui, {std::string(area) + '/', "set-coordinate", KeyValue::kX}, boxes, session,
                   set);
}

void aimFields(Ui& ui, std::string_view area, const Rect (&boxes)[3], const Session& session,
               const SetCoordinate& set) {
  coordinateFields(ui, {std::string(area) + "/aim_", "set-aim-coordinate", KeyValue::kAimX}, boxes,
                   session, set);
}

}  // namespace vides
