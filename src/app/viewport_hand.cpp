// SPDX-License-Identifier: MIT
// The pointer in the viewport.
#include "app/viewport_hand.hpp"

#include "math/vector.hpp"

namespace vides {
namespace {

constexpr double kStartPixels = 3.0;
constexpr double kDegreesPerPixel = 0.4;

}  // namespace

void ViewportHand::move(Session& session, const Vec2& pointer, double contentScale) {
  pointer_ = pointer;
  if (!drag_) return;
  const Vec2 by = pointer - drag_->from;
  if (!drag_->moved && glm::length(by) < kStartPixels * contentScale) return;
  drag_->moved = true;
  ViewState state = drag_->start;
  const double degrees = kDegreesPerPixel / contentScale;
  // The cube follows the hand: to the right, and towards the viewer when pulled down.
  state.view = drag_->button == PointerButton::kLeft
                   ? turnedAbout(state.view, state.pivot, -by.x * degrees, by.y * degrees)
                   : panned(state.view, drag_->pixels, by);
  session.setView(state);
}

void ViewportHand::press(Session& session, PointerButton button, const PixelRectangle& pixels) {
  if (drag_ || button == PointerButton::kRight) return;
  drag_ = Drag{button, pointer_, session.view(), pixels, false};
}

void ViewportHand::release(PointerButton button) {
  if (drag_ && drag_->button == button) drag_.reset();
}

void ViewportHand::wheel(Session& session, double steps, const PixelRectangle& pixels) {
  ViewState state = session.view();
  state.view = sizedTowards(state.view, pixels, pointer_, steps);
  session.setView(state);
}

bool ViewportHand::cancel(Session& session) {
  if (!drag_) return false;
  session.setView(drag_->start);
  drag_.reset();
  return true;
}

}  // namespace vides
