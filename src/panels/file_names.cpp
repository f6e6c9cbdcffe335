// SPDX-License-Identifier: MIT
// Names of files on the screen.
#include "panels/file_names.hpp"

#include <imgui.h>

#include "flight/printable.hpp"

namespace vides {

namespace {

// More would make a texture that no driver takes.
constexpr std::size_t kMostForeign = 2000;

}  // namespace

std::string shownName(Ui& ui, std::string_view name) {
  const ImFont* const font = ui.font(Weight::kRegular);
  std::set<char32_t>& foreign = ui.memory().foreign;
  return unambiguous(name, [&](char32_t character) {
    if (character > IM_UNICODE_CODEPOINT_MAX) return false;
    if (font->FindGlyphNoFallback(static_cast<ImWchar>(character)) != nullptr) return true;
    if (foreign.size() < kMostForeign) foreign.insert(character);
    return false;
  });
}

}  // namespace vides
