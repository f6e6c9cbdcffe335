// SPDX-License-Identifier: MIT
// The large speed window.
#include "panels/speed_window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "edit/ease.hpp"
#include "edit/film_length.hpp"
#include "panels/left_panels.hpp"
#include "panels/quantities.hpp"
#include "panels/speed_joint.hpp"

namespace vides {
namespace {

constexpr float kRow = 22.0f;
constexpr float kAxis = 30.0f;   // left of the curve: 1 to 100
constexpr float kThere = 48.0f;  // right of it: the speeds themselves

// At content scale 1. In a low window a flat one leaves the flight's curve to be seen; it stands
// over the timeline. In a narrow window everything stands below the speed curve, and is scrolled.
struct Measures {
  float width, height;
  float column;       // of a handle
  float graph;        // its height
  bool there = true;  // with the speeds themselves beside it
};
constexpr Measures kLarge{820.0f, 436.0f, 44.0f, 200.0f};
constexpr Measures kFlat{944.0f, 264.0f, 40.0f, 158.0f};
constexpr float kLowScreen = 1000.0f;
constexpr float kViewportShare = 0.5f;
constexpr float kRamps = 160.0f;  // width of the eases in a flat window
constexpr float kLeastNarrow = 472.0f;
constexpr float kNarrowGraph = 128.0f;
constexpr float kNarrowLower = 92.0f;  // height of the graphs below all

Measures narrow(float width) {
  // Heading, curve with numbers and buttons, eases, small graphs.
  const float height = 40.0f + kNarrowGraph + 54.0f + 160.0f + kNarrowLower + 12.0f;
  return {width, height, (width - 24.0f - kAxis) / 12.0f, kNarrowGraph, false};
}
constexpr const char* kValues[kSpeedValues] = {"speed/v0", "speed/v1", "speed/v2", "speed/v3",
                                               "speed/v4", "speed/v5", "speed/v6", "speed/v7",
                                               "speed/v8", "speed/v9"};

void follow(const Session& session, SpeedWindowMemory& memory) {
  const bool same = memory.evaluation && memory.evaluation->sameAs(session.evaluation()) &&
                    memory.of == session.current();
  if (same) return;
  memory.evaluation = session.evaluation();
  memory.of = session.current();
  memory.graph = speedGraph(session.evaluation(), session.current());
}

// What a section's progress is told in: of lengths the unit that is chosen for positions.
struct Measure {
  double per = 1.0;        // of these in one of the graph's
  std::string unit = {};   // "units", "°"
  std::string whole = {};  // its name where it has a longer one
};

Measure measureOf(const Ui& ui, const Session& session, const SpeedGraph& graph) {
  switch (graph.unit) {
    case SectionUnit::kScene: {
      const LengthUnit unit = lengthUnit(ui, session);
      return {unit.perCube / session.flight().space.halfSize, unit.brief, unit.whole};
    }
    case SectionUnit::kDegrees:
      return {1.0, "\u00b0"};
    case SectionUnit::kZoom:
      return {1.0, ui.words("unit.zoom")};
    case SectionUnit::kNone:
      break;
  }
  return {};
}

void fields(Ui& ui, const Rect& rect, const Rect& row, const Session& session,
            const SpeedWindowMemory& memory, Actions& actions) {
  const SpeedValues& values = session.currentOrientation().speed;
  const auto box = [&](int column) {
    const float width = std::round(rect.width / 12.0f) - ui.px(2);
    return Rect{speedColumn(rect, column) - width / 2, row.y, width, row.height};
  };
  for (int j = 0; j < kSpeedValues; ++j) {
    const double value = values[static_cast<std::size_t>(j)];
    const auto typed = ui.field(kValues[j], box(j + 1), value,
                                {.decimals = value == std::round(value) ? 0 : 1,
                                 .enabled = memory.graph.has_value(),
                                 .weight = Weight::kSemibold,
                                 .centred = true});
    actions.typed(typed, [&](double entered) { return Command("set-speed-value", j, entered); });
  }
  const auto neighbour = [&](const char* id, int column, const Joint& joint) {
    const std::string words = beyondWords(ui, joint);
    if (words.empty()) return;
    const bool fits = ui.textWidth(words) <= box(column).width;
    // In small it may stand out into the free room beside the graph.
    Rect room = box(column);
    if (!fits) room = {room.x - ui.px(4), room.y, room.width + ui.px(8), room.height};
    ui.text(room, words,
            {.colour = ColourRole::kTextSecondary,
             .weight = fits ? Weight::kRegular : Weight::kSmall,
             .align = Align::kCentre,
             .mayShorten = true});
    ui.shows(id, box(column), words);
  };
  if (!memory.graph) return;
  neighbour("speed/before", 0, memory.graph->start);
  neighbour("speed/after", 11, memory.graph->end);
}

// Buttons that take over the neighbours' speeds, where they jump.
void matches(Ui& ui, const Rect& row, const Session& session, const SpeedWindowMemory& memory,
             Actions& actions) {
  const Joint start = memory.graph ? memory.graph->start : Joint{};
  const Joint end = memory.graph ? memory.graph->end : Joint{};
  const float width = ui.px(144);
  const auto button = [&](const char* id, const Rect& rect, const char* command, const Joint& joint,
                          SectionEnd side) {
    ButtonStyle style{.enabled = joint.jumps};
    if (!joint.jumps) style.tooltip = whyNoMatch(ui, joint, side);
    commandButton(ui, id, rect, command, session, actions, style);
  };
  button("speed/match_before", {row.x, row.y, width, row.height}, "match-speed before", start,
         SectionEnd::kStart);
  button("speed/match_after", {row.right() - width, row.y, width, row.height}, "match-speed after",
         end, SectionEnd::kEnd);
}

// A small graph with a heading and a value at the right.
void smallGraph(Ui& ui, const Rect& rect, const char* id, const std::string& value,
                const SpeedGraph* graph, double low, double high,
                const std::function<double(const SpeedGraph::Point&)>& of, ColourRole role) {
  const Rect heading{rect.x, rect.y, rect.width, ui.px(18)};
  const float width = ui.textWidth(value, Weight::kSmall);
  const float room = heading.width - width - ui.px(8);
  const std::string whole = ui.words(id);
  const std::string brief = ui.words(std::string(id) + "#short");
  const bool fits = brief.empty() || ui.textWidth(whole, Weight::kSmall) <= room;
  ui.text({heading.x, heading.y, room, heading.height}, fits ? whole : brief,
          {.colour = ColourRole::kTextSecondary, .weight = Weight::kSmall});
  ui.text({heading.right() - width, heading.y, width, heading.height}, value,
          {.weight = Weight::kSmall, .align = Align::kRight});
  const Rect ground{rect.x, heading.bottom() + ui.px(2), rect.width,
                    rect.bottom() - heading.bottom() - ui.px(2)};
  ui.fill(ground, ColourRole::kField, 3.0f);
  ui.shows(id, rect, value);
  const float margin = std::min(ui.px(8), std::round(ground.height / 6.0f));
  const Rect inner{ground.x + ui.px(8), ground.y + margin, ground.width - 2 * ui.px(8),
                   ground.height - 2 * margin};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float range = static_cast<float>(high - low);
  const auto y = [&](double v) {
    return inner.bottom() - inner.height * static_cast<float>(v - low) / range;
  };
  const float zero = std::round(y(0.0)) + 0.5f;
  list.AddLine({ground.x, zero}, {ground.right(), zero}, ui.colour(ColourRole::kBorder), 1.0f);
  if (graph == nullptr) return;
  std::vector<ImVec2> points;
  for (const SpeedGraph::Point& p : graph->points) {
    points.emplace_back(inner.x + inner.width * static_cast<float>(p.tau), y(of(p)));
  }
  list.AddPolyline(points.data(), static_cast<int>(points.size()), ui.colour(role), 0,
                   1.8f * ui.scale());
}

// The first one takes `first` pixels of the row.
void lowerGraphs(Ui& ui, const Rect& row, float first, const Session& session,
                 const SpeedWindowMemory& memory) {
  const float second = first + ui.px(16);
  const Rect boxes[] = {{row.x, row.y, first, row.height},
                        {row.x + second, row.y, row.width - second, row.height}};
  const SpeedGraph* graph = memory.graph ? &*memory.graph : nullptr;
  std::string way, acceleration;
  double amount = 1.0, most = 1.0;
  if (graph != nullptr) {
    const Measure measure = measureOf(ui, session, *graph);
    way = withUnit(measured(ui, graph->amount * measure.per), measure.unit);
    acceleration =
        "\u00b1 " + withUnit(measured(ui, graph->most * measure.per), measure.unit + "/s\u00b2");
    if (graph->amount > 0.0) amount = graph->amount;
    if (graph->most > 0.0) most = graph->most;
  }
  smallGraph(
      ui, boxes[0], "speed/way", way, graph, 0.0, amount,
      [](const SpeedGraph::Point& p) { return p.way; }, ColourRole::kCurve);
  smallGraph(
      ui, boxes[1], "speed/acceleration", acceleration, graph, -most, most,
      [](const SpeedGraph::Point& p) { return p.acceleration; }, ColourRole::kCurve);
}

std::string easeId(std::string_view name) {
  std::string id = "speed/ease_" + std::string(name);
  std::replace(id.begin(), id.end(), '-', '_');
  return id;
}

// A button with the curve that it makes.
void easeButton(Ui& ui, const Rect& box, std::string_view name, const Session& session,
                Actions& actions, bool enabled) {
  const std::string id = easeId(name);
  const SpeedValues values = *easeValues(name);
  const bool on = enabled && values == session.currentOrientation().speed;
  if (ui.pictureButton(id, box,
                       {.enabled = enabled, .on = on, .toggle = true, .tooltip = ui.words(id)})) {
    actions.run(Command("ease", std::string(name)));
  }
  const SpeedCurve curve(values);
  constexpr int kChords = 36;
  std::vector<ImVec2> points;
  const Rect inner = box.inset(ui.px(6));
  for (int i = 0; i <= kChords; ++i) {
    const double tau = static_cast<double>(i) / kChords;
    points.emplace_back(inner.x + inner.width * static_cast<float>(tau),
                        inner.bottom() - inner.height * static_cast<float>(curve.at(tau) / 100.0));
  }
  ImGui::GetWindowDrawList()->AddPolyline(
      points.data(), static_cast<int>(points.size()),
      ui.colour(enabled ? ColourRole::kText : ColourRole::kTextDisabled), 0, 1.5f * ui.scale());
}

void easeGrid(Ui& ui, Stack& rows, const Session& session, Actions& actions, bool enabled,
              bool flat) {
  constexpr const char* kRows[] = {"sine", "parabola", "acceleration"};
  constexpr const char* kColumns[] = {"in", "out", "in-out"};
  const float height = flat ? 24.0f : 28.0f;
  const float left = ui.px(64);
  const auto label = [&](const Rect& row, const std::string& key, const TextStyle& style) {
    ui.text({row.x, row.y, left - ui.px(2), row.height}, ui.words(key), style);
  };
  const auto boxesOf = [&](const Rect& row) {
    return split(ui, {row.x + left, row.y, row.width - left, row.height}, 3);
  };
  const Rect heads = rows.row(18);
  label(heads, "speed.ease", {.weight = Weight::kSemibold});
  const auto columns = boxesOf(heads);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    // They may stand in the gaps, too.
    const Rect& box = columns[i];
    ui.text(
        {box.x - ui.px(2), box.y, box.width + ui.px(4), box.height},
        ui.words("speed.ease_" + std::string(kColumns[i])),
        {.colour = ColourRole::kTextSecondary, .weight = Weight::kSmall, .align = Align::kCentre});
  }
  for (const char* kind : kRows) {
    rows.gap(kind == kRows[0] ? 2 : 4);
    const Rect row = rows.row(height);
    label(row, std::string("speed.") + kind, {.colour = ColourRole::kTextSecondary});
    const auto boxes = boxesOf(row);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      easeButton(ui, boxes[i], std::string(kColumns[i]) + "-" + kind, session, actions, enabled);
    }
  }
  // None of the three: as wide as all of them.
  rows.gap(4);
  const Rect constant = rows.row(height);
  label(constant, "speed.constant", {.colour = ColourRole::kTextSecondary});
  easeButton(ui, {constant.x + left, constant.y, constant.width - left, constant.height},
             "constant", session, actions, enabled);
}

