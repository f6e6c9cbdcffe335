// SPDX-License-Identifier: MIT
// The pointer in the viewport: turning, panning and sizing the view. (Handles come before it.)
#pragma once

#include <optional>

#include "edit/session.hpp"
#include "input/input_event.hpp"
#include "math/vector.hpp"
#include "math/view_projection.hpp"

namespace vides {

// Every drag is computed from the view at its press, and begins after 3 pixels (times the content
// scale); less is a click.
class ViewportHand {
 public:
  // The pointer's place, also outside the viewport.
  void move(Session& session, const Vec2& pointer, double contentScale);
  // In the viewport `pixels`.
  void press(Session& session, PointerButton button, const PixelRectangle& pixels);
  void release(PointerButton button);
  void wheel(Session& session, double steps, const PixelRectangle& pixels);
  // Puts the view back. False where nothing is dragged.
  bool cancel(Session& session);

  const Vec2& pointer() const { return pointer_; }
  bool dragging() const { return drag_ && drag_->moved; }

 private:
  struct Drag {
    PointerButton button = PointerButton::kLeft;
    Vec2 from{0.0};
    ViewState start;
    PixelRectangle pixels;
    bool moved = false;
  };
  std::optional<Drag> drag_;
  Vec2 pointer_{-1.0};
};

}  // namespace vides
