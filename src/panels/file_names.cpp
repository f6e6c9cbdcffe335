// SPDX-License-Identifier: MIT
// Names of files on the screen.
#include "panels/file_names.hpp"

#include <imgui.h>

#include "flight/printable.hpp"

namespace vides {

std::string shownName(const Ui& ui, std::string_view name) {
  const ImFont* const font = ui.font(Weight::kRegular);
  return unambiguous(name, [font](char32_t character) {
    return character <= IM_UNICODE_CODEPOINT_MAX &&
           font->FindGlyphNoFallback(static_cast<ImWchar>(character)) != nullptr;
  });
}

bool nameEntry(Ui& ui, std::string_view id, std::string_view name) {
  const std::string words = shownName(ui, name);
  const std::string label = "###" + std::string(id);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  const float width = ui.textWidth(words);
  const bool chosen = ImGui::Selectable(label.c_str(), false, 0, {width, height});
  ui.text({at.x, at.y, width, height}, words);
  return chosen;
}

}  // namespace vides
