// SPDX-License-Identifier: MIT
// The settings window.
#include "panels/settings_window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

#include "math/whole.hpp"
#include "panels/form.hpp"
#include "panels/quantities.hpp"

namespace vides {
namespace {

constexpr float kRow = 24.0f;
constexpr float kButton = 26.0f;
constexpr float kColourLabel = 48.0f;
constexpr float kChoiceLabel = 120.0f;

// "scene-points" in commands and files, "settings/show_scene_points" on screen.
std::string widgetName(std::string_view name) {
  std::string result(name);
  std::replace(result.begin(), result.end(), '-', '_');
  return result;
}

std::vector<ColourRole> elements() {
  std::vector<ColourRole> roles;
  for (std::size_t i = 0; i < kColourRoles; ++i) {
    if (isElement(static_cast<ColourRole>(i))) roles.push_back(static_cast<ColourRole>(i));
  }
  return roles;
}

// The elements in two columns, each with its colour; one of them is chosen.
void elementList(Ui& ui, Stack& rows, SettingsMemory& memory) {
  const std::vector<ColourRole> roles = elements();
  const std::size_t half = (roles.size() + 1) / 2;
  const float top = rows.y();
  const std::vector<Rect> columns = split(ui, rows.row(kRow * static_cast<float>(half)), 2, 8.0f);
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const Rect& column = columns[i / half];
    const float y = top + ui.px(kRow) * static_cast<float>(i % half);
    const Rect row{column.x, y, column.width, ui.px(kRow)};
    const std::string id = "settings/element_" + std::string(name(roles[i]));
    if (ui.choiceRow(id, row, ui.words(id), memory.element == roles[i], roles[i])) {
      memory.element = roles[i];
    }
  }
}

Command colourCommand(ColourRole element, const std::array<int, 3>& bytes) {
  Command command("set-colour", std::string(name(element)));
  for (const int byte : bytes) command.add(byte);
  return command;
}

// The paper's three sliders.
void colourSliders(Ui& ui, Stack& rows, const Session& session, const SettingsMemory& memory,
                   Actions& actions) {
  const Colour now = themeOf(session.display())[memory.element];
  const std::array<int, 3> bytes = {now.red, now.green, now.blue};
  constexpr const char* kIds[] = {"settings/red", "settings/green", "settings/blue"};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const Rect row = rows.row(kRow);
    const float label = ui.px(kColourLabel);
    const float number = ui.px(32);
    ui.text({row.x, row.y, label, row.height}, ui.words(kIds[i]),
            {.colour = ColourRole::kTextSecondary});
    const auto change =
        ui.slider(kIds[i], {row.x + label, row.y, row.width - label - number, row.height}, bytes[i],
                  {.least = 0.0, .most = 255.0, .decimals = 0});
    ui.text({row.right() - number, row.y, number, row.height}, std::to_string(bytes[i]),
            {.weight = Weight::kSemibold, .align = Align::kRight});
    if (!change) continue;
    std::array<int, 3> next = bytes;
    next[i] = static_cast<int>(wholeWithin(std::round(change->value), 0, 255));
    actions.run(colourCommand(memory.element, next));
  }
}

// "#56B4E9".
std::string hexOf(const Colour& colour) {
  return fmt::format("#{:02X}{:02X}{:02X}", colour.red, colour.green, colour.blue);
}

// With or without #, of six digits or, as web pages shorten it, of three.
std::optional<std::array<int, 3>> parseHex(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  text = text.substr(0, text.find_last_not_of(kBlank) + 1);
  if (text.starts_with('#')) text.remove_prefix(1);
  if (text.size() != 6 && text.size() != 3) return std::nullopt;
  const std::size_t each = text.size() / 3;
  std::array<int, 3> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::string_view digits = text.substr(i * each, each);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), bytes[i], 16);
    if (error != std::errc() || end != digits.data() + digits.size() || digits[0] == '-') {
      return std::nullopt;
    }
    if (each == 1) bytes[i] *= 0x11;
  }
  return bytes;
}

// The same colour as text, and what gives it back to the theme.
void colourText(Ui& ui, const Rect& row, const Session& session, const SettingsMemory& memory,
                Actions& actions) {
  const Colour now = themeOf(session.display())[memory.element];
  ui.text({row.x, row.y, ui.px(kColourLabel), row.height}, ui.words("settings/hex"),
          {.colour = ColourRole::kTextSecondary});
  const Rect field{row.x + ui.px(kColourLabel), row.y, ui.px(88), row.height};
  const auto typed = ui.textField("settings/hex", field, hexOf(now));
  if (!typed) return;
  const auto bytes = parseHex(*typed);
  if (!bytes) {
    actions.refusal = Text("refusal.hex", {*typed});
    return;
  }
  actions.run(colourCommand(memory.element, *bytes));
}

