// SPDX-License-Identifier: MIT
// Paints draw lists on an offscreen host without multisampling.
#include "support/scene_painter.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "io/vid_reader.hpp"
#include "scene/obj_reader.hpp"
#include "support/offscreen.hpp"

namespace vides::test {

ScenePainter::ScenePainter(PixelSize size, OffscreenKind kind) {
  host_ = openForTest(size, kind, 0);
  host_->makeCurrent();
  auto renderer = SceneRenderer::create(host_->gl());
  if (!renderer) throw std::runtime_error(renderer.error());
  renderer_ = std::make_unique<SceneRenderer>(std::move(*renderer));
}

Picture ScenePainter::paint(const DrawList& list) {
  host_->beginDrawing();
  renderer_->draw(list, host_->size().width, host_->size().height);
  return finish();
}

Picture ScenePainter::paint(const DrawList& first, const DrawList& second,
                            const std::optional<PixelRectangle>& clipOfSecond) {
  host_->beginDrawing();
  renderer_->draw(first, host_->size().width, host_->size().height);
  renderer_->draw(second, host_->size().width, host_->size().height, clipOfSecond);
  return finish();
}

Picture ScenePainter::finish() {
  const auto errors = checkGl(host_->gl(), "drawing a scene");
  EXPECT_TRUE(errors) << errors.error();
  host_->swap();
  return host_->picture().value();
}

Sample sample(const std::string& name) {
  const std::filesystem::path folder = VIDES_SOURCE_DIR "/assets/flights";
  auto flight = readVidFile((folder / (name + ".vid")).string());
  if (!flight) throw std::runtime_error(name + ".vid can't be read");
  std::vector<PlacedScene> scenes;
  for (const SceneFile& file : flight->scene) {
    auto read = readSceneFile(sceneFilePath(folder, file.file));
    if (!read) throw std::runtime_error(file.file + " can't be read");
    if (file.visible) scenes.emplace_back(DrawableScene::make(*read), file.up);
  }
  return {std::move(*flight), std::move(scenes)};
}

ViewportInput viewportInput(const Sample& sample) {
  ViewportInput input;
  input.evaluation = Evaluation(sample.flight);
  input.scenes = sample.scenes;
  input.rectangle = {0, 0, 800, 600};
  input.state.current = {2, 0};
  input.state.selected = {2};
  input.state.playhead = input.evaluation.frameCount() * 2 / 5;
  return input;
}

}  // namespace vides::test
