// SPDX-License-Identifier: MIT
// Sets up the camera's view and the little that is drawn in it.
#include "scene/camera_scene.hpp"

#include <algorithm>
#include <cmath>

#include "scene/cube_part.hpp"
#include "scene/floor_part.hpp"
#include "scene/geometry_slot.hpp"
#include "scene/scene_part.hpp"

namespace vides {
namespace {

void addRectangle(std::vector<GeometryPoint>& points, const PixelRectangle& r, double share) {
  const Vec2 middle{r.x + 0.5 * r.width, r.y + 0.5 * r.height};
  const Vec2 half{0.5 * share * r.width, 0.5 * share * r.height};
  const Vec2 corners[] = {middle - half, middle + Vec2{half.x, -half.y}, middle + half,
                          middle + Vec2{-half.x, half.y}};
  for (int i = 0; i < 4; ++i) {
    points.push_back(geometryPoint(corners[i]));
    points.push_back(geometryPoint(corners[(i + 1) % 4]));
  }
}

void addThirds(std::vector<GeometryPoint>& points, const PixelRectangle& r) {
  for (const double share : {1.0 / 3.0, 2.0 / 3.0}) {
    const double x = r.x + share * r.width, y = r.y + share * r.height;
    points.push_back(geometryPoint(Vec2{x, r.y}));
    points.push_back(geometryPoint(Vec2{x, r.y + r.height}));
    points.push_back(geometryPoint(Vec2{r.x, y}));
    points.push_back(geometryPoint(Vec2{r.x + r.width, y}));
  }
}

}  // namespace

struct CameraScene::Parts {
  DrawList list;
  CubePart cube;
  FloorPart floor;
  ScenePart scenes;
  GeometrySlot guides;
};

PixelRectangle letterbox(const PixelRectangle& r, const PictureFormat& picture) {
  const double proportion = static_cast<double>(picture.width) / picture.height;
  // As near to the proportions as whole pixels come: no bar of one pixel beside it.
  const bool fits =
      std::round(r.width / proportion) == r.height || std::round(r.height * proportion) == r.width;
  if (fits && r.width >= 1.0 && r.height >= 1.0) return r;
  const double width = std::max(1.0, std::round(std::min(r.width, r.height * proportion)));
  const double height = std::max(1.0, std::round(std::min(r.height, r.width / proportion)));
  return {r.x + std::floor(0.5 * (r.width - width)), r.y + std::floor(0.5 * (r.height - height)),
          width, height};
}

ViewProjection cameraView(const Camera& camera, const PictureFormat& picture, const Lens& lens,
                          const PixelRectangle& rectangle) {
  // The lens gives the field across the width; the rectangle's own proportions, rounded to pixels,
  // give the height, so that a pixel is as high as it is wide.
  const double vertical =
      lens.verticalFieldOfView(camera.zoom, rectangle.width > 0.0 ? rectangle.width : picture.width,
                               rectangle.height > 0.0 ? rectangle.height : picture.height);
  return viewProjection(camera.viewReferencePoint, camera.viewPlaneNormal, camera.viewUpVector,
                        vertical, rectangle);
}

CameraScene::CameraScene() : parts_(std::make_unique<Parts>()) {}
CameraScene::~CameraScene() = default;
CameraScene::CameraScene(CameraScene&&) noexcept = default;
CameraScene& CameraScene::operator=(CameraScene&&) noexcept = default;

const DrawList& CameraScene::build(const CameraInput& input) {
  Parts& p = *parts_;
  DrawList& list = p.list;
  const PixelRectangle picture = letterbox(input.rectangle, input.picture);
  list.view = cameraView(input.camera, input.picture, input.lens, picture);
  list.outer = input.rectangle;
  list.bars = input.theme[ColourRole::kPictureBars];
  list.groundTop = list.groundBottom = input.theme[ColourRole::kPicture];
  list.items.clear();

  const auto lineWidth = static_cast<float>(input.lines * input.contentScale);
  if (input.surroundings.value_or(input.scenes.empty())) {
    p.floor.add(list, input.theme, input.contentScale);
    p.cube.add(list, input.theme, input.contentScale, lineWidth);
  }
  p.scenes.add(list, {input.scenes, input.space, input.sceneAsPoints, lineWidth}, input.theme);

  std::vector<GeometryPoint> guides;
  if (input.thirds) addThirds(guides, picture);
  if (input.safeFrames) {
    addRectangle(guides, picture, 0.9);
    addRectangle(guides, picture, 0.8);
  }
  DrawItem item;
  item.geometry = p.guides.keep(Primitive::kSegments, std::move(guides));
  item.style = LineStyle{input.theme[ColourRole::kGuide], static_cast<float>(input.contentScale)};
  item.space = DrawSpace::kPixels;
  item.depth = DrawDepth::kOnTop;
  list.items.push_back(item);
  return list;
}

}  // namespace vides
