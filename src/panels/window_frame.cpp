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

// Takes the pointer from all that lies under it. It must not take the focus as well, which would
// end what is being typed above it.
void shade(const std::string& id) {
  ImGui::SetNextWindowPos({0.0f, 0.0f});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::SetNextWindowBgAlpha(0.45f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  ImGui::Begin(id.c_str(), nullptr, kFlags | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  ImGui::End();
  ImGui::PopStyleVar();
}

// Dear ImGui clips a window's content short of its sides.
void edge(Ui& ui, const Rect& all) {
  ImGui::PushClipRect({all.x, all.y}, {all.right(), all.bottom()}, false);
  ui.outline(all, ColourRole::kTextDisabled, 6.0f);
  ImGui::PopClipRect();
}

// Draws what needs at least this size (pixels) into the room; where that is smaller, the wheel and
// bars in the margin right and below, `margin` wide, reach the rest.
void scrolled(const Ui& ui, const Rect& room, float margin, float width, float height,
              const std::function<void(const Rect&)>& content) {
  if (room.width >= width && room.height >= height) return content(room);
  // Dear ImGui clips what a window holds short of its sides.
  const float bars = margin - ui.px(4);
  ImGui::SetCursorScreenPos({room.x, room.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("###scrolled", {room.width + bars, room.height + bars}, false,
                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_HorizontalScrollbar);
  ImGui::PopStyleVar();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const Rect all{from.x, from.y, std::max(room.width, width), std::max(room.height, height)};
  content(all);
  ImGui::SetCursorScreenPos(from);
  ImGui::Dummy({all.width, all.height});
  ImGui::EndChild();
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

void windowFrame(Ui& ui, const WindowFrame& frame,
                 const std::function<void(const Rect&)>& content) {
  if (frame.modal) shade(std::string(frame.id) + "/shade");
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float w = std::min(ui.px(frame.width), screen.x);
  const float pad = ui.px(16);
  std::vector<std::string> lines{frame.heading};
  if (frame.wraps) lines = wrapped(ui, frame.heading, w - 2 * pad, Weight::kSemibold);
  const float more = ui.px(20) * static_cast<float>(lines.size() - 1);
  const float h = std::min(ui.px(frame.height) + more, screen.y);
  ImGui::SetNextWindowPos({std::round((screen.x - w) / 2), std::round((screen.y - h) / 2)});
  ImGui::SetNextWindowSize({w, h});
  if (frame.focus) ImGui::SetNextWindowFocus();
  ImGui::Begin(frame.id, nullptr, kFlags);
  if (frame.modal) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  const ImVec2 corner = ImGui::GetWindowPos();
  const Rect all{corner.x, corner.y, w, h};
  edge(ui, all);
  const float above = ui.px(32) + more;
  scrolled(ui, all.inset(pad), pad, ui.px(needed(frame.width, frame.leastWidth)) - 2 * pad,
           ui.px(needed(frame.height, frame.leastHeight)) + more - 2 * pad, [&](const Rect& inner) {
             Rect row{inner.x, inner.y, inner.width, ui.px(24)};
             for (const std::string& line : lines) {
               ui.text(row, line, {.weight = Weight::kSemibold, .mayShorten = true});
               row.y += ui.px(20);
             }
             content({inner.x, inner.y + above, inner.width, inner.height - above});
           });
  ImGui::End();
}

bool floatingFrame(Ui& ui, const FloatingFrame& frame, WindowPlace& place,
                   const std::function<void(const Rect&)>& content) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const float w = std::min(ui.px(frame.width), screen.x);
  const float h = std::min(ui.px(frame.height), screen.y);
  if (place.dragging) {
    place.x = pointer.x - place.gripX;
    place.y = pointer.y - place.gripY;
  }
  // Wholly on the screen, also when that has become smaller.
  const float wantedX = frame.x.value_or(std::round((screen.x - w) / 2));
  const float wantedY = frame.y.value_or(std::round((screen.y - h) / 2));
  const float x = std::round(std::clamp(place.moved ? place.x : wantedX, 0.0f, screen.x - w));
  const float y = std::round(std::clamp(place.moved ? place.y : wantedY, 0.0f, screen.y - h));
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({w, h});
  const std::string id = "###" + frame.area;
  ImGui::Begin(id.c_str(), nullptr, kFlags);
  edge(ui, {x, y, w, h});
  const float pad = ui.px(12);
  const float close = ui.px(24);
  const Rect row{x + pad, y + ui.px(8), w - 2 * pad, close};
  const auto state = ui.area(frame.area + "/heading", {x, y, w - close - pad, ui.px(36)});
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
  ui.text({row.x, row.y, row.width - close, row.height}, frame.heading,
          {.weight = Weight::kSemibold, .mayShorten = true});
  const std::string own = ui.words(frame.area + "/close");
  const bool closed = ui.iconButton(
      frame.area + "/close", {row.right() - close + ui.px(4), row.y, close, close}, Icon::kClose,
      {.quiet = true,
       .tooltip = own.empty() ? ui.words("shortcuts/close") : own,
       .command = "escape"});
  const float above = row.bottom() + ui.px(8) - y;
  scrolled(ui, {row.x, y + above, row.width, h - above - pad}, pad,
           ui.px(needed(frame.width, frame.leastWidth)) - 2 * pad,
           ui.px(needed(frame.height, frame.leastHeight)) - above - pad, content);
  ImGui::End();
  return !closed;
}

}  // namespace vides
