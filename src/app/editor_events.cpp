// SPDX-License-Identifier: MIT
// What the editor makes of events before Dear ImGui sees them: the viewport's pointer, shortcuts.
#include <imgui.h>

#include "app/editor_parts.hpp"
#include "edit/shortcuts.hpp"
#include "scene/camera_scene.hpp"

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
  return {pictures->handleUnder(pixel, session.current().key, scale),
          pictures->curveUnder(pixel, kCurveReach * scale)};
}

ViewportPlace Editor::Parts::viewportPlace() {
  return {viewProjection(session.view().view, pixelsOf(pictures->flightRect())), scale,
          [this](const Vec2& pixel) { return pick(pixel); }, time};
}

// What the camera sees, as it is drawn.
ViewProjection Editor::Parts::filmView() const {
  const Flight& flight = session.flight();
  const PixelRectangle picture = letterbox(pixelsOf(pictures->filmRect()), flight.picture);
  return cameraView(session.camera(), flight.picture, flight.lens, picture);
}

void Editor::Parts::pointerMoved() {
  if (cameraTools.active()) {
    cameraTools.move(pointerAt);
  } else if (overViewport || tools.active()) {
    tools.move(viewportPlace(), pointerAt, modifiers);
  }
}

// Whether it was meant for one of the pictures: else it scrolls what lies under the pointer.
bool Editor::Parts::wheelTurned(const WheelTurned& wheel) {
  if (overCamera) {
    cameraTools.wheel(wheel.y, modifiers);
  } else if (overViewport) {
    glide.reset();
    tools.wheel(viewportPlace(), pointerAt, wheel.y);
  } else {
    return false;
  }
  settling = kSettlingFrames;
  return true;
}

void Editor::Parts::focusChanged(bool focused) {
  if (focused) {
    session.checkDisk();
    return;
  }
  tools.cancel();
  cameraTools.stop();
  input.release(ImGui::GetIO());
}

void Editor::Parts::feed(ImGuiIO& io) {
  input.feed(
      io, [this](const InputEvent& event) { return notice(event); },
      [this](std::string_view text) { return memory.wide.folded(text); });
}

// True where Dear ImGui must not see it.
bool Editor::Parts::notice(const InputEvent& event) {
  if (const auto* moved = std::get_if<PointerMoved>(&event)) {
    pointerAt = {moved->x, moved->y};
    pointerMoved();
  } else if (const auto* button = std::get_if<ButtonChanged>(&event)) {
    modifiers = button->modifiers;
    buttonChanged(*button);
  } else if (const auto* wheel = std::get_if<WheelTurned>(&event)) {
    return wheelTurned(*wheel);
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
    focusChanged(focus->focused);
  }
  return false;
}

void Editor::Parts::buttonChanged(const ButtonChanged& change) {
  if (!change.pressed) {
    if (tools.active()) tools.release(viewportPlace(), change.button, pointerAt, change.modifiers);
    cameraTools.release(change.button);
    return;
  }
  if (session.question() || tools.active() || cameraTools.active()) return;
  if (overCamera) {
    cameraTools.press(filmView(), change.button, pointerAt, change.modifiers);
  } else if (overViewport) {
    glide.reset();
    tools.press(viewportPlace(), change.button, pointerAt, change.modifiers);
  }
}

// In "insert how many" a digit inserts that many at once, 0 ten.
bool Editor::Parts::countChosen(const KeyChanged& change) {
  const std::optional<int> digit = digitOf(change.key);
  const bool asked = !session.question() && !session.windows().empty() &&
                     session.windows().back() == "insert-keys";
  if (!digit || !asked || change.repeated || change.modifiers != Modifiers{}) return false;
  run(Command("close-window", "insert-keys"));
  run(Command("insert-keys", *digit == 0 ? 10 : *digit));
  return true;
}

void Editor::Parts::keyChanged(const KeyChanged& change) {
  const bool typing = !memory.editing.empty() || ImGui::GetIO().WantTextInput;
  if (typing && change.pressed) return;
  if (cameraTools.key(change) || tools.key(viewportPlace(), change)) return;
  if (!change.pressed || typing) return;
  // What is being dragged by a slider has Escape for itself.
  if (!memory.dragging.empty()) return;
  // The chooser has all keys for itself, unless something is asked.
  if (!windowsMemory.chooser.window.empty() && !session.question()) return;
  if (countChosen(change)) return;
  const Shortcut* shortcut = shortcutFor(change.key, change.modifiers, change.repeated);
  if (shortcut == nullptr) return;
  if (options.pressed) options.pressed(*shortcut);
  run(shortcut->command);
}

std::string Editor::Parts::shortcutOf(std::string_view commandLine) const {
  const auto command = parseCommand(commandLine);
  const Shortcut* shortcut = command ? vides::shortcutOf(*command) : nullptr;
  return shortcut == nullptr ? std::string() : shown(*shortcut, texts);
}

}  // namespace vides
