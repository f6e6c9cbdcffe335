// SPDX-License-Identifier: MIT
// The shape window.
#include "panels/shape_window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edit/shape_picture.hpp"
#include "panels/left_panels.hpp"

namespace vides {
namespace {

constexpr float kWidth = 288.0f;
constexpr float kHeight = 392.0f;
constexpr float kRow = 22.0f;

const std::array<std::size_t, kPresets>& usersOf(const Session& session,
                                                 ShapeWindowMemory& memory) {
  if (!memory.counted || !memory.counted->sameAs(session.evaluation())) {
    memory.counted = session.evaluation();
    memory.users.fill(0);
    session.flight().keys.forEach([&](const Key& key) {
      if (key.shape.preset != KeyShape::kOwn) {
        ++memory.users[static_cast<std::size_t>(key.shape.preset)];
      }
    });
  }
  return memory.users;
}

void drawPicture(Ui& ui, const Rect& box, const Shape& shape, bool strong) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ShapePicture picture = shapePicture(shape);
  const auto at = [&](const Vec2& p) {
    return ImVec2(box.x + box.width * static_cast<float>(p.x),
                  box.y + box.height * static_cast<float>(p.y));
  };
  // What full tension would make of it.
  const ImVec2 corners[] = {at(picture.line.front()), at(picture.key), at(picture.line.back())};
  list.AddPolyline(corners, 3, ui.colour(ColourRole::kText, 0.22), 0, ui.scale());
  std::vector<ImVec2> points;
  for (const Vec2& p : picture.line) points.push_back(at(p));
  const ColourRole ink = strong ? ColourRole::kText : ColourRole::kTextSecondary;
  list.AddPolyline(points.data(), static_cast<int>(points.size()), ui.colour(ink), 0,
                   1.6f * ui.scale());
  list.AddCircleFilled(at(picture.key), 2.4f * ui.scale(), ui.colour(ink));
}

// Its number beside what it does.
void presetButton(Ui& ui, const Rect& box, const Session& session, int preset, std::size_t users,
                  Actions& actions) {
  const std::string number = std::to_string(preset);
  const std::string id = "shape/preset_" + number;
  const bool chosen = session.chosenPreset() == preset;
  const Shape& own = session.flight().presets[static_cast<std::size_t>(preset)];
  // Tried, it shows what it would become.
  const Shape& shape = chosen && session.triesPreset() ? session.currentKey().shape.own : own;
  const std::string tip =
      fmt::format("{} {} \u00b7 t {}  c {}  b {} \u00b7 {}", ui.words("shape/preset"), number,
                  ui.number(shape.tension, 2), ui.number(shape.continuity, 2),
                  ui.number(shape.bias, 2), ui.tell(Text("shape.users", {users})));
  if (ui.button(id, box, number,
                {.on = chosen, .toggle = true, .align = Align::kLeft, .tooltip = tip})) {
    actions.run(Command("shape-choose", number));
  }
  drawPicture(ui, {box.x + ui.px(18), box.y + ui.px(5), box.width - ui.px(22), ui.px(30)}, shape,
              chosen);
}

void presets(Ui& ui, Stack& rows, const Session& session, ShapeWindowMemory& memory,
             Actions& actions) {
  const auto& users = usersOf(session, memory);
  for (int line = 0; line < 2; ++line) {
    const auto boxes = split(ui, rows.row(40), 5);
    for (int i = 0; i < 5; ++i) {
      const int preset = 5 * line + i;
      presetButton(ui, boxes[static_cast<std::size_t>(i)], session, preset,
                   users[static_cast<std::size_t>(preset)], actions);
    }
    rows.gap(4);
  }
  const bool own = session.chosenPreset() == KeyShape::kOwn;
  if (ui.button("shape/own", rows.row(24), {.on = own, .toggle = true})) {
    actions.run(Command("shape-choose", "own"));
  }
}

// Label, slider, number.
void parameterRow(Ui& ui, const Rect& row, const char* name, double value, bool differs,
                  Actions& actions) {
  const std::string id = "shape/" + std::string(name);
  const ThreeColumns columns = threeColumns(ui, row);
  ui.text(columns.label, ui.words(id), {.colour = ColourRole::kTextSecondary});
  const Rect& number = columns.values[2];
  const Rect track{columns.values[0].x, row.y, number.x - ui.px(8) - columns.values[0].x,
                   row.height};
  // 0 is in the middle.
  const float middle = std::round(track.centreX()) - ui.px(1) / 2;
  ui.fill({middle, track.centreY() - ui.px(6), ui.px(1), ui.px(12)}, ColourRole::kSliderTrack);
  const auto change = ui.slider(
      id, track, value,
      {.least = -1.0, .most = 1.0, .decimals = 2, .snap = 0.1, .from = 0.0, .differs = differs});
  // Dragged, it goes in hundredths, and so also catches at 0.
  if (change) {
    const double hundredths = std::round(change->value * 100.0) / 100.0;
    const bool dragged = change->phase == Phase::kPreview;
    actions.run(Command("shape-set", name, dragged ? Argument(hundredths) : change->argument()));
  }
  const auto typed = ui.field(id + "_value", number, value,
                              {.decimals = 2, .weight = Weight::kSemibold, .differs = differs});
  if (typed.value) actions.number(typed, Command("shape-set", name, typed.argument()));
}

// What Show would do, or how many keys follow the preset.
void note(Ui& ui, const Rect& row, const Session& session, ShapeWindowMemory& memory) {
  const int chosen = session.chosenPreset();
  if (chosen == KeyShape::kOwn) return;
  const std::size_t others = usersOf(session, memory)[static_cast<std::size_t>(chosen)];
  const bool tries = session.triesPreset();
  // The key that tries it isn't counted: it has the shape as its own meanwhile.
  const std::size_t users = others + (tries ? 1 : 0);
  const Text text = tries ? Text("shape.tried", {users}) : Text("shape.note", {users, chosen});
  const std::string words = ui.tell(text);
  ui.text(row, words, {.colour = ColourRole::kTextSecondary, .weight = Weight::kSmall});
  ui.shows("shape/note", row, words);
}

void numbers(Ui& ui, Stack& rows, const Session& session, Actions& actions) {
  const auto preview = [&](const Ui::Typed&, Command command) {
    actions.inWindow(std::move(command));
  };
  ThreeColumns columns = threeColumns(ui, rows.row(kRow));
  ui.text(columns.label, ui.words("position/place"), {.colour = ColourRole::kTextSecondary});
  positionFields(ui, "shape", columns.values, session, preview);
  rows.gap(4);
  columns = threeColumns(ui, rows.row(kRow));
  ui.text(columns.label, ui.words("orientation/aim"), {.colour = ColourRole::kTextSecondary});
  aimFields(ui, "shape", columns.values, session, preview);
  rows.gap(4);
  columns = threeColumns(ui, rows.row(kRow));
  ui.text(columns.label, ui.words("orientation/roll"), {.colour = ColourRole::kTextSecondary});
  const auto typed = ui.field("shape/roll", columns.values[0], session.currentOrientation().roll,
                              {.decimals = 1,
                               .suffix = "\u00b0",
                               .weight = Weight::kSemibold,
                               .differs = differs(ui, session, KeyValue::kRoll)});
  if (typed.value) preview(typed, Command("set-roll", typed.argument()));
}

}  // namespace

