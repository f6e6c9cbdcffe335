// SPDX-License-Identifier: MIT
// The speed curve with its ten handles: dragged up and down, swept with the right button.
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "math/whole.hpp"
#include "panels/quantities.hpp"
#include "panels/speed_joint.hpp"
#include "panels/speed_window.hpp"

namespace vides {
namespace {

using Doing = SpeedWindowMemory::Doing;
constexpr const char* kId = "speed/graph";
constexpr double kCoarseStep = 5.0;  // of a speed that is drawn with Shift

// From the curve's time and speed to pixels and back.
struct Plane {
  float left, right, top, bottom;

  ImVec2 at(double tau, double speed) const {
    const double height = (speed - kMinSpeed) / (kMaxSpeed - kMinSpeed);
    return {left + (right - left) * static_cast<float>(tau),
            bottom - (bottom - top) * static_cast<float>(height)};
  }
  double tau(float x) const { return static_cast<double>((x - left) / (right - left)); }
  double speed(float y) const {
    return kMinSpeed + (kMaxSpeed - kMinSpeed) * static_cast<double>((bottom - y) / (bottom - top));
  }
};

Plane planeOf(const Ui& ui, const Rect& rect) {
  return {speedColumn(rect, 1), speedColumn(rect, 10), rect.y + ui.px(10),
          rect.bottom() - ui.px(10)};
}

Command setSpeed(const SpeedValues& values) {
  Command command("set-speed");
  for (const double value : values) command.add(value);
  return command;
}

void end(Ui& ui, SpeedWindowMemory& memory, Actions& actions, Phase phase) {
  if (memory.previewed) {
    actions.during(setSpeed(phase == Phase::kCancel ? memory.start : memory.values), phase);
  }
  memory.doing = Doing::kNothing;
  memory.previewed = false;
  if (ui.memory().dragging == kId) ui.memory().dragging.clear();
}

void begin(Ui& ui, SpeedWindowMemory& memory, Doing doing, const SpeedValues& values) {
  memory.doing = doing;
  memory.start = memory.values = values;
  memory.previewed = false;
  // Escape is this drag's.
  ui.memory().dragging = kId;
}

void change(SpeedWindowMemory& memory, const SpeedValues& values, Actions& actions) {
  if (values == memory.values) return;
  memory.values = values;
  memory.previewed = true;
  actions.during(setSpeed(values), Phase::kPreview);
}

std::size_t nearestHandle(const Plane& plane, float x) {
  return static_cast<std::size_t>(wholeWithin(std::round(9.0 * plane.tau(x)), 0, kSpeedValues - 1));
}

void pointer(Ui& ui, const Plane& plane, const Ui::AreaState& state, const SpeedValues& values,
             SpeedWindowMemory& memory, Actions& actions) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (memory.doing == Doing::kNothing && state.pressed) {
    begin(ui, memory, Doing::kHandle, values);
    memory.handle = nearestHandle(plane, at.x);
    const ImVec2 handle = plane.at(static_cast<double>(memory.handle) / 9.0, values[memory.handle]);
    // Held at the handle it moves by what the pointer does; beside it, it comes to the pointer.
    const bool held = std::hypot(handle.x - at.x, handle.y - at.y) <= ui.px(10);
    memory.grip = held ? handle.y - at.y : 0.0f;
  } else if (memory.doing == Doing::kNothing && state.hovered && ImGui::IsMouseClicked(1)) {
    begin(ui, memory, Doing::kSweep, values);
    memory.lastTau = plane.tau(at.x);
    memory.lastSpeed = plane.speed(at.y);
  }
  if (memory.doing == Doing::kNothing) return;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    end(ui, memory, actions, Phase::kCancel);
    ImGui::ClearActiveID();
    return;
  }
  SpeedValues next = memory.values;
  const double step = ImGui::GetIO().KeyShift ? kCoarseStep : 1.0;
  if (memory.doing == Doing::kHandle) {
    const double speed = drawnSpeed(plane.speed(at.y + memory.grip), step);
    // A click on a handle changes nothing.
    const float moved = std::abs(plane.at(0.0, next[memory.handle]).y - (at.y + memory.grip));
    if (moved >= 0.5f) next[memory.handle] = speed;
  } else {
    const double tau = plane.tau(at.x), speed = plane.speed(at.y);
    const bool moved = tau != memory.lastTau || speed != memory.lastSpeed;
    if (moved || !memory.previewed) {
      next = swept(next, memory.lastTau, memory.lastSpeed, tau, speed, step);
    }
    memory.lastTau = tau;
    memory.lastSpeed = speed;
  }
  change(memory, next, actions);
  const bool down = memory.doing == Doing::kHandle ? state.held : ImGui::IsMouseDown(1);
  if (!down) end(ui, memory, actions, Phase::kCommit);
}

