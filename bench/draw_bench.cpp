// SPDX-License-Identifier: MIT
// What a display frame of the viewport costs: beside the same primitives drawn with nothing else,
// and our own part of it for long flights. Through OSMesa, 1280 x 800.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "bars.hpp"
#include "host/open_host.hpp"
#include "io/vid_reader.hpp"
#include "render/scene_renderer.hpp"
#include "scene/drawable_scene.hpp"
#include "scene/obj_reader.hpp"
#include "scene/viewport_scene.hpp"

namespace vides {
namespace {

constexpr PixelSize kSize{1280, 800};

struct Stage {
  std::unique_ptr<OffscreenHost> host;
  std::unique_ptr<SceneRenderer> renderer;

  static std::unique_ptr<Stage> open(benchmark::State& state) {
    OffscreenOptions options;
    options.size = kSize;
    options.samples = 0;
    auto host = openOffscreen(OffscreenKind::kOsmesa, options);
    if (!host) {
      state.SkipWithError(host.error().c_str());
      return nullptr;
    }
    auto stage = std::make_unique<Stage>();
    stage->host = std::move(*host);
    stage->host->makeCurrent();
    auto renderer = SceneRenderer::create(stage->host->gl());
    if (!renderer) {
      state.SkipWithError(renderer.error().c_str());
      return nullptr;
    }
    stage->renderer = std::make_unique<SceneRenderer>(std::move(*renderer));
    return stage;
  }
  // The renderer goes first: its objects need the context.
  ~Stage() { renderer.reset(); }

  void draw(const DrawList& list) {
    host->beginDrawing();
    renderer->draw(list, kSize.width, kSize.height);
    host->gl().Finish();
  }
};

ViewportInput inputOf(const Flight& flight, const SceneGeometry& scene) {
  ViewportInput input;
  input.evaluation = Evaluation(flight);
  input.scenes = {DrawableScene::make(scene)};
  input.rectangle = {0, 0, static_cast<double>(kSize.width), static_cast<double>(kSize.height)};
  input.state.current = {flight.keys.size() / 2, 0};
  input.state.selected = {flight.keys.size() / 2};
  return input;
}

ViewportInput pyramid() {
  const std::filesystem::path folder = VIDES_SOURCE_DIR "/assets/flights";
  const Flight flight = readVidFile((folder / "pyramid.vid").string()).value();
  return inputOf(flight, readSceneFile(sceneFilePath(folder, flight.scene.at(0).file)).value());
}

// A path that wanders through the cube, and as many edges of a scene.
ViewportInput wandering(std::size_t keys, std::size_t edges) {
  std::mt19937_64 engine(20);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const auto random = [&] {
    const double x = share(engine), y = share(engine);
    return Vec3{x, y, share(engine)};
  };
  std::vector<KeyPointer> list;
  Vec3 place{0.0}, way{1, 0, 0};
  const double step = std::min(0.3, 100.0 / static_cast<double>(keys));
  for (std::size_t i = 0; i < keys; ++i) {
    Key key;
    key.position = place;
    key.orientations.front().aim = {0, 0, 5};
    list.emplace_back(key);
    way = glm::normalize(way + 0.4 * random() - 0.3 * place);
    place = glm::clamp(place + step * way, Vec3{-1.0}, Vec3{1.0});
  }
  Flight flight;
  flight.keys = KeyList(std::move(list));
  SceneGeometry scene;
  for (std::size_t i = 0; i < edges; ++i) {
    const Vec3 at = random();
    scene.positions.push_back(at);
    scene.positions.push_back(at + 0.1 * random());
    const auto index = static_cast<std::uint32_t>(2 * i);
    scene.edges.push_back({index, index + 1});
  }
  finishScene(scene);
  return inputOf(flight, scene);
}

// One step of dragging the current key: the edit, its evaluation, the list.
const DrawList& drag(ViewportInput& input, ViewportScene& scene, int step) {
  Flight flight = input.evaluation.flight();
  const std::size_t index = input.state.current.key;
  Key key = flight.keys[index];
  key.position.x = 0.5 + 0.3 * std::sin(0.1 * step);
  input.state.drag = DragDisplay{key.position, Axis::Y};
  flight.keys.set(index, std::move(key));
  input.evaluation = input.evaluation.updated(flight);
  return scene.build(input);
}

void Draw_PyramidPrimitives(benchmark::State& state) {
  const auto stage = Stage::open(state);
  if (!stage) return;
  ViewportInput input = pyramid();
  ViewportScene scene;
  const DrawList list = drag(input, scene, 1);
  for (auto _ : state) stage->draw(list);
}
BENCHMARK(Draw_PyramidPrimitives)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

void Draw_PyramidDragged(benchmark::State& state) {
  bench::setPeer(state, "Draw_PyramidPrimitives/process_time");
  const auto stage = Stage::open(state);
  if (!stage) return;
  ViewportInput input = pyramid();
  ViewportScene scene;
  int step = 0;
  for (auto _ : state) stage->draw(drag(input, scene, ++step));
}
BENCHMARK(Draw_PyramidDragged)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

// Our own part alone; the bar is 1 ms for 1,000 keys and 1,000 edges.
void Scene_Dragged(benchmark::State& state) {
  if (state.range(0) == 1000) bench::setLimit(state, 1e6);
  ViewportInput input = wandering(static_cast<std::size_t>(state.range(0)), 1000);
  ViewportScene scene;
  int step = 0;
  for (auto _ : state) benchmark::DoNotOptimize(drag(input, scene, ++step).items.size());
}
BENCHMARK(Scene_Dragged)->Arg(1000)->Arg(100000)->Unit(benchmark::kMicrosecond);

void Scene_Turned(benchmark::State& state) {
  if (state.range(0) == 1000) bench::setLimit(state, 1e6);
  ViewportInput input = wandering(static_cast<std::size_t>(state.range(0)), 1000);
  input.view.type = state.range(1) == 0 ? ProjectionType::Parallel : ProjectionType::Perspective;
  ViewportScene scene;
  for (auto _ : state) {
    input.view.turn += 0.5;
    benchmark::DoNotOptimize(scene.build(input).items.size());
  }
}
BENCHMARK(Scene_Turned)
    ->Args({1000, 0})
    ->Args({1000, 1})
    ->Args({100000, 0})
    ->Args({100000, 1})
    ->Unit(benchmark::kMicrosecond);

void Draw_Wandering(benchmark::State& state) {
  const auto stage = Stage::open(state);
  if (!stage) return;
  ViewportInput input = wandering(static_cast<std::size_t>(state.range(0)), 1000);
  ViewportScene scene;
  const DrawList& list = scene.build(input);
  for (auto _ : state) stage->draw(list);
  state.counters["elements"] = static_cast<double>(stage->renderer->statistics().elements);
}
BENCHMARK(Draw_Wandering)
    ->Arg(1000)
    ->Arg(100000)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vides
