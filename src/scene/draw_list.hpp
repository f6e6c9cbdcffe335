// SPDX-License-Identifier: MIT
// What is to be drawn, as values: geometry in space or in pixels, how it looks, texts, and handles
// that can be picked. Knows no OpenGL; render/scene_renderer.hpp draws it.
//
// Pixels are those of math/view_projection.hpp: x right, y down. Widths, radii and offsets are in
// pixels of the picture: whoever makes the list multiplies by the content scale. Geometry is
// immutable and shared: the renderer keeps its copy on the GPU for as long as the object lives, so
// that a list made of the same objects uploads nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "math/plane_drag.hpp"
#include "math/view_projection.hpp"
#include "scene/colour.hpp"

namespace vides {

// `along` belongs to polylines: below 0 the line ends here, else it goes on to the next point, and
// the pattern of dashes has come so many pixels. Of a marker it is the share by which it is smaller
// than its style says: 0 whole, 1 nothing.
struct GeometryPoint {
  float x = 0.0f, y = 0.0f, z = 0.0f;
  float along = 0.0f;
  bool operator==(const GeometryPoint&) const = default;
};
inline constexpr float kLineEnds = -1.0f;

GeometryPoint geometryPoint(const Vec3& point, float along = 0.0f);
GeometryPoint geometryPoint(const Vec2& pixel, float along = 0.0f);

enum class Primitive : std::uint8_t {
  kPolylines,  // element i leads from point i + 1 to i + 2, if that line goes on; the first and the
               // last point only tell how the line comes in and goes out (see PolylineBuilder)
  kSegments,   // element i leads from point 2i to 2i + 1
  kMarkers,    // element i stands at point i
  kTriangles,  // element i has the corners 3i, 3i + 1, 3i + 2
};

struct Geometry {
  Primitive primitive = Primitive::kSegments;
  std::vector<GeometryPoint> points;

  std::size_t elements() const;
};
using SharedGeometry = std::shared_ptr<const Geometry>;

// Puts polylines one after the other into one geometry.
class PolylineBuilder {
 public:
  PolylineBuilder() { points_.push_back({0, 0, 0, kLineEnds}); }
  // The next point of the line that was begun.
  void add(const GeometryPoint& point) { points_.push_back(point); }
  // The line ends at the point added last.
  void end() { points_.back().along = kLineEnds; }
  // The number of the element that begins at the next point added.
  std::size_t next() const { return points_.size() - 1; }
  SharedGeometry finish();

 private:
  std::vector<GeometryPoint> points_;
};

// Antialiased, with round ends and joins. Dashes are `dashOn` pixels on and `dashOff` off, running
// through a whole polyline; on = 0: solid.
struct LineStyle {
  Colour colour;
  float width = 1.0f;
  float dashOn = 0.0f;
  float dashOff = 0.0f;
  bool operator==(const LineStyle&) const = default;
};

enum class MarkerShape : std::uint8_t { kDisc, kRing, kCross, kSquare, kPlus };

// A sign of fixed size at a place, moved by `offset` pixels.
struct MarkerStyle {
  MarkerShape shape = MarkerShape::kDisc;
  Colour colour;            // of the outline, or of all of a disc
  Colour fill = kNoColour;  // inside a ring or square
  float radius = 4.0f;      // from the middle to the outline's middle
  float width = 1.5f;       // of the outline
  Vec2 offset{0.0};
  bool operator==(const MarkerStyle&) const = default;
};

struct FillStyle {
  Colour colour;
  bool operator==(const FillStyle&) const = default;
};

enum class DrawSpace : std::uint8_t { kCube, kPixels };
enum class DrawDepth : std::uint8_t {
  kTested,  // hides, and is hidden by, what else is tested
  kOnTop,   // drawn after all that is tested, one over the other in the list's order
};

// Where geometry stands that was made in coordinates of its own.
struct Placement {
  Vec3 origin{0.0};
  double unit = 1.0;  // > 0
  Mat3 turn{1.0};     // before the unit and the origin
  Vec3 at(const Vec3& point) const { return origin + unit * (turn * point); }
  bool operator==(const Placement&) const = default;
};

inline constexpr std::size_t kAllElements = std::numeric_limits<std::size_t>::max();

struct DrawItem {
  SharedGeometry geometry;
  std::size_t first = 0;
  std::size_t count = kAllElements;  // clipped to what the geometry has
  std::variant<LineStyle, MarkerStyle, FillStyle> style;
  DrawSpace space = DrawSpace::kCube;
  Placement place;  // in the cube; pixels have none
  DrawDepth depth = DrawDepth::kTested;
  // How much of the ground's colour is mixed in at the far side of the cube, 0 to 1.
  float fade = 0.0f;
  // Among lines at the same place the one with the higher lift wins.
  int lift = 0;
};

// A text whose box has its upper left corner at a pixel; drawn by Dear ImGui after the rest.
struct DrawText {
  std::string text;
  Vec2 pixel{0.0};
  Colour colour;
  bool strong = false;  // one weight up
  bool haloed = false;  // has a rim of the ground's colour: something runs under it
};

enum class HandleKind : std::uint8_t {
  kKey,      // a key's cross
  kAim,      // the ring at the current orientation's aim, or that at the viewport's edge
  kUp,       // the VUP's tip
  kPlane,    // one of the three plane squares beside the current key
  kSection,  // a move's curve; found by CurveFlattener::nearest
};

struct HandleId {
  HandleKind kind = HandleKind::kKey;
  std::size_t key = 0;
  std::size_t orientation = 0;  // of kAim, kUp, kSection
  Axis axis = Axis::X;          // of kPlane: the coordinate that stays
  bool operator==(const HandleId&) const = default;
};

struct Handle {
  HandleId id;
  Vec2 pixel{0.0};
  double radius = 10.0;  // pixels: so far from it counts as on it
};

struct DrawList {
  ViewProjection view;  // its pixels are the rectangle that is drawn into
  // The ground, from the upper to the lower edge; what fades, fades to the mean of both.
  Colour groundTop, groundBottom;
  // What is filled with `bars` before, where it reaches beyond the view's rectangle: letterboxing.
  std::optional<PixelRectangle> outer;
  Colour bars;
  // Fading begins `depthRadius` units before the plane through this point that faces the viewer,
  // and is complete as far behind it.
  Vec3 depthTarget{0.0};
  double depthRadius = kCubeRadius;

  std::vector<DrawItem> items;
  std::vector<DrawText> texts;
  std::vector<Handle> handles;
};

}  // namespace vides
