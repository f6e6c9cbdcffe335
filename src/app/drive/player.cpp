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
  EditorOptions options;
  options.makeCurrent = [&host] { host.makeCurrent(); };
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
  std::vector<Text>& errors = player->errors_;
  options.said = [&errors](MessageKind kind, const Text& text) {
    const bool error = kind == MessageKind::kRefusal || kind == MessageKind::kError;
    if (error) errors.push_back(text);
  };
  auto editor = Editor::create(host.gl(), std::move(options));
  if (!editor) return Failure(editor.error());
  player->editor_ = std::move(*editor);
  return player;
}

void Player::draw() {
  FrameInput input;
  input.events = host_.takeEvents();
  input.time = host_.time();
  input.size = host_.size();
  input.contentScale = host_.contentScale();
  const bool visible = host_.beginDrawing();
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
  const bool done = editor_->run(command);
  frame();
  return done;
}

// One step of the wheel over what it stands in; false if that doesn't move it. Windows that are too
// wide for the screen are as wide as that, so what is beside it is to be scrolled across.
bool Player::scrollTowards(const Widget& widget) {
  const std::string id = widget.id;
  const auto middle = [](const Widget& w, bool x) {
    return x ? w.rect.centreX() : w.rect.centreY();
  };
  const PixelSize size = host_.size();
  const double x =
      std::clamp(static_cast<double>(middle(widget, true)), size.width * 0.03, size.width * 0.97);
  const double y =
      std::clamp(static_cast<double>(middle(widget, false)), size.height * 0.4, size.height * 0.5);
  const bool across = x != static_cast<double>(middle(widget, true));
  const float before = middle(widget, across);
  move(x, y);
  // Over the pictures the wheel means something else: beside the one in the column it scrolls.
  if (editor_->overPicture()) {
    for (const char* picture : {"camera/picture", "view/picture"}) {
      const Widget* const area = editor_->widgets().find(picture);
      if (area == nullptr || !area->visible.contains(static_cast<float>(x), static_cast<float>(y)))
        continue;
      move(static_cast<double>(area->rect.x) - 3.0, y);
    }
  }
  const int extent = across ? size.width : size.height;
  const double step = before > static_cast<float>(extent) * 0.4f ? -1.0 : 1.0;
  event(WheelTurned{across ? step : 0.0, across ? 0.0 : step});
  frame();
  const Widget* after = editor_->widgets().find(id);
  return after == nullptr || middle(*after, across) != before;
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
    if (!scrollTowards(*widget)) break;
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
