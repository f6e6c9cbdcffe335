// SPDX-License-Identifier: MIT
// A grid on the plane of the cube's lower face, and the line where it would end.
#include "scene/floor_part.hpp"

#include <cmath>
#include <vector>

namespace vides {
namespace {

constexpr double kLevel = -1.0;

// A grid of squares around the cube's middle, leaving out what a finer one covers.
struct Ring {
  double reach, step, inner;
  double dimmed;  // share of the ground's colour
};
constexpr std::array<Ring, 3> kRings{
    {{1.0, 0.25, 0.0, 0.55}, {3.0, 0.5, 1.0, 0.72}, {8.0, 1.0, 3.0, 0.84}}};

std::vector<GeometryPoint> gridOf(const Ring& ring) {
  std::vector<GeometryPoint> points;
  const auto line = [&](double at, double from, double to) {
    points.push_back(geometryPoint(Vec3{at, kLevel, from}));
    points.push_back(geometryPoint(Vec3{at, kLevel, to}));
    points.push_back(geometryPoint(Vec3{from, kLevel, at}));
    points.push_back(geometryPoint(Vec3{to, kLevel, at}));
  };
  const int lines = static_cast<int>(std::lround(ring.reach / ring.step));
  for (int i = -lines; i <= lines; ++i) {
    const double at = i * ring.step;
    if (std::abs(at) <= ring.inner) {
      line(at, -ring.reach, -ring.inner);
      line(at, ring.inner, ring.reach);
    } else {
      line(at, -ring.reach, ring.reach);
    }
  }
  return points;
}

}  // namespace

std::optional<std::array<Vec2, 2>> horizon(const ViewProjection& view) {
  // Rays are level where  slope · (x, y) = ahead,  x and y in units of the focal length.
  const ViewAxes& axes = view.axes();
  const Vec2 slope(axes.u.y, axes.v.y);
  const double ahead = axes.n.y;
  const double steepness = glm::length(slope);
  const PixelRectangle& r = view.pixels();
  const double focal = view.pixelsPerUnit();
  const double reach = glm::length(Vec2(r.width, r.height)) / focal;
  if (steepness < 1e-6 || std::abs(ahead) / steepness > reach) return std::nullopt;
  const Vec2 nearest = slope * (ahead / (steepness * steepness));
  const Vec2 along = Vec2(slope.y, -slope.x) * (2.0 * reach / steepness);
  const Vec2 middle(r.x + 0.5 * r.width, r.y + 0.5 * r.height);
  const auto pixel = [&](const Vec2& p) { return middle + focal * Vec2(p.x, -p.y); };
  return std::array{pixel(nearest - along), pixel(nearest + along)};
}

void FloorPart::add(DrawList& list, const Theme& theme, double contentScale) {
  const Colour ground = mix(list.groundTop, list.groundBottom, 0.5);
  const Colour colour = theme[ColourRole::kCube];
  const auto width = static_cast<float>(contentScale);
  DrawItem item;
  item.lift = -3;
  for (std::size_t i = 0; i < kRings.size(); ++i) {
    item.geometry = grids_[i].keep(Primitive::kSegments, gridOf(kRings[i]));
    item.style = LineStyle{mix(colour, ground, kRings[i].dimmed), width};
    list.items.push_back(item);
  }
  const auto ends = horizon(list.view);
  if (!ends) return;
  std::vector<GeometryPoint> line{geometryPoint((*ends)[0]), geometryPoint((*ends)[1])};
  item.geometry = horizon_.keep(Primitive::kSegments, std::move(line));
  item.style = LineStyle{mix(colour, ground, 0.7), width};
  item.space = DrawSpace::kPixels;
  item.depth = DrawDepth::kOnTop;
  list.items.push_back(item);
}

}  // namespace vides
