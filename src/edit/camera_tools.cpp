// SPDX-License-Identifier: MIT
// Flying the camera.
#include "edit/camera_tools.hpp"

#include <algorithm>
#include <cmath>

#include "edit/free_camera.hpp"

namespace vides {
namespace {

constexpr double kDollyShare = 0.1;  // of the way to the aim, a step
constexpr double kZoomStep = 2.0;
constexpr double kLeastReach = 0.1;

std::optional<std::size_t> walkKey(KeyboardKey key) {
  constexpr std::array kKeys = {KeyboardKey::kW, KeyboardKey::kA, KeyboardKey::kS,
                                KeyboardKey::kD, KeyboardKey::kQ, KeyboardKey::kE};
  const auto found = std::find(kKeys.begin(), kKeys.end(), key);
  if (found == kKeys.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kKeys.begin());
}

Vec2 middleOf(const PixelRectangle& r) { return {r.x + 0.5 * r.width, r.y + 0.5 * r.height}; }

// So many pixels are a radian in the middle of the picture.
double focalPixels(const ViewProjection& view) { return view.pixelsPerUnit(); }

}  // namespace

void CameraTools::fly(const Camera& camera) {
  Command command("set-free-view");
  command.add(camera.viewReferencePoint);
  command.add(camera.viewPlaneNormal);
  command.add(camera.viewUpVector);
  command.add(camera.zoom);
  session_.execute(command);
  if (press_) press_->flown = true;
}

double CameraTools::reach() const {
  const Vec3 aim = aimPoint(session_.currentKey(), session_.currentOrientation());
  return std::max(glm::length(aim - session_.camera().viewReferencePoint), kLeastReach);
}

void CameraTools::press(const ViewProjection& view, PointerButton button, const Vec2& pixel,
                        const Modifiers& modifiers) {
  if (press_) return;
  const bool rolls = button == PointerButton::kLeft && modifiers.shift;
  press_ =
      Press{button, rolls, pixel, false, false, view, session_.camera(), session_.freeCamera()};
}

void CameraTools::move(const Vec2& pixel) {
  if (!press_) return;
  if (!press_->dragging && glm::length(pixel - press_->start) < kClickPixels) return;
  press_->dragging = true;
  const Vec2 by = pixel - press_->start;
  const double focal = focalPixels(press_->view);
  if (press_->rolls) {
    const Vec2 middle = middleOf(press_->view.pixels());
    const Vec2 from = press_->start - middle, to = pixel - middle;
    // Clockwise on the screen the picture turns, so the camera turns the other way.
    const double angle = std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
    fly(rolledCamera(press_->camera, -angle));
  } else if (press_->button == PointerButton::kMiddle) {
    const double perPixel = reach() / focal;
    fly(movedCamera(press_->camera, -by.x * perPixel, by.y * perPixel, 0.0));
  } else {
    fly(turnedCamera(press_->camera, by.x / focal, -by.y / focal));
  }
}

void CameraTools::release(PointerButton button) {
  if (press_ && press_->button == button) stop();
}

void CameraTools::wheel(double steps, const Modifiers& modifiers) {
  if (press_ && press_->button != PointerButton::kRight) return;
  const Camera camera = session_.camera();
  if (modifiers.control) {
    fly(zoomedCamera(camera, steps * kZoomStep));
  } else {
    // Each step a tenth of what is left, so that one never flies through the aim.
    const double ahead = reach() * (1.0 - std::pow(1.0 - kDollyShare, steps));
    fly(movedCamera(camera, 0.0, 0.0, ahead));
  }
  if (!press_) return;
  // A turn goes on from here.
  press_->camera.viewReferencePoint = session_.camera().viewReferencePoint;
  press_->camera.zoom = session_.camera().zoom;
}

bool CameraTools::key(const KeyChanged& event) {
  const std::optional<std::size_t> walk = walkKey(event.key);
  const Modifiers& held = event.modifiers;
  if (event.pressed && event.key == KeyboardKey::kEscape && press_) {
    cancel();
    return true;
  }
  if (!walk || !press_ || press_->button != PointerButton::kRight) return false;
  // Ctrl + S saves, here as elsewhere.
  if (event.pressed && (held.control || held.alt || held.super)) return false;
  held_[*walk] = event.pressed;
  return true;
}

bool CameraTools::walking() const {
  return press_ && press_->button == PointerButton::kRight &&
         std::any_of(held_.begin(), held_.end(), [](bool held) { return held; });
}

void CameraTools::advance(double seconds) {
  if (!walking()) return;
  const auto way = [&](std::size_t forward, std::size_t back) {
    return (held_[forward] ? 1.0 : 0.0) - (held_[back] ? 1.0 : 0.0);
  };
  const double step = kWalkPerSecond * seconds;
  const double ahead = step * way(0, 2), right = step * way(3, 1), up = step * way(5, 4);
  fly(movedCamera(session_.camera(), right, up, ahead));
  // A turn goes on from where one has walked to.
  press_->camera.viewReferencePoint = session_.camera().viewReferencePoint;
}

void CameraTools::cancel() {
  if (press_ && press_->flown) {
    if (press_->before) {
      fly(*press_->before);
    } else if (session_.freeCamera()) {
      session_.execute(Command("leave-view"));
    }
  }
  stop();
}

void CameraTools::stop() {
  press_.reset();
  held_.fill(false);
}

}  // namespace vides
