// SPDX-License-Identifier: MIT
// The viewport as a list of things to draw and to pick (5-editor, "Viewport"): cube, scene, curve,
// crosses with their numbers, the current orientation's arrows, ghost cameras, what a drag shows.
//
// A pure function of its input but for what it keeps: geometry that did not change is handed out
// again as the same object, so that the renderer uploads only what did. Turning the view makes
// no new geometry of curve, scene and cube, as long as they are seen at about the same scale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/evaluation.hpp"
#include "math/view_projection.hpp"
#include "scene/draw_list.hpp"
#include "scene/scene_part.hpp"
#include "scene/theme.hpp"

namespace vides {

// Which elements are seen (Settings → shown elements).
struct ShownElements {
  bool cube = true;
  bool grid = false;  // on the cube's floor
  bool scene = true;
  bool sceneAsPoints = false;  // else as wireframe
  bool curve = true;
  bool keys = true;
  bool numbers = true;  // of the keys, from 1
  bool aim = true;      // the VPN arrow with its ring
  bool up = true;       // the VUP arrow
  bool upCircle = true;
  bool axes = true;  // the triad in the lower left corner
  bool ghosts = true;
  bool playhead = true;  // the playhead's camera
  bool planeSquares = true;
  bool tangents = false;  // at the current key, as handles of its two curve pieces
  int ghostEvery = 20;    // frames, at least 1; doubled until there are at most kMostGhosts
  bool operator==(const ShownElements&) const = default;
};

inline constexpr std::int64_t kMostGhosts = 250;

// How large elements are drawn: pixels at content scale 1 (Settings → sizes).
struct ElementSizes {
  double curve = 2.2;    // width of its line; the current section's grows with it
  double lines = 1.2;    // of the cube and the scene
  double handles = 7.0;  // radius of a key's cross; rings, squares and picking grow with it
  double ghosts = 15.0;  // length of a ghost camera
  bool operator==(const ElementSizes&) const = default;
};

// Steps of the reference grid, which is that of snapping.
inline constexpr double kGridStep = 0.05;

// What a drag shows. The flight in the input is already the dragged one.
struct DragDisplay {
  Vec3 point{0.0};               // the dragged point: axes run through it to the cube's faces
  std::optional<Axis> constant;  // the plane it moves in; nothing while it moves along one axis
  bool operator==(const DragDisplay&) const = default;
};

struct ViewportState {
  OrientationPlace current;           // must exist
  std::vector<std::size_t> selected;  // keys, ascending; the current one may be among them
  std::int64_t playhead = 0;          // frame
  std::optional<Camera> freeCamera;   // flown by hand: drawn instead of the playhead's
  std::optional<HandleId> hovered;    // a handle of the last list, one step larger
  // Of the hovered point: the outline of the plane that a left drag would use.
  bool showHoverPlane = true;
  std::optional<DragDisplay> drag;
  // What stands over the picture (its caption, sliders): labels keep away.
  std::vector<PixelRectangle> covered;
};

// The texts beside the current orientation's arrows, and the sizes of all texts (Dear ImGui draws
// them later) for placing them: pixels, content scale included.
struct ViewportText {
  std::string aim = "aim";
  std::string up = "VUP";
  double aimWidth = 24.0;
  double upWidth = 24.0;
  double digitWidth = 8.0;
  double letterWidth = 8.0;
  double lineHeight = 16.0;
};

// Pixels along the rectangle's edges that something else covers (sliders, say): labels and the
// triad keep away from them.
struct Margins {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

struct ViewportInput {
  Evaluation evaluation;
  std::vector<PlacedScene> scenes;
  EditorView view;
  PixelRectangle rectangle;
  double contentScale = 1.0;
  Margins margins;
  ViewportText text;
  ViewportState state;
  ShownElements shown;
  ElementSizes sizes;
  double gridStep = kGridStep;
  Theme theme = vides::theme(ThemeKind::kDark);
};

// A place on the curve near the pointer.
struct CurveHit {
  std::size_t piece = 0;   // from key `piece` to the next
  double parameter = 0.0;  // of the piece's cubic, 0 to 1
  double fraction = 0.0;   // of the piece's arc length, 0 to 1
  Vec3 point{0.0};
  double distance = 0.0;  // pixels from the pointer
};

class ViewportScene {
 public:
  ViewportScene();
  ~ViewportScene();
  ViewportScene(ViewportScene&&) noexcept;
  ViewportScene& operator=(ViewportScene&&) noexcept;

  // Valid until the next call.
  const DrawList& build(const ViewportInput& input);
  // The place of the curve as last built that is seen nearest to `pixel`, within `reach` pixels.
  std::optional<CurveHit> nearestOnCurve(const Vec2& pixel, double reach) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// The handle under the pointer: the nearest within its radius; of those at most 3 pixels (times the
// content scale) farther than the nearest, the current key's.
std::optional<HandleId> handleAt(const DrawList& list, const Vec2& pixel, std::size_t currentKey,
                                 double contentScale);

// How large signs are drawn in a picture of this size: the content scale, and less where the
// picture is so small that they would bury what they stand for.
double signScale(const PixelRectangle& picture, double contentScale);

// Where the VUP arrow of a camera ends: so far from the VRP that it would be kUpPixels long, times
// signScale(), if it lay across the view. The circle of the roll has that radius.
inline constexpr double kUpPixels = 46.0;
Vec3 upTip(const ViewProjection& view, const Camera& camera, double contentScale);

// Where the ring of an aim is drawn: at its projection, or, where that lies outside the rectangle,
// at the edge, on the way from the key (if that is inside; else from the middle) to the aim.
struct AimMark {
  Vec2 pixel{0.0};
  bool atEdge = false;
};
AimMark aimMark(const ViewProjection& view, const Vec3& key, const Vec3& aim, double contentScale);

}  // namespace vides
