// SPDX-License-Identifier: MIT
// What the editor makes of events before Dear ImGui sees them: the viewport's pointer, shortcuts.
#include <imgui.h>

#include "app/editor_parts.hpp"

namespace vides {
namespace {

PixelRectangle pixelsOf(const Rect& rect) {
  return {static_cast<double>(rect.x), static_cast<double>(rect.y), static_cast<double>(rect.width),
          static_cast<double>(rect.height)};
}

}  // namespace

void Editor::Parts::notice(const InputEvent& event) {
  if (const auto* moved = std::get_if<PointerMoved>(&event)) {
    hand.move(session, {moved->x, moved->y}, scale);
  } else if (const auto* button = std::get_if<ButtonChanged>(&event)) {
    buttonChanged(*button);
  } else if (const auto* wheel = std::get_if<WheelTurned>(&event)) {
    if (overViewport && !session.view().swapped) {
      hand.wheel(session, wheel->y, pixelsOf(pictures->viewportRect()));
      glide.reset();
    }
  } else if (const auto* key = std::get_if<KeyChanged>(&event)) {
    keyChanged(*key);
  } else if (const auto* dropped = std::get_if<FilesDropped>(&event)) {
    for (const std::string& path : dropped->paths) {
      const bool flight = path.ends_with(".vid");
      session.execute(Command(flight ? "open" : "import-scene", path));
    }
  } else if (std::holds_alternative<CloseRequested>(event)) {
    session.execute(Command("quit"));
  } else if (const auto* focus = std::get_if<FocusChanged>(&event)) {
    if (focus->focused) {
      session.checkDisk();
    } else {
      input.release(ImGui::GetIO());
    }
  }
}

void Editor::Parts::buttonChanged(const ButtonChanged& change) {
  if (!change.pressed) {
    hand.release(change.button);
  } else if (overViewport && !session.view().swapped) {
    glide.reset();
    hand.press(session, change.button, pixelsOf(pictures->viewportRect()));
  }
}

void Editor::Parts::keyChanged(const KeyChanged& change) {
  if (!change.pressed || !memory.editing.empty() || ImGui::GetIO().WantTextInput) return;
  if (change.key == KeyboardKey::kEscape && hand.cancel(session)) return;
}

std::string Editor::Parts::shortcutOf(std::string_view) const { return {}; }

}  // namespace vides
