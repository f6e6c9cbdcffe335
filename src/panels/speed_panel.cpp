// SPDX-License-Identifier: MIT
// Speed: the current section's curve in small, its duration and the hold before it.
#include <algorithm>
#include <array>
#include <cmath>

#include "edit/film_length.hpp"
#include "panels/left_panels.hpp"
#include "panels/quantities.hpp"
#include "panels/speed_joint.hpp"
#include "panels/windows.hpp"

namespace vides {
namespace {

constexpr float kRow = 22.0f;
constexpr float kLeastCurve = 30.0f, kUsualCurve = 60.0f, kMostCurve = 140.0f;

// What the speed does at one end of the curve, which `inner` holds.
template <class Place>
void drawEnd(Ui& ui, const Rect& inner, const Session& session, SectionEnd end, Place place) {
  const bool start = end == SectionEnd::kStart;
  const Joint joint = jointAt(session.evaluation(), session.current(), end);
  const SpeedValues& values = session.currentOrientation().speed;
  const double own = start ? values.front() : values.back();
  const double tau = start ? 0.0 : 1.0;
  const double asFast = std::clamp(joint.asFast, kMinSpeed, kMaxSpeed);
  drawJoint(ui, joint,
            {place(tau, own).x, inner.bottom(), place(tau, own).y, place(tau, asFast).y});
  jointNote(ui, start ? "speed/curve_start" : "speed/curve_end", inner, joint, end, own);
}

void smallCurve(Ui& ui, const Rect& rect, const Session& session, bool owns, Actions& actions) {
  ui.fill(rect, ColourRole::kField, 3.0f);
  const auto state = ui.area("speed/curve", rect);
  const Rect inner{rect.x + ui.px(8), rect.y + ui.px(6), rect.width - ui.px(16),
                   rect.height - ui.px(12)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto place = [&](double tau, double speed) {
    const double height = (speed - kMinSpeed) / (kMaxSpeed - kMinSpeed);
    return ImVec2(inner.x + inner.width * static_cast<float>(tau),
                  inner.bottom() - inner.height * static_cast<float>(height));
  };
  // 25, 50 (the base speed) and 75.
  for (const double level : {25.0, 50.0, 75.0}) {
    const float y = std::round(place(0, level).y) + 0.5f;
    list.AddLine({rect.x, y}, {rect.right(), y}, ui.colour(ColourRole::kBorder), 1.0f);
  }
  const SpeedCurve curve = owns ? session.evaluation().speedCurve(session.current())
                                : SpeedCurve(session.currentOrientation().speed);
  const ImU32 ink = ui.colour(owns ? ColourRole::kAccent : ColourRole::kTextDisabled);
  std::array<ImVec2, 64> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double tau = static_cast<double>(i) / static_cast<double>(points.size() - 1);
    points[i] = place(tau, curve.at(tau));
  }
  list.AddPolyline(points.data(), static_cast<int>(points.size()), ink, 0, 2.0f * ui.scale());
  if (owns) {
    drawEnd(ui, inner, session, SectionEnd::kStart, place);
    drawEnd(ui, inner, session, SectionEnd::kEnd, place);
  }
  const float half = std::round(2.5f * ui.scale());
  for (int j = 0; j < kSpeedValues; ++j) {
    const ImVec2 at = place(j / 9.0, curve.values()[static_cast<std::size_t>(j)]);
    const ImVec2 low(std::round(at.x) - half, std::round(at.y) - half);
    const ImVec2 high(std::round(at.x) + half, std::round(at.y) + half);
    list.AddRectFilled(low, high, ui.colour(ColourRole::kHandleFill));
    list.AddRect(low, high, ui.colour(owns ? ColourRole::kText : ColourRole::kTextDisabled), 0.0f,
                 0, std::max(1.0f, ui.scale()));
  }
  if (owns) {
    const auto turns = session.evaluation().idleTurns(session.current());
    idleNote(ui, {rect.x, rect.y + ui.px(2), rect.width, ui.px(16)}, turns);
  }
  if (state.hovered && owns && canRun(session, "show-window speed"))
    ui.outline(rect, ColourRole::kControlHovered, 3.0f);
  if (state.released && owns && canRun(session, "show-window speed")) {
    actions.run(Command("show-window", "speed"));
  }
}

// Label, number that can be typed, and a note behind it.
Ui::Typed numberRow(Ui& ui, const Rect& row, std::string_view id, double value, bool enabled,
                    const std::string& note) {
  const ThreeColumns columns = threeColumns(ui, row);
  const Rect label{columns.label.x, columns.label.y, columns.values[0].right() - columns.label.x,
                   row.height};
  ui.text(label, ui.words(id), {.colour = ColourRole::kTextSecondary});
  const auto typed =
      ui.field(id, columns.values[1], value,
               {.decimals = 2, .suffix = " s", .enabled = enabled, .weight = Weight::kSemibold});
  ui.text(columns.values[2], note,
          {.colour = ColourRole::kTextSecondary, .align = Align::kRight, .mayShorten = true});
  return typed;
}

// What stands below the curve: duration, hold, buttons.
float belowCurve(const Ui& ui) { return 3 * (ui.tall(kRow) + ui.tall(4)); }

}  // namespace

float speedPanelHeight(const Ui& ui) {
  return panelHeight(ui) + ui.px(kLeastCurve) + belowCurve(ui);
}

void speedPanel(Ui& ui, Stack& column, float bottom, float spare, const Session& session,
                Actions& actions) {
  panel(ui, column, "panel/speed", [&](Stack& rows) {
    const OrientationPlace& place = session.current();
    const Orientation& orientation = session.currentOrientation();
    // At an open flight's last orientation no section begins.
    const bool owns = session.evaluation().next(place) != place;
    const float below = belowCurve(ui) + panelFoot(ui);
    float height = (bottom - below - rows.y()) / ui.scale();
    if (height < kUsualCurve) height = std::min(kUsualCurve, height + spare / ui.scale());
    // In a column that must be scrolled anyway nothing is won by a flat one.
    if (height < kLeastCurve) height = kUsualCurve;
    smallCurve(ui, rows.room(ui.px(std::floor(std::min(height, kMostCurve)))), session, owns,
               actions);
    rows.gap(4);
    const auto section = owns ? session.evaluation().sectionFrom(place) : std::nullopt;
    const std::int64_t frames = section ? section->frames : 0;
    const double fps = session.flight().frameRate;
    auto typed = numberRow(ui, rows.row(kRow), "speed/duration",
                           orientation.duration.value_or(toldSeconds(frames, fps)), owns,
                           framesText(ui, frames));
    actions.typed(typed, [&](double seconds) { return Command("set-duration", seconds); });
    rows.gap(4);
    const auto hold = session.evaluation().holdBefore(place);
    typed = numberRow(ui, rows.row(kRow), "speed/hold", orientation.hold, true,
                      framesText(ui, hold ? hold->frames : 0));
    actions.typed(typed, [&](double seconds) { return Command("set-hold", seconds); });
    rows.gap(4);
    const auto row = split(ui, rows.row(kRow), 2);
    commandButton(ui, "speed/rate", row[0], "clear-duration", session, actions,
                  {.enabled = orientation.duration.has_value()});
    commandButton(ui, "speed/edit", row[1], "show-window speed", session, actions,
                  {.enabled = owns});
  });
}

}  // namespace vides