void shapeWindow(Ui& ui, const Session& session, ShapeWindowMemory& memory, Actions& actions) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const FloatingFrame frame{
      "shape", kWidth, kHeight,
      fmt::format("{} \u00b7 {} {}", ui.words("window/shape"), ui.words("position/key"),
                  session.current().key + 1),
      // Under the camera's picture, where it hides neither the curve nor what the camera sees.
      screen.x - ui.px(kWidth), ui.px(212)};
  const bool stays = floatingFrame(
      ui, frame, memory.place,
      [&](const Rect& room) {
        Stack rows(ui, room.x, room.y, room.width);
        presets(ui, rows, session, memory, actions);
        rows.gap(8);
        const Shape& shape = shapeOf(session.flight(), session.currentKey());
        parameterRow(ui, rows.row(kRow), "tension", shape.tension,
                     differs(ui, session, KeyValue::kTension), actions);
        rows.gap(4);
        parameterRow(ui, rows.row(kRow), "continuity", shape.continuity,
                     differs(ui, session, KeyValue::kContinuity), actions);
        rows.gap(4);
        parameterRow(ui, rows.row(kRow), "bias", shape.bias, differs(ui, session, KeyValue::kBias),
                     actions);
        rows.gap(4);
        note(ui, rows.row(16), session, memory);
        rows.gap(8);
        numbers(ui, rows, session, actions);
      },
      [&](const Rect& row) {
        const auto buttons = split(ui, row, 3, 8.0f);
        if (ui.button("shape/show", buttons[0])) actions.run(Command("shape-show"));
        if (ui.button("shape/cancel", buttons[1])) actions.run(Command("shape-cancel"));
        if (ui.button("shape/ok", buttons[2])) actions.run(Command("shape-ok"));
      });
  if (!stays) actions.run(Command("shape-cancel"));
}

}  // namespace vides
