// SPDX-License-Identifier: MIT
// The editor without a screen, moved by events: one display frame of 1/60 s for each.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "app/editor.hpp"
#include "host/offscreen_host.hpp"
#include "input/key.hpp"
#include "render/picture.hpp"

namespace vides {

class Player {
 public:
  // Error: what OpenGL refused. Work in threads is waited for in the display frame that began it,
  // unless somebody wants to see it going on.
  static tl::expected<std::unique_ptr<Player>, std::string> create(OffscreenHost& host,
                                                                   bool waitForWork = true);

  Editor& editor() { return *editor_; }
  const std::string& title() const { return outcome_.title; }
  // Whether it wants another display frame at once, without an event.
  bool unfinished() const { return outcome_.nextFrameIn && *outcome_.nextFrameIn <= 1.0 / 60.0; }
  // Whether it wants another display frame at all before something happens.
  bool wantsFrame() const { return outcome_.nextFrameIn.has_value(); }
  bool quit() const { return outcome_.quit; }
  const Modifiers& modifiers() const { return modifiers_; }

  // One display frame, 1/60 s later, after what was pushed.
  void frame();
  // Each runs a display frame.
  void event(InputEvent event);
  void move(double x, double y);
  void button(PointerButton button, bool pressed);
  void key(KeyboardKey key, bool pressed);
  void type(const std::string& text);
  // Down and up again.
  void tap(KeyboardKey key, const Modifiers& modifiers);
  void click(double x, double y, PointerButton which = PointerButton::kLeft);

  // A command by its text name, then a display frame. False where it was refused or failed.
  bool perform(const Command& command);
  // A widget operated as a hand would: its menu is opened, its column scrolled. Error: a sentence.
  tl::expected<void, std::string> clickWidget(const std::string& id);
  tl::expected<void, std::string> setWidget(const std::string& id, const std::string& value);
  // Scrolled until it can be pointed at.
  tl::expected<Widget, std::string> bringIntoSight(const std::string& id);

  // What has been operated, a line each: "command NAME", "shortcut KEYS", "widget ID".
  const std::set<std::string>& operated() const { return operated_; }
  // What the session refused, and what failed, since the last call.
  std::vector<Text> takeErrors() { return std::exchange(errors_, {}); }

  // The window as it is drawn when nothing moves any more; the script's time stands.
  tl::expected<Picture, std::string> picture();

 private:
  explicit Player(OffscreenHost& host) : host_(host) {}
  bool scrollTowards(const Widget& widget);
  void noteAreas();
  void draw();

  OffscreenHost& host_;
  std::unique_ptr<Editor> editor_;
  FrameOutcome outcome_;
  Modifiers modifiers_;
  Vec2 pointer_{-1.0};
  std::set<std::string> operated_;
  std::vector<Text> errors_;
};

}  // namespace vides
