// SPDX-License-Identifier: MIT
// The editor without a screen, moved by events.
#include "app/drive/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vides {
namespace {

constexpr double kFrame = 1.0 / 60.0;
constexpr int kMostScrolls = 200;

// "menu/file/open" stands in "menu/file"; an entry of a submenu after its opener's name and "_".
std::string parentMenu(const std::string& id) {
  if (id.starts_with("menu/file/recent_")) return "menu/file/recent";
  const std::size_t slash = id.rfind('/');
  const bool entry = id.starts_with("menu/") && slash > 5 && slash != std::string::npos;
  return entry ? id.substr(0, slash) : std::string();
}

}  // namespace

tl::expected<std::unique_ptr<Player>, std::string> Player::create(OffscreenHost& host,
                                                                  bool waitForWork) {
  host.makeCurrent();
  EditorOptions options;
  options.clipboard = [&host] { return host.clipboard(); };
  options.setClipboard = [&host](const std::string& text) { host.setClipboard(text); };
  options.glide = false;
  options.waitForWork = waitForWork;
  std::unique_ptr<Player> player(new Player(host));
  std::set<std::string>& operated = player->operated_;
  options.ran = [&operated](const Command& c) { operated.insert("command " + c.name); };
  options.pressed = [&operated](const Shortcut& s) {
    operated.insert("shortcut " + scriptName(s));
  };
  auto editor = Editor::create(host.gl(), std::move(options));
  if (!editor) return Failure(editor.error());
  player->editor_ = std::move(*editor);
  return player;
}

// A height near y where the wheel scrolls the column: over the pictures it means something else.
double Player::besidePictures(double x, double y) const {
  for (const char* id : {"camera/picture", "view/picture"}) {
    const Widget* const picture = editor_->widgets().find(id);
    if (picture == nullptr) continue;
    const Rect& seen = picture->visible;
    if (seen.contains(static_cast<float>(x), static_cast<float>(y))) {
      return static_cast<double>(seen.bottom()) + 2.0;
    }
  }
  return y;
}

void Player::draw() {
  FrameInput input;
  input.events = host_.takeEvents();
  input.time = host_.time();
  input.size = host_.size();
  input.contentScale = host_.contentScale();
  const bool visible = host_.beginDrawing();
  if (!visible) host_.makeCurrent();
  outcome_ = editor_->frame(input);
  if (visible) host_.swap();
}

void Player::frame() {
  host_.advanceTime(kFrame);
  draw();
}

void Player::event(InputEvent event) {
  host_.push(std::move(event));
  frame();
}

// Areas are operated by the pointer, wherever that comes from.
void Player::noteAreas() {
  for (const auto& [id, widget] : editor_->widgets().widgets()) {
    const bool over =
        widget.visible.contains(static_cast<float>(pointer_.x), static_cast<float>(pointer_.y));
    if (over && widget.kind == WidgetKind::kArea) operated_.insert("widget " + id);
  }
}

void Player::move(double x, double y) {
  pointer_ = {x, y};
  event(PointerMoved{x, y});
}

void Player::button(PointerButton button, bool pressed) {
  if (pressed) noteAreas();
  event(ButtonChanged{button, pressed, modifiers_});
}

void Player::key(KeyboardKey key, bool pressed) {
  const Modifiers own = modifierOf(key);
  const auto set = [pressed](bool& modifier, bool concerned) {
    if (concerned) modifier = pressed;
  };
  set(modifiers_.shift, own.shift);
  set(modifiers_.control, own.control);
  set(modifiers_.alt, own.alt);
  set(modifiers_.super, own.super);
  event(KeyChanged{key, pressed, false, modifiers_});
}

void Player::type(const std::string& text) { event(TextTyped{text}); }

void Player::tap(KeyboardKey which, const Modifiers& held) {
  const std::pair<bool, KeyboardKey> all[] = {{held.control, KeyboardKey::kLeftControl},
                                              {held.shift, KeyboardKey::kLeftShift},
                                              {held.alt, KeyboardKey::kLeftAlt},
                                              {held.super, KeyboardKey::kLeftSuper}};
  for (const auto& [on, modifier] : all) {
    if (on) key(modifier, true);
  }
  key(which, true);
  key(which, false);
  for (const auto& [on, modifier] : all) {
    if (on) key(modifier, false);
  }
}

