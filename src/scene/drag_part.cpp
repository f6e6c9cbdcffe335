// SPDX-License-Identifier: MIT
// Plane and axes of a drag, the squares that stand for planes, and the triad in the corner.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "scene/viewport_parts.hpp"

namespace vides {
namespace {

constexpr double kSquareAway = 16.0, kSquareSide = 9.0;
constexpr double kTriadAway = 58.0, kTriadArm = 30.0;
constexpr std::array<Axis, 3> kAxes{Axis::X, Axis::Y, Axis::Z};

Vec3 unit(int axis) {
  Vec3 result{0.0};
  result[axis] = 1.0;
  return result;
}

// The axes that may move in a plane.
std::array<int, 2> freeAxes(Axis constant) {
  const int c = static_cast<int>(constant);
  return {(c + 1) % 3, (c + 2) % 3};
}

Vec2 normalized(const Vec2& v) {
  const double length = glm::length(v);
  return length > 1e-9 ? v / length : Vec2{0.0};
}

// Nothing where it isn't drawn.
std::optional<Vec2> triadOrigin(const ViewportContext& context) {
  const PixelRectangle& r = context.view().pixels();
  const Margins& margins = context.input.margins;
  const double away = kTriadAway * context.scale();
  if (!context.input.shown.axes || context.cramped() || r.width < 4.0 * away ||
      r.height < 4.0 * away)
    return {};
  return Vec2{std::round(r.x + margins.left + away),
              std::round(r.y + r.height - margins.bottom - away)};
}

}  // namespace

// Of the current drag; without one, of the plane that a press on the hovered handle would use.
void DragPart::addPlanes(const ViewportContext& context) {
  const ViewportState& state = context.input.state;
  const auto& keys = context.flight().keys;
  if (state.drag) {
    if (state.drag->constant) addPlane(context, *state.drag->constant, state.drag->point);
    addCursor(context, state.drag->point);
    return;
  }
  if (!state.hovered || !state.showHoverPlane || state.hovered->key >= keys.size()) return;
  const HandleId& id = *state.hovered;
  const Key& key = keys[id.key];
  if (id.kind == HandleKind::kKey) {
    addPlane(context, Axis::X, key.position);
  } else if (id.kind == HandleKind::kPlane) {
    addPlane(context, id.axis, key.position);
  } else if (id.kind == HandleKind::kAim && id.orientation < key.orientations.size()) {
    addPlane(context, Axis::X, aimPoint(key, key.orientations[id.orientation]));
  }
}

void DragPart::addPlane(const ViewportContext& context, Axis constant, const Vec3& point) {
  const auto [u, v] = freeAxes(constant);
  Vec3 corners[4];
  for (int i = 0; i < 4; ++i) {
    corners[i] = unit(static_cast<int>(constant)) * point[static_cast<int>(constant)];
    corners[i] += unit(u) * (i == 1 || i == 2 ? 1.0 : -1.0) + unit(v) * (i >= 2 ? 1.0 : -1.0);
  }
  std::vector<GeometryPoint> lines, triangles;
  for (int i = 0; i < 4; ++i) {
    lines.push_back(geometryPoint(corners[i]));
    lines.push_back(geometryPoint(corners[(i + 1) % 4]));
  }
  for (const int i : {0, 1, 2, 0, 2, 3}) triangles.push_back(geometryPoint(corners[i]));
  const Colour colour = context.colour(roleOf(constant));
  DrawItem item;
  item.geometry = fill_.keep(Primitive::kTriangles, std::move(triangles));
  item.style = FillStyle{faded(colour, 0.07)};
  item.depth = DrawDepth::kOnTop;
  context.list.items.push_back(item);
  item.geometry = outline_.keep(Primitive::kSegments, std::move(lines));
  item.style = LineStyle{faded(colour, 0.9), context.pixels(1.4)};
  item.depth = DrawDepth::kTested;
  item.lift = 2;
  context.list.items.push_back(item);
}

// Three axes through the point to the cube's faces; to the point itself where that is outside.
void DragPart::addCursor(const ViewportContext& context, const Vec3& point) {
  for (const Axis axis : kAxes) {
    const int a = static_cast<int>(axis);
    Vec3 from = point, to = point;
    from[a] = std::min(-1.0, point[a]);
    to[a] = std::max(1.0, point[a]);
    DrawItem item;
    item.geometry = axes_[static_cast<std::size_t>(a)].keep(
        Primitive::kSegments, {geometryPoint(from), geometryPoint(to)});
    item.style = LineStyle{context.colour(roleOf(axis)), context.pixels(1.2)};
    item.lift = 3;
    context.list.items.push_back(item);
  }
}

// Three squares around the current key, each lying in its plane as it is seen. Of the eight ways to
// choose the sides of the axes, the one in which the squares are farthest apart.
void DragPart::addSquares(const ViewportContext& context) {
  const ViewportInput& input = context.input;
  if (!input.shown.planeSquares || !input.shown.keys || input.state.drag) return;
  if (context.cramped()) return;
  const Vec3& key = context.flight().keys[input.state.current.key].position;
  const auto middle = context.view().project(key);
  if (!middle || !context.sees(*middle, 0.0)) return;
  const glm::dmat3x2 jacobian = context.view().jacobian(key);

  std::array<Vec2, 3> best{};
  double farthest = -1.0;
  for (int signs = 0; signs < 8; ++signs) {
    std::array<Vec2, 3> ways;
    for (const Axis axis : kAxes) {
      const auto [u, v] = freeAxes(axis);
      const double su = (signs >> u & 1) != 0 ? 1.0 : -1.0, sv = (signs >> v & 1) != 0 ? 1.0 : -1.0;
      ways[static_cast<std::size_t>(axis)] =
          normalized(su * normalized(jacobian[u]) + sv * normalized(jacobian[v]));
    }
    const double apart = std::min({glm::distance(ways[0], ways[1]), glm::distance(ways[1], ways[2]),
                                   glm::distance(ways[2], ways[0])});
    if (apart > farthest + 1e-9) farthest = apart, best = ways;
  }

  for (const Axis axis : kAxes) {
    const auto index = static_cast<std::size_t>(axis);
    const auto [u, v] = freeAxes(axis);
    // A plane seen edge-on cannot be dragged in.
    const double least = smallestSingularValue(jacobian[u], jacobian[v]);
    if (least < kEdgeOnPixelsPerUnit || best[index] == Vec2{0.0}) continue;
    const double longest = std::max(glm::length(jacobian[u]), glm::length(jacobian[v]));
    const Vec2 a = jacobian[u] * (0.5 * kSquareSide * context.handleScale() / longest);
    const Vec2 b = jacobian[v] * (0.5 * kSquareSide * context.handleScale() / longest);
    const Vec2 at = *middle + best[index] * kSquareAway * context.handleScale();
    const HandleId id{HandleKind::kPlane, input.state.current.key, 0, axis};
    const double grow = context.hovered(id) ? 1.35 : 1.0;
    const Vec2 corners[] = {at + grow * (-a - b), at + grow * (a - b), at + grow * (a + b),
                            at + grow * (b - a)};
    const Colour colour = context.colour(roleOf(axis));
    DrawItem item;
    item.space = DrawSpace::kPixels;
    item.depth = DrawDepth::kOnTop;
    std::vector<GeometryPoint> triangles, lines;
    for (const int i : {0, 1, 2, 0, 2, 3}) triangles.push_back(geometryPoint(corners[i]));
    item.geometry = squareFills_[index].keep(Primitive::kTriangles, std::move(triangles));
    item.style = FillStyle{faded(colour, 0.45)};
    context.list.items.push_back(item);
    for (int i = -1; i <= 5; ++i) lines.push_back(geometryPoint(corners[(i + 4) % 4]));
    item.geometry = squares_[index].keep(Primitive::kPolylines, std::move(lines));
    item.style = LineStyle{colour, context.handlePixels(1.3)};
    context.list.items.push_back(item);
    context.list.handles.push_back({id, at, context.reach(8.0)});
    const Vec2 half{5.0 * context.handleScale()};
    context.labels.blockBox(at - half, at + half, kBlockedByMark);
  }
}

void DragPart::blockTriad(const ViewportContext& context) const {
  const auto origin = triadOrigin(context);
  if (!origin) return;
  const Vec2 half{(kTriadArm + 16.0) * context.scale()};
  context.labels.blockBox(*origin - half, *origin + half, kBlockedByMark);
}

void DragPart::addTriad(const ViewportContext& context) {
  const auto place = triadOrigin(context);
  if (!place) return;
  const Vec2& origin = *place;
  const ViewAxes& axes = context.view().axes();
  // The farthest first, so that the nearest lies on top.
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](int a, int b) { return axes.n[a] < axes.n[b]; });
  for (const int i : order) {
    const Vec2 way{axes.u[i], -axes.v[i]};
    const Vec2 tip = origin + way * kTriadArm * context.scale();
    const Colour colour = context.colour(roleOf(static_cast<Axis>(i)));
    DrawItem item;
    item.geometry = triad_[static_cast<std::size_t>(i)].keep(
        Primitive::kSegments, {geometryPoint(origin), geometryPoint(tip)});
    item.style = LineStyle{colour, context.pixels(2.0)};
    item.space = DrawSpace::kPixels;
    item.depth = DrawDepth::kOnTop;
    context.list.items.push_back(item);
    // An axis seen end-on has no room for its letter.
    if (glm::length(way) < 0.25) continue;
    const Vec2 size{context.input.text.letterWidth, context.input.text.lineHeight};
    const Vec2 letter = tip + normalized(way) * 10.0 * context.scale() - 0.5 * size;
    context.list.texts.push_back({std::string(1, "xyz"[i]), letter, colour, false});
  }
}

}  // namespace vides