// Mean and top speed of the section.
void speeds(Ui& ui, Stack& rows, const Session& session, const SpeedGraph& graph) {
  const Measure measure = measureOf(ui, session, graph);
  const std::pair<const char*, double> values[] = {{"speed/mean", graph.mean * measure.per},
                                                   {"speed/fastest", graph.fastest * measure.per}};
  // With the unit's name where there is room for it in both; the heading has it, too.
  const auto fits = [&](const std::string& unit) {
    return std::all_of(std::begin(values), std::end(values), [&](const auto& speed) {
      const std::string words = withUnit(measured(ui, speed.second), unit + "/s");
      return ui.textWidth(ui.words(speed.first)) + ui.px(8) +
                 ui.textWidth(words, Weight::kSemibold) <=
             rows.width();
    });
  };
  const bool named = !measure.whole.empty() && fits(measure.whole);
  const std::string unit = named ? measure.whole : fits(measure.unit) ? measure.unit : "";
  for (const auto& [id, value] : values) {
    ui.valueRow(rows.row(18), id, ui.words(id), withUnit(measured(ui, value), unit + "/s"));
  }
  // What the film's other programs will see, where that is another number.
  if (graph.unit == SectionUnit::kScene && measure.per != 1.0) {
    ui.valueRow(rows.row(18), "speed/in_scene", ui.words("speed/in_scene"),
                measured(ui, graph.fastest) + " /s");
  }
}

