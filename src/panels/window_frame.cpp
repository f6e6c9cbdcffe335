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
  ui.outline(all, ColourRole::kBorder, 6.0f);
  const Rect inner = all.inset(ui.px(16));
  ui.text({inner.x, inner.y, inner.width, ui.px(24)}, frame.heading,
          {.weight = Weight::kSemibold, .mayShorten = true});
  content({inner.x, inner.y + ui.px(32), inner.width, inner.height - ui.px(32)});
  ImGui::End();
}

}  // namespace vides
