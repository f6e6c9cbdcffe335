// SPDX-License-Identifier: MIT
// How long it takes from keys to frames and from frames to text, and what evaluated keys weigh.
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <time.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "bars.hpp"
#include "evaluate/evaluation.hpp"
#include "io/frame_text.hpp"
#include "io/frame_writer.hpp"
#include "io/vid_reader.hpp"

namespace vides {
namespace {

// A long way through the cube, the camera on something near its middle.
Flight longFlight(std::int64_t keys) {
  std::mt19937_64 random{11};
  std::uniform_real_distribution<double> around{-0.1, 0.1};
  Flight flight;
  std::vector<KeyPointer> list;
  for (std::int64_t i = 0; i < keys; ++i) {
    const double t = 0.13 * static_cast<double>(i);
    Key key;
    key.position = {0.85 * std::sin(t) + around(random), 0.6 + 0.2 * std::sin(0.37 * t),
                    0.85 * std::cos(1.1 * t) + around(random)};
    Orientation& orientation = key.orientations.front();
    orientation.aim = {around(random), around(random), around(random)};
    orientation.zoom = 20.0 + 100.0 * around(random);
    orientation.roll = 100.0 * around(random);
    list.emplace_back(std::move(key));
  }
  flight.keys = KeyList(std::move(list));
  return flight;
}

Flight pyramid() { return *readVidFile(VIDES_SOURCE_DIR "/assets/flights/pyramid.vid"); }

void walkAll(const Evaluation& evaluation) {
  FrameWalk walk(evaluation);
  for (Frame frame; walk.next(frame);) benchmark::DoNotOptimize(frame);
}

void evaluateFrames(benchmark::State& state, const Flight& flight) {
  const Evaluation evaluation(flight);
  const auto frames = evaluation.frameCount();
  for (auto _ : state) walkAll(evaluation);
  state.SetItemsProcessed(state.iterations() * frames);
  bench::setLimit(state, 500.0 * static_cast<double>(frames));
}
BENCHMARK_CAPTURE(evaluateFrames, pyramid, pyramid());
BENCHMARK_CAPTURE(evaluateFrames, thousandKeys, longFlight(1000));

// Of this thread: what others do meanwhile doesn't count.
double processorSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Evaluating alone, formatting alone and both together, in turn, so that a busy machine is busy for
// all three. The time is that of both together; `to_parts` its ratio to the sum of the others.
void writeFrames(benchmark::State& state, const FrameFormat* format, const Flight& flight) {
  const Evaluation evaluation(flight);
  std::vector<Frame> frames;
  FrameWalk walk(evaluation);
  for (Frame frame; walk.next(frame);) frames.push_back(frame);
  FrameOptions options;
  options.format = format;
  const auto text = format->make({flight, Space{}, 1});
  std::vector<char> buffer(std::size_t{1} << 17);

  const auto formatAll = [&] {
    char* out = buffer.data();
    for (const Frame& frame : frames) {
      out = text->write(frame, out);
      if (out - buffer.data() >= 1 << 16) out = buffer.data();
    }
    benchmark::DoNotOptimize(buffer.data());
    benchmark::ClobberMemory();
  };
  const auto writeAll = [&] {
    writeFrames(evaluation, options, [](std::string_view piece) {
      benchmark::DoNotOptimize(piece.data());
      return true;
    });
  };
  const auto seconds = [](const auto& work) {
    const double start = processorSeconds();
    work();
    return processorSeconds() - start;
  };
  // The quickest of each: what is measured besides is other programs.
  std::array<double, 3> least{1e9, 1e9, 1e9};
  for (auto _ : state) {
    least[0] = std::min(least[0], seconds([&] { walkAll(evaluation); }));
    least[1] = std::min(least[1], seconds(formatAll));
    const double both = seconds(writeAll);
    least[2] = std::min(least[2], both);
    state.SetIterationTime(both);
  }
  const auto count = static_cast<double>(frames.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(frames.size()));
  state.counters["best_ns_a_frame"] = least[2] * 1e9 / count;
  state.counters["to_parts"] = least[2] / (least[0] + least[1]);
  bench::setLimit(state, 1000.0 * count);
}
BENCHMARK_CAPTURE(writeFrames, text, frameFormat("vides"), pyramid())->UseManualTime();
BENCHMARK_CAPTURE(writeFrames, csv, frameFormat("csv"), pyramid())->UseManualTime();
BENCHMARK_CAPTURE(writeFrames, textThousandKeys, frameFormat("vides"), longFlight(1000))
    ->UseManualTime();
BENCHMARK_CAPTURE(writeFrames, csvThousandKeys, frameFormat("csv"), longFlight(1000))
    ->UseManualTime();

void frameByNumber(benchmark::State& state) {
  const Evaluation evaluation(longFlight(state.range(0)));
  std::mt19937_64 random{12};
  std::uniform_int_distribution<std::int64_t> any{0, evaluation.frameCount() - 1};
  std::vector<std::int64_t> numbers(std::size_t{1} << 16);
  for (auto& n : numbers) n = any(random);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(evaluation.frame(numbers[i]));
    i = (i + 1) % numbers.size();
  }
  bench::setLimit(state, 1000.0);
}
BENCHMARK(frameByNumber)->Arg(100'000);

// What a drag does for each display frame: one key moved, and all that follows from it.
void moveOneKey(benchmark::State& state) {
  Flight flight = longFlight(state.range(0));
  Evaluation evaluation(flight);
  std::mt19937_64 random{13};
  // A key that has all its neighbours: near an end there is less to do, which is the case for most
  // keys of ten and for hardly one of 100,000.
  std::uniform_int_distribution<std::size_t> any{3, flight.keys.size() - 4};
  std::uniform_real_distribution<double> around{-0.1, 0.1};
  std::vector<std::size_t> keys(4096);
  for (auto& k : keys) k = any(random);
  std::size_t i = 0;
  for (auto _ : state) {
    // A drag stays at its key for a while.
    const std::size_t k = keys[i / 16 % keys.size()];
    ++i;
    Key key = flight.keys[k];
    key.position.y = 0.6 + around(random);
    flight.keys.set(k, std::move(key));
    evaluation = evaluation.updated(flight);
    benchmark::DoNotOptimize(evaluation.frameCount());
  }
  if (state.range(0) == 1000) bench::setLimit(state, 50'000.0);
  if (state.range(0) == 100'000) bench::setPeer(state, "moveOneKey/10");
}
BENCHMARK(moveOneKey)->Arg(10)->Arg(1000)->Arg(100'000);

// Bytes in use, small blocks and mapped ones.
double bytesInUse() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

// The time is that of evaluating all from scratch; `bytes_a_key` is what the evaluation holds
// beyond the flight (bar: 2048 together with it).
void evaluateFlight(benchmark::State& state) {
  const double before = bytesInUse();
  const Flight flight = longFlight(state.range(0));
  const double withFlight = bytesInUse();
  double evaluated = withFlight;
  for (auto _ : state) {
    const Evaluation evaluation(flight);
    evaluated = bytesInUse();
  }
  const auto keys = static_cast<double>(state.range(0));
  state.counters["bytes_a_key"] = (evaluated - withFlight) / keys;
  state.counters["with_flight"] = (evaluated - before) / keys;
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(evaluateFlight)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vides