void duration(Ui& ui, Stack& rows, const Session& session, const SpeedWindowMemory& memory,
              Actions& actions) {
  const Orientation& orientation = session.currentOrientation();
  const SpeedGraph* graph = memory.graph ? &*memory.graph : nullptr;
  const bool owns = graph != nullptr;
  const double fps = session.flight().frameRate;
  const std::int64_t frames = owns ? graph->frames : 0;
  const auto row = [&](const char* key) {
    const Rect all = rows.row(kRow);
    rows.gap(4);
    ui.text({all.x, all.y, ui.px(96), all.height}, ui.words(key),
            {.colour = ColourRole::kTextSecondary});
    return Rect{all.right() - ui.px(84), all.y, ui.px(84), all.height};
  };
  const auto field = [&](const char* id, const char* key, double value, int decimals,
                         const std::string& suffix, bool enabled, const char* command) {
    const auto typed = ui.field(
        id, row(key), value,
        {.decimals = decimals, .suffix = suffix, .enabled = enabled, .weight = Weight::kSemibold});
    actions.typed(typed, [&](double entered) { return Command(command, entered); });
  };
  field("speed/seconds", "speed/duration", orientation.duration.value_or(toldSeconds(frames, fps)),
        kTimeDecimals, " s", owns, "set-duration");
  field("speed/frames", "speed.frames", static_cast<double>(frames), 0,
        " " + ui.words(frames == 1 ? "frames_short#one" : "frames_short"), owns,
        "set-duration-frames");
  field("speed/hold_seconds", "speed/hold", orientation.hold, 2, " s", true, "set-hold");
  commandButton(ui, "speed/by_rate", rows.row(kRow), "clear-duration", session, actions,
                {.enabled = orientation.duration.has_value()});
  rows.gap(4);
  if (owns) speeds(ui, rows, session, *graph);
}

