// SPDX-License-Identifier: MIT
// What the editor makes of events before Dear ImGui sees them: the viewport's pointer, shortcuts.
#include <imgui.h>

#include "app/editor_parts.hpp"
#include "edit/shortcuts.hpp"

namespace vides {
namespace {

PixelRectangle pixelsOf(const Rect& rect) {
  return {static_cast<double>(rect.x), static_cast<double>(rect.y), static_cast<double>(rect.width),
          static_cast<double>(rect.height)};
}

}  // namespace

// The handle or the place on the curve under a pixel, of the list drawn last.
PointerTarget Editor::Parts::pick(const Vec2& pixel) const {
  constexpr double kCurveReach = 6.0;
  PointerTarget target;
  const DrawList* list = pictures->flightList();
  if (list == nullptr || session.view().swapped) return target;
  target.handle = handleAt(*list, pixel, session.current().key, scale);
  target.curve = pictures->flightScene().nearestOnCurve(pixel, kCurveReach * scale);
  return target;
}

ViewportPlace Editor::Parts::viewportPlace() {
  return {viewProjection(session.view().view, pixelsOf(pictures->viewportRect())), scale,
          [this](const Vec2& pixel) { return pick(pixel); }, time};
}

void Editor::Parts::notice(const InputEvent& event) {
  if (const auto* moved = std::get_if<PointerMoved>(&event)) {
    pointerAt = {moved->x, moved->y};
    if (overViewport || tools.active()) tools.move(viewportPlace(), pointerAt, modifiers);
  } else if (const auto* button = std::get_if<ButtonChanged>(&event)) {
    modifiers = button->modifiers;
    buttonChanged(*button);
  } else if (const auto* wheel = std::get_if<WheelTurned>(&event)) {
    if (!overViewport || session.view().swapped) return;
    glide.reset();
    tools.wheel(viewportPlace(), pointerAt, wheel->y);
  } else if (const auto* key = std::get_if<KeyChanged>(&event)) {
    modifiers = key->modifiers;
    keyChanged(*key);
  } else if (const auto* dropped = std::get_if<FilesDropped>(&event)) {
    for (const std::string& path : dropped->paths) {
      run(Command(path.ends_with(".vid") ? "open" : "import-scene", path));
    }
  } else if (std::holds_alternative<CloseRequested>(event)) {
    run(Command("quit"));
  } else if (const auto* focus = std::get_if<FocusChanged>(&event)) {
    if (focus->focused) {
      session.checkDisk();
    } else {
      tools.cancel();
      input.release(ImGui::GetIO());
    }
  }
}

void Editor::Parts::buttonChanged(const ButtonChanged& change) {
  if (!change.pressed) {
    if (tools.active()) tools.release(viewportPlace(), change.button, pointerAt, change.modifiers);
    return;
  }
  if (!overViewport || session.view().swapped || session.question()) return;
  glide.reset();
  tools.press(viewportPlace(), change.button, pointerAt, change.modifiers);
}

void Editor::Parts::keyChanged(const KeyChanged& change) {
  const bool typing = !memory.editing.empty() || ImGui::GetIO().WantTextInput;
  if (typing && change.pressed) return;
  if (tools.key(viewportPlace(), change)) return;
  if (!change.pressed || typing) return;
  // What is being dragged by a slider has Escape for itself.
  if (!memory.dragging.empty()) return;
  // The chooser has all keys for itself, unless something is asked.
  if (!chooser.window.empty() && !session.question()) return;
  const Shortcut* shortcut = shortcutFor(change.key, change.modifiers, change.repeated);
  if (shortcut != nullptr) run(shortcut->command);
}

std::string Editor::Parts::shortcutOf(std::string_view commandLine) const {
  const auto command = parseCommand(commandLine);
  const Shortcut* shortcut = command ? vides::shortcutOf(*command) : nullptr;
  return shortcut == nullptr ? std::string() : shown(*shortcut, texts);
}

}  // namespace vides
