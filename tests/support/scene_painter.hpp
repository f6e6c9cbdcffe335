// SPDX-License-Identifier: MIT
// Paints draw lists without a window, and makes the sample flights' lists.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/open_host.hpp"
#include "render/picture.hpp"
#include "render/scene_renderer.hpp"
#include "scene/camera_scene.hpp"
#include "scene/viewport_scene.hpp"

namespace vides::test {

class ScenePainter {
 public:
  explicit ScenePainter(PixelSize size, OffscreenKind kind = OffscreenKind::kOsmesa);
  Picture paint(const DrawList& list);
  // Several lists into one picture.
  Picture paint(const DrawList& first, const DrawList& second,
                const std::optional<PixelRectangle>& clipOfSecond = std::nullopt);
  const SceneRenderer::Statistics& statistics() const { return renderer_->statistics(); }
  Host& host() { return *host_; }
  SceneRenderer& renderer() { return *renderer_; }

 private:
  Picture finish();
  std::unique_ptr<OffscreenHost> host_;
  std::unique_ptr<SceneRenderer> renderer_;
};

// A flight of assets/flights with its scene; aborts where it can't be read.
struct Sample {
  Flight flight;
  std::vector<PlacedScene> scenes;
};
Sample sample(const std::string& name);

// The sample in an 800 x 600 viewport, some key current, some frame at the playhead.
ViewportInput viewportInput(const Sample& sample);

}  // namespace vides::test