void colours(Ui& ui, Stack& rows, const Session& session, SettingsMemory& memory,
             Actions& actions) {
  elementList(ui, rows, memory);
  rows.gap(8);
  colourSliders(ui, rows, session, memory, actions);
  rows.gap(4);
  colourText(ui, rows.row(kRow), session, memory, actions);
  rows.gap(12);
  const std::vector<Rect> row = split(ui, rows.row(kButton), 2, 8.0f);
  const auto& chosen = session.display().colours;
  const bool own = chosen[static_cast<std::size_t>(memory.element)].has_value();
  const bool any = std::any_of(chosen.begin(), chosen.end(), [](const auto& c) { return c; });
  if (ui.button("settings/theme_colour", row[0], {.enabled = own})) {
    actions.run(Command("reset-colour", std::string(name(memory.element))));
  }
  if (ui.button("settings/theme_colours", row[1], {.enabled = any})) {
    actions.run(Command("reset-colour"));
  }
}

// How views move is no matter of what is shown.
constexpr std::string_view kGlide = "glide";

void shownElements(Ui& ui, Stack& rows, const Session& session, Actions& actions) {
  Display display = session.display();
  std::vector<std::string_view> names;
  for (const auto& each : switchNames()) {
    if (each != kGlide) names.push_back(each);
  }
  const std::size_t half = (names.size() + 1) / 2;
  const float top = rows.y();
  const std::vector<Rect> columns = split(ui, rows.row(kRow * static_cast<float>(half)), 2, 8.0f);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Rect& column = columns[i / half];
    const float y = top + ui.px(kRow) * static_cast<float>(i % half);
    const std::string id = "settings/show_" + widgetName(names[i]);
    if (ui.checkBox(id, {column.x, y, column.width, ui.px(kRow)}, *switchOf(display, names[i]))) {
      actions.run(Command("show-element", std::string(names[i]), "toggle"));
    }
  }
}

// A label and a number that can be typed.
Ui::Typed numberRow(Ui& ui, Stack& rows, std::string_view id, double value, int decimals) {
  const Rect row = rows.row(kRow);
  const float field = ui.px(72);
  ui.text({row.x, row.y, row.width - field - ui.px(8), row.height}, ui.words(id),
          {.colour = ColourRole::kTextSecondary});
  return ui.field(id, {row.right() - field, row.y, field, row.height}, value,
                  {.decimals = decimals, .weight = Weight::kSemibold});
}

void sizeSlider(Ui& ui, const Rect& row, const Session& session, const ElementSize& size,
                Actions& actions) {
  const std::string id = "settings/size_" + std::string(size.name);
  const double pixels = session.display().sizes.*size.size;
  const float label = ui.px(108);
  const float number = ui.px(56);
  ui.text({row.x, row.y, label, row.height}, ui.words(id), {.colour = ColourRole::kTextSecondary});
  const auto change =
      ui.slider(id, {row.x + label, row.y, row.width - label - number, row.height}, pixels,
                {.least = size.range.min, .most = size.range.max, .decimals = size.decimals});
  ui.text({row.right() - number, row.y, number, row.height},
          ui.number(pixels, size.decimals) + " px",
          {.weight = Weight::kSemibold, .align = Align::kRight});
  if (!change) return;
  const double unit = std::pow(10.0, size.decimals);
  const double rounded = change->typed ? change->value : std::round(change->value * unit) / unit;
  actions.run(Command("element-size", std::string(size.name), rounded));
}

void sizes(Ui& ui, Stack& rows, const Session& session, Actions& actions) {
  const Display& display = session.display();
  for (const ElementSize& size : kElementSizes) {
    sizeSlider(ui, rows.row(kRow), session, size, actions);
  }
  rows.gap(8);
  if (ui.button("settings/built_in_sizes", rows.row(kButton),
                {.enabled = display.sizes != ElementSizes()})) {
    actions.run(Command("reset-sizes"));
  }
  rows.gap(16);
  actions.typed(numberRow(ui, rows, "settings/ghost_every", display.shown.ghostEvery, 0),
                [](double value) { return Command("ghost-every", value); });
  rows.gap(4);
  const double unit = lengthUnit(ui, session).perCube;
  const double step = display.gridStep * unit;
  actions.typed(numberRow(ui, rows, "settings/grid_step", step, neededDecimals(step)),
                [&](double value) { return Command("grid-step", value / unit); });
}

