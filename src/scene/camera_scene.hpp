// SPDX-License-Identifier: MIT
// What a camera sees: the scene in the flight's picture format, through its lens, letterboxed.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "evaluate/section.hpp"
#include "flight/flight.hpp"
#include "math/view_projection.hpp"
#include "scene/draw_list.hpp"
#include "scene/scene_part.hpp"
#include "scene/theme.hpp"

namespace vides {

struct CameraInput {
  Camera camera;
  PictureFormat picture;
  Lens lens;
  Space space;                         // of the scenes
  std::vector<PlacedScene> scenes;
  PixelRectangle rectangle;
  double contentScale = 1.0;
  double lines = 1.2;  // width of cube and scene, at content scale 1
  bool sceneAsPoints = false;
  bool thirds = false;
  bool safeFrames = false;  // action 90 %, title 80 %
  // The cube's edges, the ground under it and the horizon; nothing: where there is no scene, so
  // that the camera's motion is seen.
  std::optional<bool> surroundings;
  Theme theme = vides::theme(ThemeKind::kDark);
};

// The largest rectangle of the picture's proportions in the middle of another; at least a pixel.
// All of the other, where no whole number of pixels is nearer to the proportions.
PixelRectangle letterbox(const PixelRectangle& rectangle, const PictureFormat& picture);

// The camera's view of that rectangle.
ViewProjection cameraView(const Camera& camera, const PictureFormat& picture, const Lens& lens,
                          const PixelRectangle& rectangle);

// Keeps its geometry between calls, as ViewportScene does.
class CameraScene {
 public:
  CameraScene();
  ~CameraScene();
  CameraScene(CameraScene&&) noexcept;
  CameraScene& operator=(CameraScene&&) noexcept;

  // Valid until the next call. The list's view has the letterboxed rectangle, its `outer` is the
  // input's.
  const DrawList& build(const CameraInput& input);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace vides
