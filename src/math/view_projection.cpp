// SPDX-License-Identifier: MIT
// Projects points and casts rays; sets up the editor's and the camera's view.
#include "math/view_projection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vides {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
// How far before and behind the target (in front of the eye) the editor sees, in cube units.
constexpr double kReach = 64.0;
// The front plane of a perspective, as a part of the distance to the target …
constexpr double kFrontShare = 1.0 / 128.0;
// … and of a camera, in cube units.
constexpr double kCameraFront = 1.0 / 1024.0;

// Sine and cosine of degrees, exact at right angles: a view from the front shows edges upright.
struct SinCos {
  double sin, cos;
};
SinCos sinCosOfDegrees(double degrees) {
  int quadrant = 0;
  const double rest = std::remquo(degrees, 90.0, &quadrant) * kDegree;
  const double s = std::sin(rest), c = std::cos(rest);
  switch (quadrant & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

PixelRectangle atLeastAPixel(PixelRectangle pixels) {
  pixels.width = std::max(pixels.width, 1.0);
  pixels.height = std::max(pixels.height, 1.0);
  return pixels;
}

ViewWindow centeredWindow(double halfWidth, double halfHeight) {
  return {-halfWidth, halfWidth, -halfHeight, halfHeight};
}

Vec3 row(const glm::dmat4& m, int i) { return {m[0][i], m[1][i], m[2][i]}; }

}  // namespace

ViewProjection::ViewProjection()
    : ViewProjection(*make({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, {}, {})) {}

ViewProjection::ViewProjection(const Vec3& vrp, const ViewAxes& axes, const ViewMapping& mapping,
                               const glm::dmat4& projection, const PixelRectangle& pixels)
    : vrp_(vrp),
      axes_(axes),
      mapping_(mapping),
      pixels_(pixels),
      orientation_(viewOrientation(vrp, axes)),
      projection_(projection),
      matrix_(projection * orientation_) {}

tl::expected<ViewProjection, ViewMappingError> ViewProjection::make(const Vec3& vrp,
                                                                    const Vec3& vpn,
                                                                    const Vec3& vup,
                                                                    const ViewMapping& mapping,
                                                                    const PixelRectangle& pixels) {
  return viewMapping(mapping).map([&](const glm::dmat4& projection) {
    return ViewProjection(vrp, viewAxes(vpn, vup), mapping, projection, pixels);
  });
}

std::optional<Vec2> ViewProjection::project(const Vec3& point) const {
  const glm::dvec4 clip = matrix_ * glm::dvec4(point, 1.0);
  if (!(clip.w > 0.0)) return std::nullopt;
  return Vec2{pixels_.x + 0.5 * pixels_.width * (1.0 + clip.x / clip.w),
              pixels_.y + 0.5 * pixels_.height * (1.0 - clip.y / clip.w)};
}

Ray ViewProjection::ray(const Vec2& pixel) const {
  const ViewWindow& window = mapping_.window;
  const double shareU = (pixel.x - pixels_.x) / pixels_.width;
  const double shareV = (pixel.y - pixels_.y) / pixels_.height;
  const Vec3 onPlane{window.uMin + shareU * (window.uMax - window.uMin),
                     window.vMax - shareV * (window.vMax - window.vMin),
                     mapping_.viewPlaneDistance};
  const Vec3& prp = mapping_.projectionReferencePoint;
  Vec3 along = onPlane - prp;
  if (!perspective()) along = Vec3{window.center(), mapping_.viewPlaneDistance} - prp;
  if (along.z > 0.0) along = -along;  // away from the viewer, whatever side the PRP is on
  const Vec3 direction = along.x * axes_.u + along.y * axes_.v + along.z * axes_.n;
  return {toWorld(perspective() ? prp : onPlane), glm::normalize(direction)};
}

glm::dmat3x2 ViewProjection::jacobian(const Vec3& point) const {
  const glm::dvec4 clip = matrix_ * glm::dvec4(point, 1.0);
  const Vec3 w = row(matrix_, 3);
  const Vec3 x = (row(matrix_, 0) - clip.x / clip.w * w) * (0.5 * pixels_.width / clip.w);
  const Vec3 y = (row(matrix_, 1) - clip.y / clip.w * w) * (-0.5 * pixels_.height / clip.w);
  return {Vec2{x.x, y.x}, Vec2{x.y, y.y}, Vec2{x.z, y.z}};
}

double ViewProjection::weight(const Vec3& point) const {
  return (matrix_ * glm::dvec4(point, 1.0)).w;
}

Vec3 ViewProjection::weightGradient() const { return row(matrix_, 3); }

Vec3 ViewProjection::referencePoint() const { return toWorld(mapping_.projectionReferencePoint); }

double ViewProjection::pixelsPerUnit() const {
  return pixels_.height / (mapping_.window.vMax - mapping_.window.vMin);
}

Vec3 ViewProjection::toWorld(const Vec3& vrc) const {
  return vrp_ + vrc.x * axes_.u + vrc.y * axes_.v + vrc.z * axes_.n;
}

ViewProjection viewProjection(const EditorView& view, const PixelRectangle& rectangle) {
  const PixelRectangle pixels = atLeastAPixel(rectangle);
  const SinCos turn = sinCosOfDegrees(view.turn), tilt = sinCosOfDegrees(view.tilt);
  const Vec3 toViewer{turn.sin * tilt.cos, tilt.sin, turn.cos * tilt.cos};
  // Up is where the viewer would rise to: it has a direction at the poles too.
  const Vec3 up{-turn.sin * tilt.sin, tilt.cos, -turn.cos * tilt.sin};
  const double smaller = std::min(pixels.width, pixels.height);

  ViewMapping mapping;
  mapping.type = view.type;
  if (view.type == ProjectionType::Parallel) {
    const double unitsPerPixel = 2.0 * kCubeRadius / (view.size * smaller);
    mapping.window =
        centeredWindow(0.5 * unitsPerPixel * pixels.width, 0.5 * unitsPerPixel * pixels.height);
    mapping.projectionReferencePoint = {0.0, 0.0, kReach};
    mapping.frontPlaneDistance = kReach;
  } else {
    const double tangent = std::tan(0.5 * kEditorFieldOfView * kDegree);
    const double smallerTangent = tangent * smaller / pixels.height;
    const double distance = kCubeRadius / std::sin(std::atan(smallerTangent)) / view.size;
    mapping.window =
        centeredWindow(distance * tangent * pixels.width / pixels.height, distance * tangent);
    mapping.projectionReferencePoint = {0.0, 0.0, distance};
    mapping.frontPlaneDistance = distance * (1.0 - kFrontShare);
  }
  mapping.backPlaneDistance = -kReach;
  return *ViewProjection::make(view.target, -toViewer, up, mapping, pixels);
}

ViewProjection viewProjection(const Vec3& vrp, const Vec3& vpn, const Vec3& vup,
                              double verticalFieldOfView, const PixelRectangle& rectangle) {
  const PixelRectangle pixels = atLeastAPixel(rectangle);
  const double tangent = std::tan(0.5 * verticalFieldOfView);
  ViewMapping mapping;
  mapping.type = ProjectionType::Perspective;
  mapping.window = centeredWindow(tangent * pixels.width / pixels.height, tangent);
  mapping.projectionReferencePoint = {0.0, 0.0, 0.0};
  mapping.viewPlaneDistance = -1.0;
  mapping.frontPlaneDistance = -kCameraFront;
  mapping.backPlaneDistance = -kReach;
  return *ViewProjection::make(vrp, vpn, vup, mapping, pixels);
}

}  // namespace vides
