// SPDX-License-Identifier: MIT
// Pictures of the sample flights in each named view and through their cameras, against baselines
// that are proved to see a camera moved by one pixel.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "support/offscreen.hpp"
#include "support/picture_check.hpp"
#include "support/scene_painter.hpp"

namespace vides {
namespace {

constexpr PixelSize kSize{800, 600};

struct NamedView {
  const char* name;
  double turn, tilt;
};
constexpr NamedView kViews[] = {{"iso", 32, 22}, {"front", 0, 0}, {"side", 90, 0}, {"top", 0, 90}};

std::string nameOf(const std::string& flight, const NamedView& view, ProjectionType type) {
  const char* ending = type == ProjectionType::Parallel ? "" : "_perspective";
  return "scene_" + flight + "_" + view.name + ending;
}

// One picture to be looked at: as it should be, and with the camera moved by one pixel.
struct Shown {
  std::string name;
  Picture picture, moved;
};

Picture paintView(test::ScenePainter& painter, const ViewportInput& input) {
  ViewportScene scene;
  return painter.paint(scene.build(input));
}

Picture paintCamera(test::ScenePainter& painter, const CameraInput& input) {
  CameraScene scene;
  return painter.paint(scene.build(input));
}

void forEachView(const std::string& flight, const std::function<void(Shown)>& look,
                 test::ScenePainter& painter) {
  ViewportInput input = test::viewportInput(test::sample(flight));
  for (const NamedView& view : kViews) {
    for (const auto type : {ProjectionType::Parallel, ProjectionType::Perspective}) {
      input.view = {view.turn, view.tilt, 1.0, Vec3{0.0}, type};
      Shown shown{nameOf(flight, view, type), paintView(painter, input), {}};
      const ViewProjection projection = viewProjection(input.view, input.rectangle);
      input.view.target = projection.axes().u / projection.pixelsPerUnit();
      shown.moved = paintView(painter, input);
      look(std::move(shown));
    }
  }
}

void forEachFrame(const std::string& flight, const std::function<void(Shown)>& look,
                  test::ScenePainter& painter) {
  const test::Sample sample = test::sample(flight);
  const Evaluation evaluation(sample.flight);
  CameraInput input;
  input.picture = sample.flight.picture;
  input.lens = sample.flight.lens;
  input.space = sample.flight.space;
  input.scenes = sample.scenes;
  input.surroundings = true;
  input.thirds = input.safeFrames = true;
  input.rectangle = {0, 0, 800, 600};
  // Moments at which the camera sees something: the dolly's first and last look past the scene.
  const auto moments = flight == "dolly" ? std::array{40, 45, 50, 58} : std::array{0, 33, 67, 100};
  for (const int percent : moments) {
    const std::int64_t frame = (evaluation.frameCount() - 1) * percent / 100;
    input.camera = evaluation.frame(frame).camera;
    Shown shown{
        "scene_" + flight + "_camera_" + std::to_string(percent), paintCamera(painter, input), {}};
    // Turned by the angle that a pixel in the middle covers.
    const double pixel =
        2.0 * std::tan(0.5 * input.lens.horizontalFieldOfView(input.camera.zoom)) / 800;
    const Vec3 right = glm::cross(input.camera.viewPlaneNormal, input.camera.viewUpVector);
    input.camera.viewPlaneNormal = glm::normalize(input.camera.viewPlaneNormal + pixel * right);
    shown.moved = paintCamera(painter, input);
    look(std::move(shown));
  }
}

void expectBaselines(const std::string& flight, OffscreenKind kind) {
  PictureTolerance tolerance;
  if (kind == OffscreenKind::kEgl) tolerance.share = kEglShare;
  test::ScenePainter painter(kSize, kind);
  const auto look = [&](const Shown& shown) {
    EXPECT_TRUE(test::equalsBaseline(shown.picture, shown.name, tolerance));
    const PictureDifference moved = comparePictures(shown.moved, shown.picture, tolerance);
    EXPECT_FALSE(moved.equal) << shown.name
                              << " does not see a shift by one pixel: " << moved.sentence;
  };
  forEachView(flight, look, painter);
  forEachFrame(flight, look, painter);
}

class ScenePictures : public testing::TestWithParam<const char*> {};

TEST_P(ScenePictures, EqualTheirBaselines) { expectBaselines(GetParam(), OffscreenKind::kOsmesa); }

TEST_P(ScenePictures, EqualTheirBaselinesThroughEgl) {
  if (!test::hasEgl()) GTEST_SKIP() << "no EGL here";
  expectBaselines(GetParam(), OffscreenKind::kEgl);
}

INSTANTIATE_TEST_SUITE_P(Samples, ScenePictures,
                         testing::Values("pyramid", "closed-orbit", "dolly"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::erase(name, '-');
                           return name;
                         });

// States of the editor, all in one flight and view.
TEST(ScenePicturesOf, HoverDragAndThemes) {
  test::ScenePainter painter(kSize);
  ViewportInput input = test::viewportInput(test::sample("pyramid"));
  input.state.selected = {1, 2, 4};
  input.state.hovered = HandleId{HandleKind::kAim, 2, 0, Axis::X};
  EXPECT_TRUE(test::equalsBaseline(paintView(painter, input), "scene_hover"));
  input.state.hovered.reset();
  input.state.drag = DragDisplay{input.evaluation.flight().keys[2].position, Axis::Y};
  EXPECT_TRUE(test::equalsBaseline(paintView(painter, input), "scene_drag"));
  input.state.drag.reset();
  input.theme = theme(ThemeKind::kLight);
  EXPECT_TRUE(test::equalsBaseline(paintView(painter, input), "scene_light"));
  input.theme = theme(ThemeKind::kHighContrast);
  EXPECT_TRUE(test::equalsBaseline(paintView(painter, input), "scene_high_contrast"));
}

TEST(ScenePicturesOf, TheSameInputAreTheSame) {
  const ViewportInput input = test::viewportInput(test::sample("pyramid"));
  test::ScenePainter first(kSize), second(kSize);
  const Picture picture = paintView(first, input);
  EXPECT_EQ(picture, paintView(first, input));
  EXPECT_EQ(picture, paintView(second, input));
}

}  // namespace
}  // namespace vides
