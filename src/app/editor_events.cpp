// SPDX-License-Identifier: MIT
// What the editor makes of events before Dear ImGui sees them: the viewport's pointer, shortcuts.
#include <imgui.h>
#include <imgui_internal.h>

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
    return keyChanged(*key);
  } else if (const auto* text = std::get_if<TextTyped>(&event)) {
    return typed(*text);
  } else if (const auto* files = std::get_if<FilesDropped>(&event)) {
    dropped.insert(dropped.end(), files->paths.begin(), files->paths.end());
    takeDropped();
  } else if (std::holds_alternative<CloseRequested>(event)) {
    ask(Command("quit"));
  } else if (const auto* focus = std::get_if<FocusChanged>(&event)) {
    focusChanged(focus->focused);
  }
  return false;
}

// One after the other; what one of them asks is answered before the next.
void Editor::Parts::takeDropped() {
  while (!dropped.empty() && !session.question()) {
    const std::string path = dropped.front();
    dropped.erase(dropped.begin());
    if (path.ends_with(".vid")) {
      ask(Command("open", path));
    } else {
      ask(Command("import-scene", path, "ask"));
    }
  }
}

void Editor::Parts::buttonChanged(const ButtonChanged& change) {
  if (!change.pressed) {
    if (tools.active()) tools.release(viewportPlace(), change.button, pointerAt, change.modifiers);
    cameraTools.release(change.button);
    return;
  }
  memory.wheeled.clear();
  if (!dragging()) pressed = {session.layout(), session.frame()};
  // Beside an open menu: it closes, and the press does what it says where it falls.
  if (!session.menu().empty() &&
      !menus.holds(static_cast<float>(pointerAt.x), static_cast<float>(pointerAt.y))) {
    session.setMenu({});
  }
  memory.focus.drop();
  if (session.question() || tools.active() || cameraTools.active()) return;
  if (overCamera) {
    cameraTools.press(filmView(), change.button, pointerAt, change.modifiers);
  } else if (overViewport) {
    glide.reset();
    tools.press(viewportPlace(), change.button, pointerAt, change.modifiers);
  }
}

bool Editor::Parts::typing() const {
  return !memory.editing.empty() || ImGui::GetIO().WantTextInput;
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

bool Editor::Parts::keyChanged(const KeyChanged& change) {
  if (change.pressed && !session.menu().empty() && !dragging()) {
    menus.key(change);
    return modifierOf(change.key) == Modifiers{};
  }
  if (change.pressed && typing()) return keyWhileTyping(change);
  if (cameraTools.key(change) || tools.key(viewportPlace(), change)) return false;
  if (!change.pressed) return false;
  if (modifierOf(change.key) == Modifiers{}) memory.wheeled.clear();
  if (dragging()) {
    keyInDrag(change);
    return false;
  }
  if (keyOfFocus(change)) return true;
  // The chooser has all keys for itself, unless something is asked.
  if (!windowsMemory.chooser.window.empty() && !session.question()) return false;
  if (countChosen(change)) return false;
  const Shortcut* shortcut = shortcutFor(change.key, change.modifiers, change.repeated);
  if (shortcut == nullptr) return false;
  if (options.pressed) options.pressed(*shortcut);
  run(shortcut->command);
  return false;
}

bool Editor::Parts::keyWhileTyping(const KeyChanged& change) {
  const Modifiers& held = change.modifiers;
  const bool asks = !windowsMemory.chooser.window.empty() || session.question();
  if (change.key == KeyboardKey::kTab && !held.control && !held.alt && !held.super) {
    memory.endTyping = !memory.editing.empty();
    memory.focus.walk(held.shift ? -1 : 1);
    return true;
  }
  const Shortcut* shortcut = shortcutFor(change.key, held, change.repeated);
  if (shortcut == nullptr || !shortcut->commitsTyping || asks || memory.editing.empty())
    return false;
  if (options.pressed) options.pressed(*shortcut);
  memory.endTyping = true;
  afterTyping = shortcut->command;
  return true;
}

bool Editor::Parts::keyOfFocus(const KeyChanged& change) {
  KeyboardFocus& focus = memory.focus;
  const Modifiers& held = change.modifiers;
  if (held.control || held.alt || held.super) return false;
  if (change.key == KeyboardKey::kTab) {
    if (!focus.canWalk()) return false;
    focus.walk(held.shift ? -1 : 1);
    return true;
  }
  if (held.shift) return false;
  if (change.key == KeyboardKey::kEscape) {
    // In a panel nothing has to be closed: only the keyboard is given up.
    if (!focus.widget().empty() && focus.window().empty()) {
      focus.drop();
      return true;
    }
    if (!session.windowOpen(focus.window())) return false;
    run(Command("close-window", focus.window()));
    return true;
  }
  const bool operates = change.key == KeyboardKey::kEnter || change.key == KeyboardKey::kPadEnter ||
                        change.key == KeyboardKey::kSpace;
  if (!operates || !focus.operable(registry)) return false;
  if (!change.repeated) focus.operate();
  return true;
}

bool Editor::Parts::typed(const TextTyped& text) {
  if (session.menu().empty()) return false;
  menus.typed(text.text);
  return true;
}

bool Editor::Parts::dragging() const {
  if (session.inDrag() || tools.dragging() || cameraTools.dragging()) return true;
  if (!memory.dragging.empty()) return true;
  // Whatever widget holds the pointer: a splitter, a window's heading, the playhead.
  if (!ImGui::IsAnyItemActive() || ImGui::GetIO().WantTextInput) return false;
  const float far = ImGui::GetIO().MouseDragThreshold * static_cast<float>(scale);
  return ImGui::IsMouseDragging(ImGuiMouseButton_Left, far) ||
         ImGui::IsMouseDragging(ImGuiMouseButton_Right, far);
}

void Editor::Parts::keyInDrag(const KeyChanged& change) {
  if (change.key == KeyboardKey::kEscape) {
    // What a widget previews it puts back itself.
    if (memory.dragging.empty() && !session.inDrag()) putBack();
    return;
  }
  if (shortcutFor(change.key, change.modifiers) == nullptr) return;
  session.say(MessageKind::kRefusal, "refusal.in-gesture");
}

void Editor::Parts::putBack() {
  ImGui::ClearActiveID();
  memory.dragging.clear();
  session.setLayout(pressed.layout);
  if (session.frame() != pressed.frame) run(Command("go-to-frame", pressed.frame));
}

bool Editor::Parts::ask(const Command& command) {
  if (!dragging()) return run(command);
  if (command.name == "escape") {
    tools.cancel();
    cameraTools.cancel();
    session.cancel();
    putBack();
    return true;
  }
  session.say(MessageKind::kRefusal, "refusal.in-gesture");
  return false;
}

std::string Editor::Parts::shortcutOf(std::string_view commandLine) const {
  const auto command = parseCommand(commandLine);
  const Shortcut* shortcut = command ? vides::shortcutOf(*command) : nullptr;
  return shortcut == nullptr ? std::string() : shown(*shortcut, texts);
}

}  // namespace vides
