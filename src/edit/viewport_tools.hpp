// SPDX-License-Identifier: MIT
// What pointer and keys do in the viewport: drag points, turn the VUP, navigate, select, insert.
//
// Fed with plain events; picking is passed in, so that what is hit is what is drawn. Changes the
// session by its commands and gestures alone. Times are passed in, too.
#pragma once

#include <functional>
#include <optional>

#include "edit/plane_drag_tool.hpp"
#include "edit/session.hpp"
#include "input/input_event.hpp"
#include "scene/viewport_scene.hpp"

namespace vides {

// What lies under the pointer.
struct PointerTarget {
  std::optional<HandleId> handle;
  std::optional<CurveHit> curve;  // counts where there is no handle
};

// The viewport at the time of an event.
struct ViewportPlace {
  ViewProjection view;  // as drawn: its pixels are the viewport's rectangle
  double contentScale = 1.0;
  std::function<PointerTarget(const Vec2& pixel)> pick;
  double now = 0.0;  // seconds
};

// Said beside the pointer.
struct PointerNote {
  Text text;
  Vec2 pixel{0.0};
  double until = 0.0;  // seconds
};

class ViewportTools {
 public:
  static constexpr double kClickPixels = 3.0;  // less movement is a click
  static constexpr double kNoteSeconds = 3.0;

  explicit ViewportTools(Session& session) : session_(session) {}

  void press(const ViewportPlace& place, PointerButton button, const Vec2& pixel,
             const Modifiers& modifiers);
  void move(const ViewportPlace& place, const Vec2& pixel, const Modifiers& modifiers);
  // What lies under the pointer in the picture just drawn; no pixel: the pointer is elsewhere.
  // True if that is another handle than before. Nothing while a button is down.
  bool hover(const ViewportPlace& place, const std::optional<Vec2>& pixel);
  void release(const ViewportPlace& place, PointerButton button, const Vec2& pixel,
               const Modifiers& modifiers);
  void wheel(const ViewportPlace& place, const Vec2& pixel, double steps);
  // True where the key means something to a drag: shortcuts must not have it then.
  bool key(const ViewportPlace& place, const KeyChanged& event);
  // Ends what is being done and puts everything back: Escape, or the window lost the focus.
  void cancel();

  // A button is down, or a drag is going on: events belong here wherever the pointer is.
  bool active() const { return press_.has_value(); }
  bool dragging() const { return press_ && press_->dragging; }
  bool navigating() const { return navigateOnly_; }

  // For drawing.
  const std::optional<HandleId>& hovered() const { return hovered_; }
  std::optional<DragDisplay> drag() const;
  std::optional<PixelRectangle> box() const;
  // Where the dragged point is and what keys do to it, or how far the VUP is turned.
  std::optional<OutputLine> output() const;
  // What the hovered handle can do; empty without one.
  Text hint() const;
  // Nothing after its time.
  std::optional<PointerNote> note(double now) const;

 private:
  enum class Doing { kNothing, kPoint, kUp, kTurn, kPan, kBox };
  struct Press {
    PointerButton button;
    Vec2 start{0.0};
    Vec2 pointer{0.0};
    Modifiers modifiers;
    PointerTarget target;
    ViewState view;  // at the press
    ViewState from;  // that it is turned and moved from
    bool dragging = false;
    Doing doing = Doing::kNothing;
    std::optional<PlaneDragTool> tool;
  };

  bool wantsPan() const;
  void startDrag(const ViewportPlace& place);
  void startPoint(const ViewportPlace& place, const HandleId& handle);
  void startUp();
  void continueDrag(const ViewportPlace& place);
  void movePoint(const ViewportPlace& place);
  void turnUp(const ViewportPlace& place);
  void navigate(const ViewportPlace& place);
  void click(const ViewportPlace& place);
  void selectBox(const ViewportPlace& place);
  void refuse(const ViewportPlace& place, Text why);
  void setView(const EditorView& view);

  Session& session_;
  std::optional<Press> press_;
  std::optional<HandleId> hovered_;
  std::optional<PointerNote> note_;
  bool navigateOnly_ = false;  // V is held
};

}  // namespace vides