void Player::click(double x, double y, PointerButton which) {
  move(x, y);
  button(which, true);
  button(which, false);
}

bool Player::perform(const Command& command) {
  host_.makeCurrent();
  const bool done = editor_->run(command);
  frame();
  return done;
}

tl::expected<Widget, std::string> Player::bringIntoSight(const std::string& id) {
  const std::string menu = parentMenu(id);
  if (!menu.empty() && editor_->widgets().find(id) == nullptr) {
    if (auto opened = clickWidget(menu); !opened) return Failure(opened.error());
    frame();
  }
  for (int i = 0; i < kMostScrolls; ++i) {
    const Widget* widget = editor_->widgets().find(id);
    if (widget == nullptr) {
      return Failure(fmt::format("expected a widget {} on screen, found none", id));
    }
    const float middle = widget->rect.centreY();
    if (widget->visible.contains(widget->rect.centreX(), middle)) return *widget;
    // Its column is scrolled with the wheel, the pointer over it.
    const PixelSize size = host_.size();
    const double before = static_cast<double>(middle);
    const double x = static_cast<double>(widget->rect.centreX());
    move(x, besidePictures(x, std::clamp(before, size.height * 0.3, size.height * 0.5)));
    event(WheelTurned{0.0, middle > static_cast<float>(size.height) * 0.4f ? -1.0 : 1.0});
    frame();
    const Widget* after = editor_->widgets().find(id);
    if (after != nullptr && static_cast<double>(after->rect.centreY()) == before) break;
  }
  return Failure(fmt::format("expected {} to be reachable, found it outside the window", id));
}

tl::expected<void, std::string> Player::clickWidget(const std::string& id) {
  const auto widget = bringIntoSight(id);
  if (!widget) return Failure(widget.error());
  if (!widget->enabled)
    return Failure(fmt::format("expected {} to be enabled, found it greyed", id));
  click(static_cast<double>(widget->rect.centreX()), static_cast<double>(widget->rect.centreY()));
  operated_.insert("widget " + id);
  return {};
}

tl::expected<void, std::string> Player::setWidget(const std::string& id, const std::string& value) {
  const auto widget = bringIntoSight(id);
  if (!widget) return Failure(widget.error());
  if (!widget->enabled)
    return Failure(fmt::format("expected {} to be enabled, found it greyed", id));
  const double x = static_cast<double>(widget->rect.centreX());
  const double y = static_cast<double>(widget->rect.centreY());
  switch (widget->kind) {
    case WidgetKind::kField:
    case WidgetKind::kEntry:
      click(x, y);
      break;
    case WidgetKind::kSlider: {
      key(KeyboardKey::kLeftControl, true);
      click(x, y);
      key(KeyboardKey::kLeftControl, false);
      break;
    }
    case WidgetKind::kToggle:
    case WidgetKind::kMenuItem: {
      const bool on = widget->value == "on";
      if (value != "on" && value != "off") {
        return Failure(fmt::format("expected on or off for {}, found {}", id, value));
      }
      if (on != (value == "on")) click(x, y);
      operated_.insert("widget " + id);
      return {};
    }
    case WidgetKind::kChoice: {
      operated_.insert("widget " + id);
      // Its entries are on screen, or come there by a click.
      if (editor_->widgets().find(id + "_" + value) != nullptr)
        return clickWidget(id + "_" + value);
      click(x, y);
      frame();
      return clickWidget(id + "_" + value);
    }
    default:
      return Failure(
          fmt::format("expected {} to take a value, found a {}", id, name(widget->kind)));
  }
  operated_.insert("widget " + id);
  frame();
  tap(KeyboardKey::kA, {.control = true});
  value.empty() ? tap(KeyboardKey::kDelete, {}) : type(value);
  if (widget->kind == WidgetKind::kEntry) {
    frame();
  } else {
    tap(KeyboardKey::kEnter, {});
  }
  return {};
}

tl::expected<Picture, std::string> Player::picture() {
  draw();
  return host_.picture();
}

}  // namespace vides
