// SPDX-License-Identifier: MIT
// Display frames of the whole editor, drawn into memory: while a key is dragged, and while the
// pointer moves without a button. What a drag costs beyond drawing is the difference.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include "app/drive/player.hpp"
#include "bars.hpp"
#include "host/open_host.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

// So many keys on a spiral in the cube.
Flight spiral(std::int64_t count) {
  Flight flight = newFlight();
  std::vector<KeyPointer> keys;
  for (std::int64_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    Key key = flight.keys[0];
    key.position = {0.8 * std::cos(40.0 * share), 1.6 * share - 0.8, 0.8 * std::sin(40.0 * share)};
    keys.emplace_back(std::move(key));
  }
  flight.keys = KeyList(std::move(keys));
  return flight;
}

void moveThePointer(benchmark::State& state, bool drag) {
  OffscreenOptions options;
  options.size = {1280, 800};
  auto host = openOffscreen(OffscreenKind::kOsmesa, options);
  if (!host) return state.SkipWithError(host.error().c_str());
  auto player = Player::create(**host);
  if (!player) return state.SkipWithError(player.error().c_str());
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("vides-bench-" + std::to_string(getpid()) + ".vid");
  if (saveVid(spiral(state.range(0)), file.string())) return state.SkipWithError("cannot write");
  Player& editor = **player;
  editor.perform(Command("open", file.string()));
  std::filesystem::remove(file);
  const std::int64_t key = state.range(0) / 2;
  editor.perform(Command("make-current", key, 0));
  // Until the measures of a long flight, which come in portions, are there.
  do {
    editor.frame();
  } while (editor.unfinished());
  const Rect rect = editor.editor().viewport();
  const PixelRectangle pixels{static_cast<double>(rect.x), static_cast<double>(rect.y),
                              static_cast<double>(rect.width), static_cast<double>(rect.height)};
  const Session& session = editor.editor().session();
  const Vec3 position = session.flight().keys[static_cast<std::size_t>(key)].position;
  const Vec2 from = viewProjection(session.view().view, pixels).project(position).value();
  editor.move(from.x, from.y);
  if (drag) editor.button(PointerButton::kLeft, true);
  int step = 0;
  for (auto _ : state) {
    ++step;
    editor.move(from.x + 40.0 * std::sin(0.1 * step), from.y + 20.0 * std::cos(0.1 * step));
  }
}

void Editor_PointerMoved(benchmark::State& state) { moveThePointer(state, false); }
BENCHMARK(Editor_PointerMoved)
    ->Arg(2)
    ->Arg(10000)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

void Editor_KeyDragged(benchmark::State& state) {
  bench::setPeer(state, "Editor_PointerMoved/" + std::to_string(state.range(0)) + "/process_time");
  moveThePointer(state, true);
}
BENCHMARK(Editor_KeyDragged)
    ->Arg(2)
    ->Arg(10000)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vides
