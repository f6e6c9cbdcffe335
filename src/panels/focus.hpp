// SPDX-License-Identifier: MIT
// Which widget has the keyboard, and how Tab walks from one to the next.
//
// There is one ring for each panel and each window: its fields, sliders and buttons in the order in
// which they are drawn, as the registry has them. Widgets take part by being registered; nothing
// else is needed of a panel or window.
#pragma once

#include <string>
#include <string_view>

#include "panels/widget_registry.hpp"

namespace vides {

class KeyboardFocus {
 public:
  // What a key asks for. It happens in the display frame that follows.
  void walk(int step) { step_ = step; }  // 1 to the next one, -1 to the one before
  void operate() { operates_ = true; }   // the widget does what a click on it does
  void drop();                           // none has it any more; a window walks on from there

  // The widget that has it; empty: none.
  const std::string& widget() const { return widget_; }
  // The window (its ring's name) whose widgets have it or can get it by walking; empty: none.
  const std::string& window() const { return window_; }
  // Whether Enter and Space operate the widget that has it: else they are its own.
  bool operable(const WidgetRegistry& registry) const;
  // Whether walking leads anywhere.
  bool canWalk() const { return !widget_.empty() || !window_.empty(); }

  // Before and after widgets are drawn. settle() takes the step; true where it leads to another
  // widget, which has to be drawn then.
  void begin() { window_.clear(); }
  bool settle(const WidgetRegistry& registry);

  // For widgets and windows while they are drawn.
  void inWindow(std::string_view ring) { window_ = ring; }
  void give(std::string_view widget) { widget_ = widget; }  // it is being typed into
  // It was clicked at: it doesn't get the keyboard, but a window walks on from there.
  void passed(std::string_view widget) { last_ = widget; }
  // Once, by the widget: it has just been walked to; Enter or Space was pressed.
  bool takeArrival(std::string_view widget);
  bool takeOperation(std::string_view widget);
  bool arrives() const { return arrives_; }
  bool walking() const { return step_ != 0; }

  // The window that is to come to the front in this display frame.
  std::string raise;

 private:
  std::string widget_, last_, window_;
  int step_ = 0;
  bool operates_ = false;
  bool arrives_ = false;
};

}  // namespace vides
