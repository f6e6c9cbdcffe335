// SPDX-License-Identifier: MIT
// Decides which of the cube's edges lie behind, and brings a scene into the cube.
#include "scene/cube_part.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include "scene/curve_flattener.hpp"

namespace vides {
namespace {

constexpr double kFacing = 1e-9;
// OpenGL 3.3 promises buffer textures of 65,536 texels; an edge takes two.
constexpr std::size_t kMostInChunk = 32768;

// Whether the face where coordinate `axis` is `sign` is turned to the viewer.
bool facesViewer(const ViewProjection& view, int axis, double sign) {
  if (!view.perspective()) return -sign * view.viewingDirection()[axis] > kFacing;
  return sign * view.referencePoint()[axis] - 1.0 > kFacing;
}

// Whether edge i is seen exactly behind an edge in front, or as a point: in the named views. Its
// dashes would show through the edges of the line before it.
bool isCovered(const ViewProjection& view, std::size_t i, std::uint32_t behind) {
  constexpr double kSamePixel = 0.25;
  const auto a = view.project(cubeCorner(kCubeEdges[i][0]));
  const auto b = view.project(cubeCorner(kCubeEdges[i][1]));
  if (!a || !b) return false;
  if (glm::distance(*a, *b) < kSamePixel) return true;
  for (std::size_t k = 0; k < kCubeEdges.size(); ++k) {
    if ((behind >> k & 1) != 0) continue;
    const auto c = view.project(cubeCorner(kCubeEdges[k][0]));
    const auto d = view.project(cubeCorner(kCubeEdges[k][1]));
    if (c && d && glm::distance(*a, *c) < kSamePixel && glm::distance(*b, *d) < kSamePixel) {
      return true;
    }
  }
  return false;
}

}  // namespace

Vec3 cubeCorner(int number) {
  return {(number & 1) != 0 ? 1.0 : -1.0, (number & 2) != 0 ? 1.0 : -1.0,
          (number & 4) != 0 ? 1.0 : -1.0};
}

std::uint32_t cubeEdgesBehind(const ViewProjection& view) {
  std::uint32_t behind = 0;
  for (std::size_t i = 0; i < kCubeEdges.size(); ++i) {
    const Vec3 a = cubeCorner(kCubeEdges[i][0]), b = cubeCorner(kCubeEdges[i][1]);
    bool faces = false;
    for (int axis = 0; axis < 3; ++axis) {
      if (a[axis] == b[axis]) faces = faces || facesViewer(view, axis, a[axis]);
    }
    if (!faces) behind |= 1u << i;
  }
  return behind;
}

void CubePart::add(DrawList& list, const Theme& theme, double contentScale, float lineWidth) {
  std::vector<GeometryPoint> front, back;
  const std::uint32_t behind = cubeEdgesBehind(list.view);
  for (std::size_t i = 0; i < kCubeEdges.size(); ++i) {
    const bool isBehind = (behind >> i & 1) != 0;
    if (isBehind && isCovered(list.view, i, behind)) continue;
    auto& points = isBehind ? back : front;
    for (const int corner : kCubeEdges[i]) points.push_back(geometryPoint(cubeCorner(corner)));
  }
  const auto scale = static_cast<float>(contentScale);
  const Colour colour = theme[ColourRole::kCube];
  const Colour dim = mix(colour, mix(list.groundTop, list.groundBottom, 0.5), 0.4);

  DrawItem item;
  item.geometry = back_.keep(Primitive::kSegments, std::move(back));
  item.style = LineStyle{dim, lineWidth, 4.5f * scale, 4.5f * scale};
  item.lift = -2;
  list.items.push_back(item);
  item.geometry = front_.keep(Primitive::kSegments, std::move(front));
  item.style = LineStyle{colour, lineWidth};
  item.lift = -1;
  list.items.push_back(item);
}

// `place(element, points)` appends the points of an element.
template <class Elements, class Place>
std::vector<ScenePart::Chunk> ScenePart::divide(Primitive primitive, const Elements& elements,
                                                Place place) {
  std::vector<Chunk> chunks;
  for (std::size_t first = 0; first < elements.size(); first += kMostInChunk) {
    auto geometry = std::make_shared<Geometry>(Geometry{primitive, {}});
    const std::size_t last = std::min(first + kMostInChunk, elements.size());
    for (std::size_t i = first; i < last; ++i) place(elements[i], geometry->points);
    const auto& front = geometry->points.front();
    Chunk chunk{nullptr, {front.x, front.y, front.z}, {front.x, front.y, front.z}};
    for (const GeometryPoint& p : geometry->points) {
      chunk.low = glm::min(chunk.low, Vec3{p.x, p.y, p.z});
      chunk.high = glm::max(chunk.high, Vec3{p.x, p.y, p.z});
    }
    chunk.geometry = std::move(geometry);
    chunks.push_back(std::move(chunk));
  }
  return chunks;
}

void ScenePart::add(DrawList& list, const SharedScene& scene, const Space& space, bool asPoints,
                    const Theme& theme, float lineWidth) {
  if (!scene || scene->empty()) return;
  if (scene != scene_ || !(space == space_) || asPoints != asPoints_) {
    scene_ = scene;
    space_ = space;
    asPoints_ = asPoints;
    const auto place = [&](const Vec3& position, std::vector<GeometryPoint>& points) {
      points.push_back(geometryPoint(space.toCube(position)));
    };
    const auto placeAt = [&](std::uint32_t index, std::vector<GeometryPoint>& points) {
      place(scene->positions[index], points);
    };
    edges_.clear();
    if (asPoints) {
      points_ = divide(Primitive::kMarkers, scene->positions, place);
    } else {
      points_ = divide(Primitive::kMarkers, scene->points, placeAt);
      edges_ = divide(Primitive::kSegments, scene->edges,
                      [&](const auto& edge, std::vector<GeometryPoint>& points) {
                        placeAt(edge[0], points);
                        placeAt(edge[1], points);
                      });
    }
  }
  const Colour colour = theme[ColourRole::kScene];
  // A point is a little wider than a line, so that it is seen where none leads to it.
  const float pointRadius = lineWidth * (1.3f / 1.2f);
  DrawItem item;
  item.fade = 0.45f;
  const auto addChunks = [&](const std::vector<Chunk>& chunks) {
    for (const Chunk& chunk : chunks) {
      if (!mayBeSeen(list.view, chunk.low, chunk.high, 2.0 * static_cast<double>(pointRadius)))
        continue;
      item.geometry = chunk.geometry;
      list.items.push_back(item);
    }
  };
  item.style = MarkerStyle{MarkerShape::kDisc, colour, kNoColour, pointRadius};
  addChunks(points_);
  item.style = LineStyle{colour, lineWidth};
  addChunks(edges_);
}

}  // namespace vides
