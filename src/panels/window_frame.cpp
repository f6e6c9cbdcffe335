// SPDX-License-Identifier: MIT
// Windows over the editor.
#include "panels/window_frame.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "flight/utf8.hpp"

namespace vides {
namespace {

constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                    ImGuiWindowFlags_NoMove;

constexpr float kHeading = 24.0f;
constexpr float kAboveHeading = 8.0f;
constexpr float kLine = 20.0f;  // each further line of a heading

// How dark what lies under a modal window gets: less where it is bright.
double shadeOf(const Theme& theme) {
  const Colour& ground = theme[ColourRole::kPanel];
  return ground.red + ground.green + ground.blue > 3 * 128 ? 0.35 : 0.45;
}

// Takes the pointer from all that lies under it. It must not take the focus as well, which would
// end what is being typed above it.
void shade(const Ui& ui, const std::string& id) {
  ImGui::SetNextWindowPos({0.0f, 0.0f});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  // Black, and not the ground's colour: that of the panels would come up to the window's.
  ImGui::PushStyleColor(ImGuiCol_WindowBg,
                        ImVec4(0.0f, 0.0f, 0.0f, static_cast<float>(shadeOf(ui.theme()))));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  ImGui::Begin(id.c_str(), nullptr, kFlags | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

// Dear ImGui clips a window's content short of its sides.
void edge(Ui& ui, const Rect& all) {
  ImGui::PushClipRect({all.x, all.y}, {all.right(), all.bottom()}, false);
  ui.outline(all, ColourRole::kTextDisabled, 6.0f);
  ImGui::PopClipRect();
}

// Draws what needs at least this size (pixels) into the room; where that is smaller, the wheel and
// bars in the margins, `right` and `below` wide, reach the rest.
struct Margins {
  float right, below;
};
void scrolled(const Ui& ui, const Rect& room, const Margins& margins, float width, float height,
              const FramePart& content) {
  if (room.width >= width && room.height >= height) return content(room);
  // Dear ImGui clips what a window holds short of its sides.
  const float side = ui.px(4);
  ImGui::SetCursorScreenPos({room.x, room.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("###scrolled",
                    {room.width + margins.right - side, room.height + margins.below - side}, false,
                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_HorizontalScrollbar);
  ImGui::PopStyleVar();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const Rect all{from.x, from.y, std::max(room.width, width), std::max(room.height, height)};
  content(all);
  ImGui::SetCursorScreenPos(from);
  ImGui::Dummy({all.width, all.height});
  ImGui::EndChild();
}

// Between the heading and the window's lower edge: the content, and the buttons if there are any.
struct Inside {
  Rect room;  // of both
  float pad;  // from there to the window's edges
  float wantedWidth, wantedHeight;
};
void inside(const Ui& ui, const Inside& place, const FramePart& content, const FramePart& buttons) {
  const float high = buttons ? ui.px(kWindowButtons) : 0.0f;
  const float gap = buttons ? ui.px(kAboveWindowButtons) : 0.0f;
  const Rect& room = place.room;
  const Rect rest{room.x, room.y, room.width, std::max(0.0f, room.height - high - gap)};
  scrolled(ui, rest, {place.pad, buttons ? gap : place.pad}, place.wantedWidth,
           place.wantedHeight - high - gap, content);
  if (buttons) buttons({room.x, room.bottom() - high, room.width, high});
}

// Between Begin and End of a window: its widgets are a ring of the keyboard's.
WidgetRegistry::Ring ringOfWindow(Ui& ui, std::string_view name) {
  if (ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) {
    ui.memory().focus.inWindow(name);
  }
  return {ui.registry(), std::string(name)};
}

// The button at a heading's right end, the last one that the keyboard reaches; true if it was
// pressed.
bool closeButton(Ui& ui, const std::string& id, const Rect& row) {
  const std::string own = ui.words(id);
  return ui.iconButton(id, {row.right() - row.height + ui.px(4), row.y, row.height, row.height},
                       Icon::kClose,
                       {.quiet = true,
                        .tooltip = own.empty() ? ui.words("shortcuts/close") : own,
                        .command = "escape"});
}

// What the content of a frame needs, of the frame's sizes.
float needed(float wanted, float least) { return least > 0.0f ? least : wanted; }

}  // namespace

std::vector<std::string> wrapped(const Ui& ui, std::string_view text, float width, Weight weight) {
  std::vector<std::string> lines;
  std::string line;
  const auto fits = [&](const std::string& words) { return ui.textWidth(words, weight) <= width; };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string longer = line.empty() ? word : line + " " + word;
    if (fits(longer)) {
      line = longer;
      continue;
    }
    if (!line.empty()) lines.push_back(std::exchange(line, {}));
    // A word that is longer than a line, as names of files may be.
    while (!fits(word)) {
      std::size_t part = 0;
      while (part < word.size()) {
        const std::size_t next = part + std::max<std::size_t>(1, utf8Length(word.substr(part)));
        if (part > 0 && !fits(word.substr(0, next))) break;
        part = next;
      }
      if (part >= word.size()) break;
      lines.push_back(word.substr(0, part));
      word.erase(0, part);
    }
    line = std::move(word);
  }
  if (!line.empty() || lines.empty()) lines.push_back(line);
  return lines;
}

std::vector<Rect> lastButtons(const Ui& ui, const Rect& row, int count) {
  const float gap = ui.px(8);
  const auto parts = static_cast<float>(count);
  const float each =
      std::min(ui.px(kLastButton), std::floor((row.width - (parts - 1.0f) * gap) / parts));
  std::vector<Rect> places;
  for (int i = 0; i < count; ++i) {
    const float fromRight = static_cast<float>(count - i);
    places.push_back(
        {row.right() - fromRight * each - (fromRight - 1.0f) * gap, row.y, each, row.height});
  }
  return places;
}

bool windowFrame(Ui& ui, const WindowFrame& frame, const FramePart& content,
                 const FramePart& buttons) {
  if (frame.modal) shade(ui, std::string(frame.id) + "/shade");
  const Rect& area = ui.workArea();
  const float w = std::min(ui.px(frame.width), area.width);
  const float pad = ui.px(16);
  const float text = w - 2 * pad;
  std::vector<std::string> lines{frame.heading};
  std::vector<std::string> details;
  if (frame.wraps) lines = wrapped(ui, frame.heading, text, Weight::kSemibold);
  if (!frame.detail.empty()) details = wrapped(ui, frame.detail, text);
  const float more = ui.px(kLine) * static_cast<float>(lines.size() - 1 + details.size());
  const float h = std::min(ui.px(frame.height) + more, area.height);
  const Rect all{std::round(area.centreX() - w / 2), std::round(area.centreY() - h / 2), w, h};
  ImGui::SetNextWindowPos({all.x, all.y});
  ImGui::SetNextWindowSize({w, h});
  if (frame.focus) ImGui::SetNextWindowFocus();
  ImGui::Begin(frame.id, nullptr, kFlags);
  if (frame.modal) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  const WidgetRegistry::Ring ring =
      ringOfWindow(ui, std::string_view(frame.id).substr(std::string_view("###").size()));
  edge(ui, all);
  Rect row{all.x + pad, all.y + ui.px(kAboveHeading), text, ui.px(kHeading)};
  const Rect heading = row;
  const float button = frame.close.empty() ? 0.0f : row.height;
  for (const std::string& line : lines) {
    ui.text({row.x, row.y, row.width - button, row.height}, line,
            {.weight = Weight::kSemibold, .mayShorten = true});
    row.y += ui.px(kLine);
  }
  for (const std::string& line : details) {
    ui.text(row, line, {.colour = ColourRole::kTextSecondary, .mayShorten = true});
    row.y += ui.px(kLine);
  }
  const float above = ui.px(2 * kAboveHeading + kHeading) + more;
  inside(ui,
         {{row.x, all.y + above, text, h - above - pad},
          pad,
          ui.px(needed(frame.width, frame.leastWidth)) - 2 * pad,
          ui.px(needed(frame.height, frame.leastHeight)) + more - above - pad},
         content, buttons);
  const bool closed = !frame.close.empty() && closeButton(ui, frame.close, heading);
  ImGui::End();
  return !closed;
}

bool floatingFrame(Ui& ui, const FloatingFrame& frame, WindowPlace& place, const FramePart& content,
                   const FramePart& buttons) {
  const Rect& area = ui.workArea();
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const float w = std::min(ui.px(frame.width), area.width);
  const float h = std::min(ui.px(frame.height), area.height);
  if (place.dragging) {
    place.x = pointer.x - place.gripX;
    place.y = pointer.y - place.gripY;
  }
  // Wholly in the work area, also when that has become smaller.
  const float wantedX = frame.x.value_or(area.centreX() - w / 2);
  const float wantedY = frame.y.value_or(area.centreY() - h / 2);
  const auto within = [](float wanted, float low, float high) {
    return std::round(std::clamp(wanted, low, std::max(low, high)));
  };
  const float x = within(place.moved ? place.x : wantedX, area.x, area.right() - w);
  const float y = within(place.moved ? place.y : wantedY, area.y, area.bottom() - h);
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({w, h});
  const std::string id = "###" + frame.area;
  if (ui.memory().focus.raise == frame.area) {
    ImGui::SetNextWindowFocus();
    ui.memory().focus.raise.clear();
  }
  ImGui::Begin(id.c_str(), nullptr, kFlags);
  const WidgetRegistry::Ring ring = ringOfWindow(ui, frame.area);
  edge(ui, {x, y, w, h});
  const float pad = ui.px(12);
  const Rect row{x + pad, y + ui.px(kAboveHeading), w - 2 * pad, ui.px(kHeading)};
  const auto state =
      ui.area(frame.area + "/heading",
              {x, y, w - row.height - pad, ui.px(2 * kAboveHeading + kHeading) - ui.px(4)});
  if (state.pressed) {
    place.dragging = true;
    place.moved = true;
    place.x = x;
    place.y = y;
    place.gripX = pointer.x - x;
    place.gripY = pointer.y - y;
  }
  if (!state.held) place.dragging = false;
  if (state.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  ui.text({row.x, row.y, row.width - row.height, row.height}, frame.heading,
          {.weight = Weight::kSemibold, .mayShorten = true});
  const float above = row.bottom() + ui.px(kAboveHeading) - y;
  inside(ui,
         {{row.x, y + above, row.width, h - above - pad},
          pad,
          ui.px(needed(frame.width, frame.leastWidth)) - 2 * pad,
          ui.px(needed(frame.height, frame.leastHeight)) - above - pad},
         content, buttons);
  const bool closed = closeButton(ui, frame.area + "/close", row);
  ImGui::End();
  return !closed;
}

}  // namespace vides
