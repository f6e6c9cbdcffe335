// SPDX-License-Identifier: MIT
// Windows over the editor.
#include "panels/window_frame.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

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

}  // namespace

void windowFrame(Ui& ui, const WindowFrame& frame,
                 const std::function<void(const Rect&)>& content) {
  if (frame.modal) shade(std::string(frame.id) + "/shade");
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float w = std::min(ui.px(frame.width), screen.x);
  const float h = std::min(ui.px(frame.height), screen.y);
  ImGui::SetNextWindowPos({std::round((screen.x - w) / 2), std::round((screen.y - h) / 2)});
  ImGui::SetNextWindowSize({w, h});
  if (frame.focus) ImGui::SetNextWindowFocus();
  ImGui::Begin(frame.id, nullptr, kFlags);
  if (frame.modal) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  const ImVec2 corner = ImGui::GetWindowPos();
  const Rect all{corner.x, corner.y, w, h};
  edge(ui, all);
  const Rect inner = all.inset(ui.px(16));
  ui.text({inner.x, inner.y, inner.width, ui.px(24)}, frame.heading,
          {.weight = Weight::kSemibold, .mayShorten = true});
  content({inner.x, inner.y + ui.px(32), inner.width, inner.height - ui.px(32)});
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
  content({row.x, row.bottom() + ui.px(8), row.width, y + h - pad - row.bottom() - ui.px(8)});
  ImGui::End();
  return !closed;
}

}  // namespace vides