std::string heading(const Ui& ui, const Session& session, const SpeedWindowMemory& memory,
                    float room) {
  std::string words = fmt::format("{} \u00b7 {} {} \u00b7 {} {} {} {}", ui.words("panel/speed"),
                                  ui.words("position/key"), session.current().key + 1,
                                  ui.words("orientation/short"), session.current().orientation + 1,
                                  ui.words("of"), session.currentKey().orientations.size());
  if (memory.graph) {
    words += " \u00b7 " + ui.words("kind/" + std::string(name(memory.graph->kind)));
    const std::string unit = measureOf(ui, session, *memory.graph).whole;
    // Where there is room for it.
    const std::string longer = words + " \u00b7 " + unit;
    if (!unit.empty() && ui.textWidth(longer, Weight::kSemibold) <= room) return longer;
  }
  return words;
}

// The curve with its numbers and buttons; its right end is returned.
Rect curveWithNumbers(Ui& ui, const Rect& room, const Measures& measures, const Session& session,
                      SpeedWindowMemory& memory, Actions& actions) {
  const Rect graph{room.x + ui.px(kAxis), room.y, 12 * ui.px(measures.column),
                   ui.px(measures.graph)};
  const bool tells = measures.there && memory.graph && memory.graph->unit != SectionUnit::kNone;
  const Measure measure = tells ? measureOf(ui, session, *memory.graph) : Measure{0.0};
  speedCurveArea(ui, graph, measure.per, session, memory, actions);
  const Rect numbers{graph.x, graph.bottom() + ui.px(4), graph.width, ui.px(kRow)};
  fields(ui, graph, numbers, session, memory, actions);
  const Rect buttons{graph.x, numbers.bottom() + ui.px(6), graph.width, ui.px(kRow)};
  matches(ui, buttons, session, memory, actions);
  if (tells) {
    ui.text({graph.right() + ui.px(6), numbers.y, ui.px(kThere), numbers.height},
            measure.unit + "/s",
            {.colour = ColourRole::kTextSecondary, .weight = Weight::kSmall, .mayShorten = true});
  }
  return {graph.x, graph.y, graph.width, buttons.bottom() - graph.y};
}