// A label, and beside it toggles of which one is on.
struct Segment {
  std::string id;
  std::string label;
  std::string command;
  bool on;
};
// The place beside a label.
Rect labelled(Ui& ui, Stack& rows, std::string_view labelKey) {
  const Rect row = rows.row(kButton);
  const float label = ui.px(kChoiceLabel);
  ui.text({row.x, row.y, label - ui.px(8), row.height}, ui.words(labelKey),
          {.colour = ColourRole::kTextSecondary});
  rows.gap(10);
  return {row.x + label, row.y, row.width - label, row.height};
}
void segments(Ui& ui, Stack& rows, std::string_view labelKey, const std::vector<Segment>& all,
              Actions& actions) {
  std::vector<std::string> labels;
  for (const Segment& segment : all) labels.push_back(segment.label);
  const std::vector<Rect> boxes = splitFor(ui, labelled(ui, rows, labelKey), labels);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (ui.button(all[i].id, boxes[i], all[i].label, {.on = all[i].on, .toggle = true})) {
      if (auto command = parseCommand(all[i].command)) actions.run(std::move(*command));
    }
  }
}

Segment named(const Ui& ui, std::string_view id, std::string command, bool on) {
  return {std::string(id), ui.words(id), std::move(command), on};
}

void choices(Ui& ui, Stack& rows, const Session& session, Actions& actions) {
  const Display& d = session.display();
  const auto theme = [&](const char* id, ThemeKind kind) {
    return named(ui, id, "theme " + std::string(name(kind)), d.theme == kind);
  };
  segments(ui, rows, "settings.theme",
           {theme("settings/theme_dark", ThemeKind::kDark),
            theme("settings/theme_light", ThemeKind::kLight),
            theme("settings/theme_high_contrast", ThemeKind::kHighContrast)},
           actions);
  segments(ui, rows, "settings.language",
           {named(ui, "settings/language_en", "language en", d.language == Language::kEnglish),
            named(ui, "settings/language_de", "language de", d.language == Language::kGerman)},
           actions);
  segments(ui, rows, "settings.units",
           {named(ui, "settings/units_cube", "units cube", d.units == Units::kCube),
            named(ui, "settings/units_scene", "units scene", d.units == Units::kScene)},
           actions);
  std::vector<Segment> scales;
  for (const double scale : kOfferedScales) {
    const std::string percent = std::to_string(std::lround(scale * 100.0));
    scales.push_back({"settings/scale_" + percent,
                      scale > 0.0 ? percent : ui.words("settings/scale_0"),
                      format(Command("content-scale", scale)), d.contentScale == scale});
  }
  segments(ui, rows, "settings.scale", scales, actions);
  if (ui.checkBox("settings/show_glide", labelled(ui, rows, "settings.motion"), d.glide)) {
    actions.run(Command("show-element", std::string(kGlide), "toggle"));
  }
}

void pages(Ui& ui, const Rect& row, SettingsMemory& memory) {
  constexpr const char* kIds[] = {"settings/page_colours", "settings/page_shown",
                                  "settings/page_sizes", "settings/page_general"};
  const std::vector<Rect> boxes = split(ui, row, 4);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto page = static_cast<SettingsPage>(i);
    if (ui.button(kIds[i], boxes[i], {.on = memory.page == page, .toggle = true})) {
      memory.page = page;
    }
  }
}

void lastRow(Ui& ui, const Rect& row, Actions& actions) {
  const std::vector<Rect> boxes = splitFor(
      ui, row, {ui.words("settings/reset"), ui.words("settings/load"), ui.words("settings/save")});
  if (ui.button("settings/reset", boxes[0])) actions.run(Command("reset-setup"));
  if (ui.button("settings/load", boxes[1])) actions.run(Command("load-setup"));
  if (ui.button("settings/save", boxes[2])) actions.run(Command("save-setup"));
}

}  // namespace

void settingsWindow(Ui& ui, const Session& session, SettingsMemory& memory, Actions& actions) {
  // Over the left column, so that changes are seen in the viewport.
  const FloatingFrame frame{"settings", 392.0f,   448.0f, ui.words("settings/heading"),
                            ui.px(8),   ui.px(36)};
  const bool stays = floatingFrame(
      ui, frame, memory.place,
      [&](const Rect& room) {
        Stack rows(ui, room.x, room.y, room.width);
        pages(ui, rows.row(kButton), memory);
        rows.gap(12);
        switch (memory.page) {
          case SettingsPage::kColours:
            colours(ui, rows, session, memory, actions);
            break;
          case SettingsPage::kShown:
            shownElements(ui, rows, session, actions);
            break;
          case SettingsPage::kSizes:
            sizes(ui, rows, session, actions);
            break;
          case SettingsPage::kGeneral:
            choices(ui, rows, session, actions);
            break;
        }
      },
      [&](const Rect& row) { lastRow(ui, row, actions); });
  if (!stays) actions.run(Command("close-window", "settings"));
}

}  // namespace vides