void dashed(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 ink, float width, float dash) {
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  const ImVec2 way((to.x - from.x) / length, (to.y - from.y) / length);
  for (float s = 0.0f; s < length; s += 2.0f * dash) {
    const float e = std::min(length, s + dash);
    list.AddLine({from.x + way.x * s, from.y + way.y * s}, {from.x + way.x * e, from.y + way.y * e},
                 ink, width);
  }
}

// Decimals for the speeds at all levels: three digits of the largest, as far as they fit.
int axisDecimals(const Ui& ui, double most, float room) {
  const double power = most > 0.0 ? std::floor(std::log10(most)) : 0.0;
  int decimals = 2 - static_cast<int>(std::clamp(power, -3.0, 2.0));
  while (decimals > 0 && ui.textWidth(grouped(ui, most, decimals), Weight::kSmall) > room) {
    --decimals;
  }
  return decimals;
}

void grid(Ui& ui, const Rect& rect, const Plane& plane, double per, const SpeedGraph* graph) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const double level : {1.0, 25.0, 50.0, 75.0, 100.0}) {
    const float y = std::round(plane.at(0.0, level).y) + 0.5f;
    list.AddLine({rect.x + ui.px(2), y}, {rect.right() - ui.px(2), y},
                 ui.colour(ColourRole::kBorder), 1.0f);
    const float width = ui.px(24);
    ui.text(
        {rect.x - width - ui.px(6), y - ui.px(8), width, ui.px(16)}, ui.number(level, 0),
        {.colour = ColourRole::kTextSecondary, .weight = Weight::kSmall, .align = Align::kRight});
    if (graph == nullptr || per * graph->perSpeed <= 0.0) continue;
    // The speed itself.
    const Rect box{rect.right() + ui.px(6), y - ui.px(8), ui.px(42), ui.px(16)};
    const double most = per * graph->perSpeed * kMaxSpeed;
    std::string words = grouped(ui, most * level / kMaxSpeed, axisDecimals(ui, most, box.width));
    if (ui.textWidth(words, Weight::kSmall) > box.width) {
      words = fmt::format("{:.1e}", most * level / kMaxSpeed);
    }
    ui.text(box, words,
            {.colour = ColourRole::kTextSecondary, .weight = Weight::kSmall, .mayShorten = true});
  }
  // What lies beside the section's own ten columns.
  ui.fill({rect.x, rect.y, speedColumn(rect, 1) - ui.px(22) - rect.x, rect.height},
          ColourRole::kPanel, 3.0f, 0.55);
  const float from = speedColumn(rect, 10) + ui.px(22);
  ui.fill({from, rect.y, rect.right() - from, rect.height}, ColourRole::kPanel, 3.0f, 0.55);
}

void square(Ui& ui, ImVec2 at, float half, ColourRole ink, ColourRole ground) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low(std::round(at.x) - half, std::round(at.y) - half);
  const ImVec2 high(std::round(at.x) + half, std::round(at.y) + half);
  list.AddRectFilled(low, high, ui.colour(ground));
  list.AddRect(low, high, ui.colour(ink), 0.0f, 0, std::max(1.0f, 1.4f * ui.scale()));
}