// The eases, the durations beside them, the small graphs under both.
void belowTheCurve(Ui& ui, const Rect& room, const Rect& curve, const Session& session,
                   const SpeedWindowMemory& memory, Actions& actions) {
  const float top = curve.bottom() + ui.px(8);
  const float gap = ui.px(16);
  const float half = std::floor((room.width - gap) / 2);
  Stack eases(ui, room.x, top, half);
  easeGrid(ui, eases, session, actions, memory.graph.has_value(), false);
  Stack numbers(ui, room.x + half + gap, top, room.width - half - gap);
  duration(ui, numbers, session, memory, actions);
  const float below = std::max(eases.y(), numbers.y()) + ui.px(8);
  lowerGraphs(ui, {room.x, below, room.width, ui.px(kNarrowLower)}, half, session, memory);
}

// Where a window of this height ends: above the timeline, of which it is about, where the viewport
// keeps the larger half; else over it.
float bottomOf(Ui& ui, float height) {
  const float all = ImGui::GetIO().DisplaySize.y;
  const Widget* timeline = ui.registry().find("view/timeline_splitter");
  if (timeline == nullptr) return all;
  const float top = timeline->rect.centreY();
  const Rect& area = ui.workArea();
  return top - height - area.y > kViewportShare * area.height ? top : all;
}

}  // namespace

void speedWindow(Ui& ui, const Session& session, SpeedWindowMemory& memory, Actions& actions) {
  follow(session, memory);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const bool flat = screen.y < ui.px(kLowScreen) && screen.x >= ui.px(kFlat.width);
  const float wide = std::floor(ui.workArea().width / ui.scale());
  const bool slim = wide < kLarge.width;
  const Measures measures = flat ? kFlat : slim ? narrow(std::max(kLeastNarrow, wide)) : kLarge;
  const FloatingFrame frame{
      "speed",
      measures.width,
      measures.height,
      heading(ui, session, memory, ui.px(measures.width - 64.0f)),
      std::nullopt,
      std::max(ui.px(36), bottomOf(ui, ui.px(measures.height + 8)) - ui.px(measures.height + 8))};
  const bool stays = floatingFrame(ui, frame, memory.place, [&](const Rect& room) {
    const Rect curve = curveWithNumbers(ui, room, measures, session, memory, actions);
    const bool owns = memory.graph.has_value();
    if (slim) return belowTheCurve(ui, room, curve, session, memory, actions);
    const float left = curve.right() + ui.px(kThere) + ui.px(8);
    Stack rows(ui, left, room.y, flat ? ui.px(kRamps) : room.right() - left);
    easeGrid(ui, rows, session, actions, owns, flat);
    if (!flat) {
      rows.gap(10);
      duration(ui, rows, session, memory, actions);
      const float top = curve.bottom() + ui.px(8);
      lowerGraphs(ui, {curve.x, top, curve.width, room.bottom() - top},
                  std::floor((curve.width - ui.px(16)) / 2), session, memory);
      return;
    }
    const float right = left + ui.px(kRamps + 12);
    Stack numbers(ui, right, room.y, room.right() - right);
    duration(ui, numbers, session, memory, actions);
    const float top = std::max(rows.y(), numbers.y()) + ui.px(4);
    lowerGraphs(ui, {left, top, room.right() - left, room.bottom() - top}, ui.px(kRamps), session,
                memory);
  });
  if (!stays) actions.run(Command("close-window", "speed"));
}

}  // namespace vides
