// SPDX-License-Identifier: MIT
// How the viewport looks at the cube, and the ways to change that.
//
// The view changes at once here; gliding there is the editor's matter.
#pragma once

#include <optional>
#include <string_view>

#include "math/view_projection.hpp"

namespace vides {

inline constexpr double kMinViewSize = 0.25;
inline constexpr double kMaxViewSize = 20.0;
// Cube coordinates of what is looked at, and from where the camera flies: as far as aims go.
inline constexpr double kFarthestPlace = 1e6;
Vec3 withinReach(Vec3 place);

struct ViewState {
  EditorView view;
  Vec3 pivot{0.0};             // what turning and tilting goes about: the framed selection
  bool swapped = false;        // camera view and viewport have changed places
  bool throughCamera = false;  // … until a named view is asked for; only with `swapped`
  bool operator==(const ViewState&) const = default;
};

// "iso", "front", "side", "top", as turn and tilt; nothing for other names.
struct NamedView {
  double turn = 0.0;
  double tilt = 0.0;
};
std::optional<NamedView> namedView(std::string_view name);

// Turn into [-180, 180], tilt into [-90, 90], size into its range.
EditorView limited(EditorView view);

// Turns and tilts by degrees so that `pivot` stays where it is seen.
EditorView turnedAbout(const EditorView& view, const Vec3& pivot, double turnBy, double tiltBy);
EditorView turnedTo(const EditorView& view, const Vec3& pivot, double turn, double tilt);
// From the opposite side.
EditorView opposite(const EditorView& view, const Vec3& pivot);
// Moves what is seen by a way in pixels.
EditorView panned(const EditorView& view, const PixelRectangle& pixels, const Vec2& by);
// `steps` of the wheel (positive: larger), so that what lies in the plane through the view's target
// under the pointer stays there.
EditorView sizedTowards(const EditorView& view, const PixelRectangle& pixels, const Vec2& pointer,
                        double steps);
// A sphere around these points fills the view; the turn and tilt stay. A single point is shown at
// twice the size, at least.
EditorView framed(const EditorView& view, const Vec3& low, const Vec3& high);

}  // namespace vides
