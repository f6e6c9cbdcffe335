// SPDX-License-Identifier: MIT
// What the editor itself costs: playback in real time, the timeline of a long flight.
#include <benchmark/benchmark.h>
#include <imgui.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "app/editor.hpp"
#include "bars.hpp"
#include "edit/texts.hpp"
#include "host/open_host.hpp"
#include "panels/sphere_path.hpp"
#include "panels/timeline_panel.hpp"

namespace vides {
namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

// Plays the pyramid flight for some seconds as the program's loop does, through OSMesa at
// 1280 x 800: a display frame whenever the editor wants one. What is told is the time that one
// frame of the flight took on the screen; its limit is that of the flight's frame rate.
void Playback_RealTime(benchmark::State& state) {
  const auto rate = static_cast<double>(state.range(0));
  constexpr double kSeconds = 4.0;
  OffscreenOptions options;
  options.size = {1280, 800};
  auto host = openOffscreen(OffscreenKind::kOsmesa, options);
  if (!host) return state.SkipWithError(host.error().c_str());
  (*host)->makeCurrent();
  auto editor = Editor::create((*host)->gl(), {});
  if (!editor) return state.SkipWithError(editor.error().c_str());
  FrameInput input;
  input.size = options.size;
  const auto begin = steady_clock::now();
  const auto seconds = [&] { return duration<double>(steady_clock::now() - begin).count(); };
  // Seconds until the next one is wanted.
  const auto draw = [&] {
    (*host)->beginDrawing();
    input.time = seconds();
    const FrameOutcome outcome = (*editor)->frame(input);
    (*host)->gl().Finish();
    (*host)->swap();
    return outcome.nextFrameIn.value_or(0.0) - (seconds() - input.time);
  };
  Session& session = (*editor)->session();
  if (!session.execute(Command("open", VIDES_SOURCE_DIR "/assets/flights/pyramid.vid")) ||
      !session.execute(Command("set-frame-rate", rate)) || !session.execute("loop on")) {
    return state.SkipWithError("the flight");
  }
  for (int i = 0; i < 5; ++i) draw();
  std::int64_t late = 0;
  for (auto _ : state) {
    session.execute("play on");
    draw();
    const double from = input.time;
    const std::int64_t count = session.evaluation().frameCount();
    std::int64_t shown = 0, before = session.frame();
    while (input.time - from < kSeconds) {
      const double wait = draw();
      const std::int64_t step = (session.frame() - before + count) % count;
      if (step > 0) ++shown;
      late += std::max<std::int64_t>(0, step - 1);
      before = session.frame();
      if (wait > 0.0) std::this_thread::sleep_for(duration<double>(wait));
    }
    state.SetIterationTime((input.time - from) / static_cast<double>(shown));
    session.execute("play off");
  }
  state.counters["dropped"] = static_cast<double>(late);
  bench::setLimit(state, 1e9 / rate);
}
BENCHMARK(Playback_RealTime)
    ->Arg(25)
    ->Arg(60)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

// A flight that goes round and round.
Flight longFlight(std::size_t keys) {
  std::vector<KeyPointer> list;
  for (std::size_t i = 0; i < keys; ++i) {
    const double angle = 0.01 * static_cast<double>(i);
    Key key;
    key.position = {0.8 * std::cos(angle), 0.8 * std::sin(0.37 * angle), 0.8 * std::sin(angle)};
    key.orientations.front().aim = {0.0, 0.5, 0.0};
    list.emplace_back(key);
  }
  Flight flight = newFlight();
  flight.keys = KeyList(std::move(list));
  return flight;
}

// The way of the VPN on the sphere, made anew after a key of many has moved.
void Sphere_Dragged(benchmark::State& state) {
  constexpr double kTolerance = 2.0 / 100.0;
  Flight flight = longFlight(static_cast<std::size_t>(state.range(0)));
  Evaluation evaluation(flight);
  SpherePath path;
  double at = 0.0;
  for (auto _ : state) {
    state.PauseTiming();
    Key key = flight.keys[flight.keys.size() / 2];
    key.position.y = 0.1 * std::sin(at += 0.1);
    flight.keys.set(flight.keys.size() / 2, std::move(key));
    evaluation = evaluation.updated(flight);
    state.ResumeTiming();
    path.follow(evaluation, {flight.keys.size() / 2, 0}, kTolerance);
  }
}
BENCHMARK(Sphere_Dragged)->Arg(200)->Arg(1000)->Arg(100'000);

// The timeline's panel alone, as a display frame makes it, without OpenGL.
class Desk {
 public:
  explicit Desk(std::size_t keys) : fonts_(buildFonts(1.0)) {
    context_ = ImGui::CreateContext(fonts_.atlas.get());
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1280.0f, 800.0f};
    io.DeltaTime = 1.0f / 60.0f;
    io.FontDefault = fonts_.fonts.regular;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    applyStyle(ImGui::GetStyle(), theme(ThemeKind::kDark), 1.0f);
    session_.recover(longFlight(keys), {});
    // The whole flight's measures are taken in portions; then they cost nothing.
    do {
      graphs_.follow(session_.evaluation());
    } while (graphs_.measuring());
    for (int i = 0; i < 3; ++i) frame();
  }
  ~Desk() { ImGui::DestroyContext(context_); }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  TimelineView& view() { return view_; }
  double frames() const { return static_cast<double>(session_.evaluation().frameCount()); }

  // Vertices that are to be drawn.
  int frame() {
    ImGui::NewFrame();
    registry_.beginFrame();
    graphs_.follow(session_.evaluation());
    Ui ui({fonts_.fonts, theme(ThemeKind::kDark), words_, tell_, hint_, registry_, memory_, 1.0f,
           0.0, false});
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({1280.0f, 800.0f});
    ImGui::Begin("###window", nullptr, ImGuiWindowFlags_NoDecoration);
    Actions actions;
    timelinePanel(ui, {0.0f, 650.0f, 1280.0f, 150.0f}, session_, graphs_, view_, actions);
    ImGui::End();
    ImGui::Render();
    return ImGui::GetDrawData()->TotalVtxCount;
  }

 private:
  FontSet fonts_;
  ImGuiContext* context_ = nullptr;
  Session session_;
  FlightGraphs graphs_;
  TimelineView view_;
  WidgetRegistry registry_;
  UiMemory memory_;
  Texts texts_{Language::kEnglish};
  Words words_ = [this](std::string_view key) { return std::string(texts_.words(key)); };
  Tell tell_ = [this](const Text& text) { return texts_.tell(text); };
  ShortcutHint hint_ = [](std::string_view) { return std::string(); };
};

// Own part of a display frame; the bar is 1 ms. Scrolled by a few pixels a display frame, at a
// share of the flight that is seen.
void Timeline_Scrolled(benchmark::State& state) {
  bench::setLimit(state, 1e6);
  Desk desk(100000);
  desk.view().fit = false;
  desk.view().framesPerPixel = desk.frames() / 1244.0 / static_cast<double>(state.range(0));
  double first = 0.0;
  int vertices = 0;
  for (auto _ : state) {
    first += 7.3 * desk.view().framesPerPixel;
    if (first > desk.frames() / 2) first = 0.0;
    desk.view().firstFrame = first;
    vertices = desk.frame();
  }
  state.counters["vertices"] = vertices;
}
BENCHMARK(Timeline_Scrolled)->Arg(3)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);

void Timeline_Zoomed(benchmark::State& state) {
  bench::setLimit(state, 1e6);
  Desk desk(100000);
  desk.view().fit = false;
  const double coarsest = desk.frames() / 1244.0;
  double zoom = 1.0;
  for (auto _ : state) {
    zoom *= 1.1;
    if (zoom > 10000.0) zoom = 1.0;
    desk.view().framesPerPixel = coarsest / zoom;
    desk.view().firstFrame = 0.4 * desk.frames();
    benchmark::DoNotOptimize(desk.frame());
  }
}
BENCHMARK(Timeline_Zoomed)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace vides
