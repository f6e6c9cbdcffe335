// SPDX-License-Identifier: MIT
// Flying the camera with pointer and keys in the camera view (5-editor, "Camera view").
//
// Left drag turns (what is seen follows the pointer), middle moves sideways, Shift + left rolls,
// the wheel dollies, Ctrl + wheel zooms, the right button held with W A S D Q E walks. Drags are
// computed from the camera at the press. Flying makes the session's free camera.
#pragma once

#include <array>
#include <optional>

#include "edit/session.hpp"
#include "input/input_event.hpp"
#include "math/view_projection.hpp"

namespace vides {

class CameraTools {
 public:
  static constexpr double kClickPixels = 3.0;
  static constexpr double kWalkPerSecond = 0.5;  // cube units

  explicit CameraTools(Session& session) : session_(session) {}

  // `view` is the camera's view as drawn, in its picture's rectangle.
  void press(const ViewProjection& view, PointerButton button, const Vec2& pixel,
             const Modifiers& modifiers);
  void move(const Vec2& pixel);
  void release(PointerButton button);
  void wheel(double steps, const Modifiers& modifiers);
  // True where the key walks: shortcuts must not have it then.
  bool key(const KeyChanged& event);
  // Walks for the time since the last display frame.
  void advance(double seconds);
  // Puts the camera back to where the drag began.
  void cancel();
  // Ends the drag where it is: the window lost the focus, or the picture its place.
  void stop();

  bool active() const { return press_.has_value(); }
  // Whether advance() would move the camera: another display frame is wanted.
  bool dragging() const { return walking() || (press_ && press_->dragging); }
  bool walking() const;

 private:
  struct Press {
    PointerButton button;
    bool rolls = false;
    Vec2 start{0.0};
    bool dragging = false;
    bool flown = false;  // dragged, walked or dollied since the press
    ViewProjection view;
    Camera camera;
    std::optional<Camera> before;  // the free camera at the press
  };
  void fly(const Camera& camera);
  double reach() const;  // the aim's distance: what a drag sideways keeps under the pointer

  Session& session_;
  std::optional<Press> press_;
  std::array<bool, 6> held_{};  // W A S D Q E
};

}  // namespace vides
