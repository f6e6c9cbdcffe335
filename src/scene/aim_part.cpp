// SPDX-License-Identifier: MIT
// The current orientation: VPN arrow to the aim's ring, VUP arrow, the VUP's circle.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/viewport_parts.hpp"

namespace vides {
namespace {

constexpr double kRingRadius = 5.0, kHoverStep = 1.5;
constexpr double kEdgeInset = 12.0;
constexpr int kCirclePoints = 72;

MarkerStyle ring(const ViewportContext& context, ColourRole role, bool hovered) {
  return {MarkerShape::kRing, context.colour(role), context.colour(ColourRole::kHandleFill),
          context.handlePixels(kRingRadius + (hovered ? kHoverStep : 0.0)),
          context.handlePixels(2.2)};
}

void addLine(const ViewportContext& context, GeometrySlot& slot, const Vec3& from, const Vec3& to,
             ColourRole role) {
  DrawItem item;
  item.geometry = slot.keep(Primitive::kSegments, {geometryPoint(from), geometryPoint(to)});
  item.style = LineStyle{context.colour(role), context.handlePixels(2.4)};
  item.depth = context.depthOfCurrent();
  item.lift = 3;
  context.list.items.push_back(item);
}

void addRing(const ViewportContext& context, GeometrySlot& slot, const Vec3& at,
             const MarkerStyle& style) {
  DrawItem item;
  item.geometry = slot.keep(Primitive::kMarkers, {geometryPoint(at)});
  item.style = style;
  item.depth = DrawDepth::kOnTop;
  context.list.items.push_back(item);
}

void blockRing(const ViewportContext& context, const Vec2& pixel) {
  const Vec2 half{6.0 * context.handleScale()};
  context.labels.blockBox(pixel - half, pixel + half, kBlockedByMark);
}

void addLabel(const ViewportContext& context, const std::string& text, double width,
              const Vec2& anchor, ColourRole role) {
  const Vec2 size{width, context.input.text.lineHeight};
  const auto place = context.labels.place(anchor, 13.0 * context.handleScale(), size, true);
  if (!place) return;
  context.addLabel({text, place->corner, context.colour(role)}, *place, anchor, size, true);
}

// Where the way from `from`, inside, along `way` leaves the rectangle.
Vec2 leaves(const Vec2& low, const Vec2& high, const Vec2& from, const Vec2& way) {
  double share = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    if (way[i] > 0.0) share = std::min(share, (high[i] - from[i]) / way[i]);
    if (way[i] < 0.0) share = std::min(share, (low[i] - from[i]) / way[i]);
  }
  return std::isfinite(share) ? from + share * way : from;
}

bool inside(const Vec2& low, const Vec2& high, const Vec2& p) {
  return p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y;
}

}  // namespace

Vec3 upTip(const ViewProjection& view, const Camera& camera, double contentScale) {
  const double pixelsPerUnit =
      view.pixelsPerUnit() *
      (view.perspective()
           ? (view.mapping().projectionReferencePoint.z - view.mapping().viewPlaneDistance) /
                 std::max(view.weight(camera.viewReferencePoint), 1e-6)
           : 1.0);
  const double pixels = kUpPixels * signScale(view.pixels(), contentScale);
  return camera.viewReferencePoint + pixels / pixelsPerUnit * camera.viewUpVector;
}

AimMark aimMark(const ViewProjection& view, const Vec3& key, const Vec3& aim, double contentScale) {
  const PixelRectangle& r = view.pixels();
  const auto pixel = view.project(aim);
  const Vec2 low{r.x, r.y}, high{r.x + r.width, r.y + r.height};
  if (pixel && inside(low, high, *pixel)) return {*pixel, false};
  return {edgePlace(view, aim, key, kEdgeInset * signScale(r, contentScale)), true};
}

Vec2 edgePlace(const ViewProjection& view, const Vec3& point, const std::optional<Vec3>& seenFrom,
               double edge) {
  const PixelRectangle& r = view.pixels();
  const auto pixel = view.project(point);
  const Vec2 low{r.x, r.y}, high{r.x + r.width, r.y + r.height};
  const Vec2 inset{std::min(edge, 0.25 * std::min(r.width, r.height))};
  Vec2 from = 0.5 * (low + high);
  const auto start = seenFrom ? view.project(*seenFrom) : std::nullopt;
  if (start && inside(low + inset, high - inset, *start)) from = *start;
  Vec2 way{0.0};
  if (pixel) {
    way = *pixel - from;
  } else {
    // Behind the viewer of a perspective the way is that in which the arrow leaves the picture.
    const glm::dvec4 clip = view.matrix() * glm::dvec4(point, 1.0);
    const Vec2 middle = 0.5 * (low + high);
    const Vec2 mirrored{middle.x + 0.5 * r.width * clip.x, middle.y - 0.5 * r.height * clip.y};
    way = mirrored - middle - clip.w * (from - middle);
  }
  return leaves(low + inset, high - inset, from, way);
}