// The neighbour's end at the height of its speed, and the jump to it; or the stop.
void neighbour(Ui& ui, const Rect& rect, const Plane& plane, const Joint& joint, double own,
               bool before) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = before ? plane.left : plane.right;
  const double asFast = std::clamp(joint.asFast, kMinSpeed, kMaxSpeed);
  const ImVec2 at(speedColumn(rect, before ? 0 : 11), plane.at(0.0, asFast).y);
  const bool goesOn = joint.meeting == Joint::Meeting::kGoesOn;
  if (goesOn) {
    dashed(list, at, {x, at.y}, ui.colour(ColourRole::kTextSecondary), ui.scale(), ui.px(3));
  }
  drawJoint(ui, joint, {x, plane.bottom, plane.at(0.0, own).y, at.y});
  if (goesOn) {
    square(ui, at, std::round(3.0f * ui.scale()), ColourRole::kTextSecondary,
           ColourRole::kHandleFill);
  }
}

void curve(Ui& ui, const Plane& plane, const SpeedGraph& graph) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<ImVec2> used;
  for (const SpeedGraph::Point& p : graph.points) used.push_back(plane.at(p.tau, p.speed));
  const std::size_t chords = (graph.points.size() - 1) / graph.limited.size();
  // As it was drawn, where the limiter acts.
  for (std::size_t i = 0; i < graph.limited.size(); ++i) {
    if (!graph.limited[i]) continue;
    for (std::size_t k = i * chords; k < (i + 1) * chords; k += 2) {
      const auto& a = graph.points[k];
      const auto& b = graph.points[std::min(k + 1, graph.points.size() - 1)];
      list.AddLine(plane.at(a.tau, a.drawn), plane.at(b.tau, b.drawn),
                   ui.colour(ColourRole::kTextSecondary), 1.4f * ui.scale());
    }
  }
  list.AddPolyline(used.data(), static_cast<int>(used.size()), ui.colour(ColourRole::kAccent), 0,
                   2.4f * ui.scale());
}

}  // namespace

float speedColumn(const Rect& rect, int column) {
  return std::round(rect.x + rect.width * (static_cast<float>(column) + 0.5f) / 12.0f);
}

void speedCurveArea(Ui& ui, const Rect& rect, double per, const Session& session,
                    SpeedWindowMemory& memory, Actions& actions) {
  ui.fill(rect, ColourRole::kField, 3.0f);
  const Plane plane = planeOf(ui, rect);
  const SpeedGraph* graph = memory.graph ? &*memory.graph : nullptr;
  grid(ui, rect, plane, per, graph);
  const auto state = ui.area(kId, rect);
  if (graph == nullptr) {
    ui.text(rect, ui.words("speed.no-section"),
            {.colour = ColourRole::kTextDisabled, .align = Align::kCentre});
    return;
  }
  const SpeedValues& values = session.currentOrientation().speed;
  pointer(ui, plane, state, values, memory, actions);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect({rect.x, rect.y}, {rect.right(), rect.bottom()}, true);
  neighbour(ui, rect, plane, graph->start, values.front(), true);
  neighbour(ui, rect, plane, graph->end, values.back(), false);
  const Rect inner{plane.left, plane.top, plane.right - plane.left, plane.bottom - plane.top};
  jointNote(ui, "speed/jump_before", inner, graph->start, SectionEnd::kStart, values.front());
  jointNote(ui, "speed/jump_after", inner, graph->end, SectionEnd::kEnd, values.back());
  curve(ui, plane, *graph);
  const std::size_t near = nearestHandle(plane, ImGui::GetIO().MousePos.x);
  for (std::size_t j = 0; j < values.size(); ++j) {
    const bool lively =
        memory.doing == Doing::kHandle ? j == memory.handle : state.hovered && j == near;
    square(ui, plane.at(static_cast<double>(j) / 9.0, values[j]),
           std::round((lively ? 5.5f : 4.0f) * ui.scale()), ColourRole::kText,
           ColourRole::kHandleFill);
  }
  list.PopClipRect();
  idleNote(ui, {rect.x, rect.y + ui.px(4), rect.width, ui.px(20)}, graph->idleTurns);
  if (state.hovered || memory.doing == Doing::kHandle) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  }
}

}  // namespace vides
