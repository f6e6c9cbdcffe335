// SPDX-License-Identifier: MIT
// Small cameras along the flight, and a larger one at the playhead.
#include <algorithm>
#include <cmath>

#include "scene/viewport_parts.hpp"

namespace vides {
namespace {

constexpr double kPlayheadPixels = 34.0;

// A pyramid from the VRP to the picture's corners, whose edges are `size` long: wide for a short
// focal length, narrow for a long one.
void addPyramid(std::vector<GeometryPoint>& points, const Camera& camera, const Flight& flight,
                double size, bool withUp) {
  const Vec3& eye = camera.viewReferencePoint;
  const double tangent = std::tan(0.5 * flight.lens.horizontalFieldOfView(camera.zoom));
  const Vec3 right = glm::cross(camera.viewPlaneNormal, camera.viewUpVector) * tangent;
  const Vec3 up = camera.viewUpVector * (tangent * flight.picture.height / flight.picture.width);
  const Vec3 toCorner = camera.viewPlaneNormal + right + up;
  const double share = size / glm::length(toCorner);
  const auto corner = [&](double x, double y) {
    return eye + share * (camera.viewPlaneNormal + x * right + y * up);
  };
  const Vec3 corners[] = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
  const auto line = [&](const Vec3& a, const Vec3& b) {
    points.push_back(geometryPoint(a));
    points.push_back(geometryPoint(b));
  };
  for (int i = 0; i < 4; ++i) {
    line(eye, corners[i]);
    line(corners[i], corners[(i + 1) % 4]);
  }
  if (!withUp) return;
  // Which side is up: a roof on the picture's upper edge.
  const Vec3 roof = corner(0.0, 1.0) + share * 0.55 * glm::length(up) * camera.viewUpVector;
  line(corner(-0.45, 1.0), roof);
  line(roof, corner(0.45, 1.0));
}

// Whether two ghosts of this size lie over each other.
bool looksAlike(const Camera& a, const Camera& b, double size) {
  constexpr double kAway = 0.6;   // of the size
  constexpr double kTurn = 0.94;  // the cosine of 20 degrees
  return glm::distance(a.viewReferencePoint, b.viewReferencePoint) < kAway * size &&
         glm::dot(a.viewPlaneNormal, b.viewPlaneNormal) > kTurn;
}

double pixelsPerUnitAt(const ViewProjection& view, const Vec3& point) {
  if (!view.perspective()) return view.pixelsPerUnit();
  const double distance =
      view.mapping().projectionReferencePoint.z - view.mapping().viewPlaneDistance;
  return view.pixelsPerUnit() * distance / std::max(view.weight(point), 1e-3 * distance);
}

}  // namespace

void CamerasPart::add(const ViewportContext& context) {
  if (context.input.shown.ghosts && !context.cramped()) {
    findGhosts(context);
    DrawItem item;
    item.geometry = ghostGeometry_;
    item.style = LineStyle{context.colour(ColourRole::kGhost), context.pixels(1.0)};
    item.fade = 0.45f;
    item.lift = -1;
    context.list.items.push_back(item);
  }
  if (context.input.shown.playhead) addPlayhead(context);
}

void CamerasPart::findGhosts(const ViewportContext& context) {
  const Evaluation& evaluation = context.input.evaluation;
  std::int64_t every = std::max(1, context.input.shown.ghostEvery);
  while (evaluation.frameCount() / every >= kMostGhosts) every *= 2;
  const bool fresh = !evaluation.sameAs(evaluation_) || every != every_;
  if (fresh) {
    evaluation_ = evaluation;
    every_ = every;
    ghosts_.clear();
    for (std::int64_t n = 0; n < evaluation.frameCount(); n += every) {
      ghosts_.push_back(evaluation.frame(n).camera);
    }
  }
  // About the same size on screen in every view; in steps, so that not each change makes them anew.
  const double wanted =
      context.input.sizes.ghosts * context.scale() / context.view().pixelsPerUnit();
  const double size = std::exp2(std::round(2.0 * std::log2(wanted)) / 2.0);
  if (!fresh && ghostGeometry_ && size == ghostSize_) return;
  ghostSize_ = size;
  auto geometry = std::make_shared<Geometry>(Geometry{Primitive::kSegments, {}});
  // Those that would only blacken the one before are left out.
  const Camera* last = nullptr;
  for (const Camera& camera : ghosts_) {
    if (last != nullptr && looksAlike(*last, camera, size)) continue;
    addPyramid(geometry->points, camera, context.flight(), size, false);
    last = &camera;
  }
  ghostGeometry_ = std::move(geometry);
}

void CamerasPart::addPlayhead(const ViewportContext& context) {
  const ViewportState& state = context.input.state;
  const Camera camera =
      state.freeCamera ? *state.freeCamera : context.input.evaluation.frame(state.playhead).camera;
  const double size = kPlayheadPixels * context.scale() /
                      pixelsPerUnitAt(context.view(), camera.viewReferencePoint);
  std::vector<GeometryPoint> points;
  addPyramid(points, camera, context.flight(), size, true);
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    const auto from = context.view().project({points[i].x, points[i].y, points[i].z});
    const auto to = context.view().project({points[i + 1].x, points[i + 1].y, points[i + 1].z});
    if (from && to) context.labels.blockLine(*from, *to, kBlockedByLine);
  }
  DrawItem item;
  item.geometry = playhead_.keep(Primitive::kSegments, std::move(points));
  item.style = LineStyle{context.colour(ColourRole::kPlayhead), context.pixels(1.3)};
  item.lift = 4;
  context.list.items.push_back(item);
  item.geometry = dot_.keep(Primitive::kMarkers, {geometryPoint(camera.viewReferencePoint)});
  item.style = MarkerStyle{MarkerShape::kDisc, context.colour(ColourRole::kPlayhead), kNoColour,
                           context.pixels(2.6), context.pixels(1.0)};
  item.depth = DrawDepth::kOnTop;
  context.list.items.push_back(item);
}

}  // namespace vides