void AimPart::add(const ViewportContext& context) {
  const OrientationPlace place = context.input.state.current;
  const auto& keys = context.flight().keys;
  if (place.key >= keys.size() || place.orientation >= keys[place.key].orientations.size()) return;
  const Key& key = keys[place.key];
  if (context.input.shown.up || context.input.shown.upCircle) {
    addUp(context, context.input.evaluation.cameraAt(place));
  }
  if (context.input.shown.aim) {
    addAim(context, key.position, aimPoint(key, key.orientations[place.orientation]));
  }
}

void AimPart::addAim(const ViewportContext& context, const Vec3& key, const Vec3& aim) {
  const OrientationPlace place = context.input.state.current;
  const HandleId id{HandleKind::kAim, place.key, place.orientation, Axis::X};
  const MarkerStyle style = ring(context, ColourRole::kAim, context.hovered(id));
  addLine(context, aimLine_, key, aim, ColourRole::kAim);
  addRing(context, aimRing_, aim, style);

  const AimMark mark = aimMark(context.view(), key, aim, context.input.contentScale);
  if (mark.atEdge) {
    DrawItem item;
    item.geometry = edgeRing_.keep(Primitive::kMarkers, {geometryPoint(mark.pixel)});
    item.style = style;
    item.space = DrawSpace::kPixels;
    item.depth = DrawDepth::kOnTop;
    context.list.items.push_back(item);
  }
  context.list.handles.push_back({id, mark.pixel, context.reach(10.0)});
  const auto keyPixel = context.view().project(key);
  if (keyPixel) context.labels.blockLine(*keyPixel, mark.pixel, kBlockedByLine);
  blockRing(context, mark.pixel);
  addLabel(context, context.input.text.aim, context.input.text.aimWidth, mark.pixel,
           ColourRole::kAim);
}

void AimPart::addUp(const ViewportContext& context, const Camera& camera) {
  const OrientationPlace place = context.input.state.current;
  const Vec3& key = camera.viewReferencePoint;
  const auto keyPixel = context.view().project(key);
  if (!keyPixel) return;
  const Vec3 tip = upTip(context.view(), camera, context.input.contentScale);
  if (context.input.shown.upCircle) addCircle(context, camera, tip);
  const auto pixel = context.view().project(tip);
  if (!context.input.shown.up || !pixel) return;
  const HandleId id{HandleKind::kUp, place.key, place.orientation, Axis::X};
  addLine(context, upLine_, key, tip, ColourRole::kUp);
  addRing(context, upRing_, tip, ring(context, ColourRole::kUp, context.hovered(id)));
  if (!context.sees(*pixel, 0.0)) return;
  context.list.handles.push_back({id, *pixel, context.reach(10.0)});
  context.labels.blockLine(*keyPixel, *pixel, kBlockedByLine);
  blockRing(context, *pixel);
  addLabel(context, context.input.text.up, context.input.text.upWidth, *pixel, ColourRole::kUp);
}

void AimPart::addCircle(const ViewportContext& context, const Camera& camera, const Vec3& tip) {
  const Vec3 up = tip - camera.viewReferencePoint;
  const Vec3 right = glm::cross(camera.viewPlaneNormal, up);
  std::vector<GeometryPoint> points;
  double along = 0.0;
  std::optional<Vec2> before;
  // One point more at either end, so that the seam is a join as any other.
  for (int i = -1; i <= kCirclePoints + 1; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCirclePoints;
    const Vec3 p = camera.viewReferencePoint + std::cos(angle) * up + std::sin(angle) * right;
    const auto pixel = context.view().project(p);
    if (i > 0 && before && pixel) {
      along += glm::distance(*before, *pixel);
      context.labels.blockLine(*before, *pixel, kBlockedByLine);
    }
    before = pixel;
    points.push_back(geometryPoint(p, static_cast<float>(along)));
  }
  DrawItem item;
  item.geometry = circle_.keep(Primitive::kPolylines, std::move(points));
  // A whole number of dashes, so that the seam does not show.
  const double pattern = 7.0 * context.scale();
  const double dashes = std::max(1.0, std::round(along / pattern));
  const auto dash = static_cast<float>(std::max(along, 1.0) / dashes / 2.0);
  item.style = LineStyle{context.colour(ColourRole::kUp), context.pixels(1.2), dash, dash};
  item.depth = context.depthOfCurrent();
  item.fade = 0.3f;
  context.list.items.push_back(item);
}

}  // namespace vides
