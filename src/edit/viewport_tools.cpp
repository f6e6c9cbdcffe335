// SPDX-License-Identifier: MIT
// The viewport's pointer and keys.
#include "edit/viewport_tools.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/vup_turn.hpp"

namespace vides {
namespace {

constexpr double kDegreesPerPixel = 0.4;
constexpr double kRollStep = 15.0;  // degrees, with Shift

Axis planeOf(PointerButton button, const Modifiers& modifiers) {
  if (button == PointerButton::kMiddle) return Axis::Y;
  if (button == PointerButton::kRight) return Axis::Z;
  return modifiers.control ? Axis::Y : Axis::X;
}

bool isPoint(const HandleId& handle) {
  return handle.kind == HandleKind::kKey || handle.kind == HandleKind::kAim ||
         handle.kind == HandleKind::kPlane;
}

std::optional<Axis> axisOf(KeyboardKey key) {
  if (key == KeyboardKey::kX) return Axis::X;
  if (key == KeyboardKey::kY) return Axis::Y;
  if (key == KeyboardKey::kZ) return Axis::Z;
  return std::nullopt;
}

Text textOf(TurnRefusal refusal) {
  switch (refusal) {
    case TurnRefusal::CircleEdgeOn:
      return "refusal.circle-edge-on";
    case TurnRefusal::NotInFront:
      return "refusal.not-in-front";
    case TurnRefusal::PointerAtCenter:
      return "refusal.pointer-at-key";
  }
  return {};
}

PixelRectangle rectangleBetween(const Vec2& a, const Vec2& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
}

bool contains(const PixelRectangle& r, const Vec2& p) {
  return p.x >= r.x && p.x <= r.x + r.width && p.y >= r.y && p.y <= r.y + r.height;
}

}  // namespace

// --- Events ---

void ViewportTools::press(const ViewportPlace& place, PointerButton button, const Vec2& pixel,
                          const Modifiers& modifiers) {
  if (press_) return;  // a second button while one is down means nothing
  Press press;
  press.button = button;
  press.start = press.pointer = pixel;
  press.modifiers = modifiers;
  press.view = press.from = session_.view();
  if (!navigateOnly_) press.target = place.pick(pixel);
  note_.reset();
  press_ = std::move(press);
  const std::optional<HandleId>& handle = press_->target.handle;
  // With Shift it may become a click that changes the selection: that is known on the release.
  if (!handle || modifiers.shift) return;
  if (handle->kind == HandleKind::kKey) {
    session_.execute(Command("make-current", handle->key));
  } else if (handle->kind == HandleKind::kAim || handle->kind == HandleKind::kUp) {
    session_.execute(Command("make-current", handle->key, handle->orientation));
  }
}

bool ViewportTools::hover(const ViewportPlace& place, const std::optional<Vec2>& pixel) {
  if (press_) return false;
  const auto before = hovered_;
  hovered_ = pixel && !navigateOnly_ ? place.pick(*pixel).handle : std::nullopt;
  return hovered_ != before;
}

void ViewportTools::move(const ViewportPlace& place, const Vec2& pixel,
                         const Modifiers& modifiers) {
  if (!press_) {
    hover(place, pixel);
    return;
  }
  press_->pointer = pixel;
  press_->modifiers.shift = modifiers.shift;
  if (!press_->dragging) {
    if (glm::length(pixel - press_->start) < kClickPixels) return;
    press_->dragging = true;
    startDrag(place);
  }
  continueDrag(place);
}

void ViewportTools::release(const ViewportPlace& place, PointerButton button, const Vec2& pixel,
                            const Modifiers& modifiers) {
  if (!press_ || press_->button != button) return;
  move(place, pixel, modifiers);
  if (!press_->dragging) {
    click(place);
  } else if (press_->doing == Doing::kPoint || press_->doing == Doing::kUp) {
    // What was last refused or not stays told: the commit itself says nothing.
    session_.commit();
  } else if (press_->doing == Doing::kBox) {
    selectBox(place);
  }
  press_.reset();
  hover(place, pixel);
}

void ViewportTools::wheel(const ViewportPlace& place, const Vec2& pixel, double steps) {
  const EditorView view = sizedTowards(session_.view().view, place.view.pixels(), pixel, steps);
  ViewportPlace next = place;
  next.view = viewProjection(view, place.view.pixels());
  if (press_ && press_->tool && !press_->tool->look(next.view)) return;
  // No command: it goes on during drags.
  ViewState state = session_.view();
  state.view = view;
  session_.setView(state);
  if (!press_ || !press_->dragging) return;
  // Turned and moved from here on.
  press_->from = session_.view();
  if (press_->doing == Doing::kTurn || press_->doing == Doing::kPan) press_->start = pixel;
  continueDrag(next);
}

bool ViewportTools::key(const ViewportPlace& place, const KeyChanged& event) {
  if (event.key == KeyboardKey::kV && event.modifiers == Modifiers{}) {
    navigateOnly_ = event.pressed;
    if (navigateOnly_) hovered_.reset();
    return true;
  }
  if (event.key == KeyboardKey::kV && !event.pressed) navigateOnly_ = false;
  if (!press_ || !press_->dragging) return false;
  if (event.key == KeyboardKey::kEscape && event.pressed) {
    cancel();
    return true;
  }
  if (event.modifiers.shift != press_->modifiers.shift) {
    press_->modifiers.shift = event.modifiers.shift;
    continueDrag(place);
  }
  const std::optional<Axis> axis = axisOf(event.key);
  if (!axis || !press_->tool) return false;
  // Ctrl+Z is none of the axes.
  const Modifiers& held = event.modifiers;
  if (event.pressed && (held.control || held.alt || held.super)) return false;
  if (event.pressed && !event.repeated) {
    press_->tool->cycle(*axis);
    continueDrag(place);
  }
  return true;
}

void ViewportTools::cancel() {
  if (press_ && press_->dragging) {
    if (press_->doing == Doing::kPoint || press_->doing == Doing::kUp) {
      session_.cancel();
    } else if (press_->doing == Doing::kTurn || press_->doing == Doing::kPan) {
      session_.setView(press_->view);
    }
  }
  press_.reset();
  note_.reset();
  navigateOnly_ = false;
}

// --- Drags ---

bool ViewportTools::wantsPan() const {
  return press_->button == PointerButton::kMiddle ||
         (press_->button == PointerButton::kLeft && press_->modifiers.control);
}

void ViewportTools::startDrag(const ViewportPlace& place) {
  const std::optional<HandleId> handle = press_->target.handle;
  const bool left = press_->button == PointerButton::kLeft;
  if (handle && isPoint(*handle) && (handle->kind != HandleKind::kPlane || left)) {
    startPoint(place, *handle);
  } else if (handle && handle->kind == HandleKind::kUp && left) {
    startUp();
  } else if (wantsPan()) {
    press_->doing = Doing::kPan;
  } else if (left && press_->modifiers.shift && !navigateOnly_) {
    press_->doing = Doing::kBox;
  } else if (left) {
    press_->doing = Doing::kTurn;
    // From the camera's place one turns the view that looks its way.
    press_->view = press_->from = session_.view();
  }
}

void ViewportTools::startPoint(const ViewportPlace& place, const HandleId& handle) {
  if (handle.kind == HandleKind::kKey) session_.execute(Command("make-current", handle.key));
  if (handle.kind == HandleKind::kAim) {
    session_.execute(Command("make-current", handle.key, handle.orientation));
  }
  const bool square = handle.kind == HandleKind::kPlane;
  const auto what =
      handle.kind == HandleKind::kAim ? PlaneDragTool::What::kAim : PlaneDragTool::What::kKey;
  const Axis plane = square ? handle.axis : planeOf(press_->button, press_->modifiers);
  press_->tool.emplace(session_.state(), what, place.view, press_->start, plane, square);
  press_->doing = Doing::kPoint;
  session_.begin(press_->tool->step());
}

void ViewportTools::startUp() {
  press_->doing = Doing::kUp;
  session_.begin(Text("step.turn-up", {session_.current().key + 1}));
}

void ViewportTools::continueDrag(const ViewportPlace& place) {
  switch (press_->doing) {
    case Doing::kNothing:
    case Doing::kBox:
      return;
    case Doing::kPoint:
      return movePoint(place);
    case Doing::kUp:
      return turnUp(place);
    case Doing::kTurn:
    case Doing::kPan:
      return navigate(place);
  }
}

void ViewportTools::movePoint(const ViewportPlace& place) {
  press_->tool->setSnap(press_->modifiers.shift ? std::optional(session_.display().gridStep)
                                                : std::nullopt);
  const auto flight = press_->tool->at(press_->pointer);
  if (!flight) return refuse(place, vides::textOf(flight.error()));
  note_.reset();
  if (!session_.preview(*flight)) refuse(place, session_.output().text);
}

void ViewportTools::turnUp(const ViewportPlace& place) {
  const EditState& start = session_.start();
  const Vec3 vpn = glm::normalize(aimOffset(start.key(), start.orientation()));
  const auto roll = rollTowards(place.view, start.key().position, vpn, press_->pointer);
  if (!roll) return refuse(place, textOf(roll.error()));
  double degrees = *roll * 180.0 / std::numbers::pi;
  if (press_->modifiers.shift) degrees = std::round(degrees / kRollStep) * kRollStep;
  // Full turns stay: the roll nearest to the one at the press.
  const double old = start.orientation().roll;
  Key key = start.key();
  Orientation& o = key.orientations[start.current().orientation];
  o.roll = old + std::remainder(degrees - old, 360.0);
  if (press_->modifiers.shift) o.roll = std::round(o.roll / kRollStep) * kRollStep;
  note_.reset();
  if (!session_.preview(withKey(start.flight, start.current().key, std::move(key)))) {
    refuse(place, session_.output().text);
  }
}

void ViewportTools::navigate(const ViewportPlace& place) {
  const Vec2 by = press_->pointer - press_->start;
  const ViewState& from = press_->from;
  if (press_->doing == Doing::kPan) {
    return setView(panned(from.view, place.view.pixels(), by));
  }
  const double rate = kDegreesPerPixel / place.contentScale;
  setView(turnedAbout(from.view, from.pivot, -rate * by.x, rate * by.y));
}

void ViewportTools::setView(const EditorView& view) {
  Command command("set-view", view.turn, view.tilt, view.size);
  command.add(view.target);
  session_.execute(command);
}

// --- Clicks ---

void ViewportTools::click(const ViewportPlace&) {
  if (press_->button != PointerButton::kLeft) return;
  const PointerTarget& target = press_->target;
  const bool shift = press_->modifiers.shift;
  if (target.handle && target.handle->kind == HandleKind::kKey) {
    const std::size_t key = target.handle->key;
    if (shift) {
      session_.execute(Command("toggle-select", key));
    } else if (session_.selected().size() > 1) {
      session_.execute(Command("select-keys", key));
    }
  } else if (!target.handle && target.curve) {
    const std::size_t piece = target.curve->piece;
    if (press_->modifiers.control) {
      session_.execute(Command("insert-key-at", piece, target.curve->fraction));
    } else if (shift) {
      session_.execute(Command("toggle-select", piece));
    } else {
      session_.execute(Command("select-key", piece));
    }
  }
}

void ViewportTools::selectBox(const ViewportPlace& place) {
  const PixelRectangle box = rectangleBetween(press_->start, press_->pointer);
  Command command("select-keys");
  std::size_t index = 0;
  session_.flight().keys.forEach([&](const Key& key) {
    const auto pixel = place.view.project(key.position);
    if (pixel && contains(box, *pixel)) command.add(index);
    ++index;
  });
  if (!command.arguments.empty()) session_.execute(command);
}

// --- What is shown ---

void ViewportTools::refuse(const ViewportPlace& place, Text why) {
  session_.say(MessageKind::kRefusal, why);
  note_ = PointerNote{std::move(why), press_->pointer, place.now + kNoteSeconds};
}

std::optional<DragDisplay> ViewportTools::drag() const {
  if (!press_ || !press_->dragging || !press_->tool) return std::nullopt;
  const auto point = press_->tool->pointAt(press_->pointer);
  if (!point) return std::nullopt;
  return DragDisplay{*point, press_->tool->constant()};
}

std::optional<OutputLine> ViewportTools::output() const {
  if (!press_ || !press_->dragging) return std::nullopt;
  if (press_->doing == Doing::kUp) {
    return OutputLine{MessageKind::kNumbers,
                      Text("output.drag-up", {session_.currentOrientation().roll})};
  }
  const std::optional<DragDisplay> shown = drag();
  if (!shown) return std::nullopt;
  return OutputLine{
      MessageKind::kNumbers,
      Text("output.drag-point", {press_->tool->way(), session_.pointText(shown->point)})};
}

std::optional<PixelRectangle> ViewportTools::box() const {
  if (!press_ || !press_->dragging || press_->doing != Doing::kBox) return std::nullopt;
  return rectangleBetween(press_->start, press_->pointer);
}

Text ViewportTools::hint() const {
  if (press_ || !hovered_) return {};
  switch (hovered_->kind) {
    case HandleKind::kKey:
    case HandleKind::kAim:
      return "hint.handle";
    case HandleKind::kUp:
      return "hint.up";
    case HandleKind::kPlane:
      return std::string("hint.plane.") + "xyz"[static_cast<int>(hovered_->axis)];
    case HandleKind::kSection:
      return {};
  }
  return {};
}

std::optional<PointerNote> ViewportTools::note(double now) const {
  return note_ && now < note_->until ? note_ : std::nullopt;
}

}  // namespace vides
