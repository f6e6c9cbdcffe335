// SPDX-License-Identifier: MIT
// A view of the cube on a rectangle of pixels: projects points, casts rays, tells how far a pixel
// reaches. Drawing, picking and dragging all go through it.
//
// Pixels: x right, y down, the rectangle's top left corner at (x, y); fractions count. World
// coordinates are those of the cube. See math/projection.hpp for the axes and clip coordinates.
#pragma once

#include <glm/mat3x2.hpp>
#include <glm/mat4x4.hpp>
#include <optional>
#include <tl/expected.hpp>

#include "math/projection.hpp"
#include "math/vector.hpp"

namespace vides {

struct PixelRectangle {
  double x = 0.0, y = 0.0;
  double width = 1.0, height = 1.0;  // > 0
  bool operator==(const PixelRectangle&) const = default;
};

struct Ray {
  Vec3 origin{0.0};
  Vec3 direction{0.0, 0.0, 1.0};  // unit, away from the viewer
};

class ViewProjection {
 public:
  // Rest view: from +z onto the cube's [-1, 1] x [-1, 1], into one pixel.
  ViewProjection();

  static tl::expected<ViewProjection, ViewMappingError> make(const Vec3& vrp, const Vec3& vpn,
                                                             const Vec3& vup,
                                                             const ViewMapping& mapping,
                                                             const PixelRectangle& pixels);

  // Where a point is seen, also outside the rectangle. Nothing where it doesn't lie in front of the
  // eye of a perspective.
  std::optional<Vec2> project(const Vec3& point) const;
  // Everything that is seen at this place.
  Ray ray(const Vec2& pixel) const;
  // d pixel / d point: pixels per unit along x, y, z. The point must lie in front of the eye.
  glm::dmat3x2 jacobian(const Vec3& point) const;
  // Distance from the eye's plane along the viewing direction in perspective, > 0 in front; 1 in a
  // parallel projection. The w of the clip coordinates.
  double weight(const Vec3& point) const;
  // Its derivative by x, y, z; zero in a parallel projection.
  Vec3 weightGradient() const;

  bool perspective() const { return mapping_.type == ProjectionType::Perspective; }
  const ViewAxes& axes() const { return axes_; }
  Vec3 viewingDirection() const { return -axes_.n; }
  // The eye of a perspective; a point on the way to it in a parallel projection.
  Vec3 referencePoint() const;
  // Pixels per unit across the view plane, vertically.
  double pixelsPerUnit() const;
  const PixelRectangle& pixels() const { return pixels_; }
  const ViewMapping& mapping() const { return mapping_; }
  // World to VRC, VRC to clip, and both.
  const glm::dmat4& orientationMatrix() const { return orientation_; }
  const glm::dmat4& mappingMatrix() const { return projection_; }
  const glm::dmat4& matrix() const { return matrix_; }

 private:
  ViewProjection(const Vec3& vrp, const ViewAxes& axes, const ViewMapping& mapping,
                 const glm::dmat4& projection, const PixelRectangle& pixels);

  Vec3 toWorld(const Vec3& vrc) const;

  Vec3 vrp_;
  ViewAxes axes_;
  ViewMapping mapping_;
  PixelRectangle pixels_;
  glm::dmat4 orientation_, projection_, matrix_;
};

// The editor's view of the cube: what its three sliders and the mouse set.
struct EditorView {
  double turn = 32.0;  // degrees: azimuth of the viewer from +z towards +x
  double tilt = 22.0;  // degrees: elevation of the viewer, -90 to 90
  double size = 1.0;   // 1: the sphere around the cube just fits the rectangle's smaller side; > 0
  Vec3 target{0.0};    // seen in the middle
  ProjectionType type = ProjectionType::Parallel;
  bool operator==(const EditorView&) const = default;
};

// Of the editor's perspective, top to bottom, in degrees.
inline constexpr double kEditorFieldOfView = 30.0;
// The sphere around the cube [-1, 1]^3: sqrt 3.
inline constexpr double kCubeRadius = 1.7320508075688772;

// A rectangle narrower or lower than a pixel counts as a pixel. In perspective the eye stands so
// far away that at size 1 the sphere touches the edges of the smaller side, and `size` times
// nearer.
ViewProjection viewProjection(const EditorView& view, const PixelRectangle& pixels);

// What a camera at `vrp` sees. `verticalFieldOfView` in radians, in (0, pi).
ViewProjection viewProjection(const Vec3& vrp, const Vec3& vpn, const Vec3& vup,
                              double verticalFieldOfView, const PixelRectangle& pixels);

}  // namespace vides
