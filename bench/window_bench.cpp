// SPDX-License-Identifier: MIT
// The program in a real window on a screen in memory: how soon it shows something, and what it
// costs while nothing happens.
#include <benchmark/benchmark.h>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bars.hpp"
#include "support/process.hpp"
#include "support/screen.hpp"

namespace vides {
namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience(60);
// Of the screen; within the menu bar, on its ground.
constexpr int kProbe = 6;

class Eye {
 public:
  Eye() : display_(XOpenDisplay(nullptr)) {}
  Eye(const Eye&) = delete;
  Eye& operator=(const Eye&) = delete;
  ~Eye() {
    if (display_ != nullptr) XCloseDisplay(display_);
  }

  // Until something is on the screen that is not black, or is black again. False: it lasts too
  // long.
  bool waitFor(bool picture) const {
    const auto start = steady_clock::now();
    while (display_ != nullptr && steady_clock::now() - start < kPatience) {
      if (lit() == picture) return true;
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    return false;
  }

 private:
  bool lit() const {
    XImage* const image =
        XGetImage(display_, DefaultRootWindow(display_), kProbe, kProbe, 1, 1, AllPlanes, ZPixmap);
    if (image == nullptr) return false;
    const unsigned long value = XGetPixel(image, 0, 0);
    XDestroyImage(image);
    return (value & 0xFFFFFF) != 0;
  }

  Display* display_;
};

std::vector<std::string> vides() {
  return {VIDES_PROGRAM, VIDES_SOURCE_DIR "/assets/flights/pyramid.vid"};
}

// From starting a program to the first picture on the screen, s; nothing where it lasts too long.
std::optional<double> startOf(const std::vector<std::string>& command, const Eye& eye) {
  const auto from = steady_clock::now();
  const test::RunningProcess program(command);
  if (!eye.waitFor(true)) return std::nullopt;
  return duration<double>(steady_clock::now() - from).count();
}

constexpr int kStarts = 9;

struct Starts {
  std::vector<double> bare, vides;  // s; too few where one failed
};

// One of each, again and again, on the same screen: what else the machine does meanwhile, and how
// warm it is, costs both the same. The first pair is for the caches.
Starts measureStarts() {
  const test::Screen screen;
  const Eye eye;
  Starts starts;
  for (int i = -1; i < kStarts; ++i) {
    const auto bare = startOf({VIDES_BARE_WINDOW}, eye);
    const auto own = bare && eye.waitFor(false) ? startOf(vides(), eye) : std::nullopt;
    if (!own || !eye.waitFor(false)) break;
    if (i < 0) continue;
    starts.bare.push_back(*bare);
    starts.vides.push_back(*own);
  }
  return starts;
}

void report(benchmark::State& state, std::vector<double> Starts::*which) {
  static const Starts starts = measureStarts();  // for both rows, whichever is asked for first
  const std::vector<double>& seconds = starts.*which;
  std::size_t i = 0;
  for (auto _ : state) {
    if (i == seconds.size()) {
      state.SkipWithError("no picture, or it stays");
      return;
    }
    state.SetIterationTime(seconds[i++]);
  }
}

void startBare(benchmark::State& state) { report(state, &Starts::bare); }
void startVides(benchmark::State& state) {
  report(state, &Starts::vides);
  bench::setPeer(state, "startBare/iterations:9/manual_time");
}
BENCHMARK(startBare)->UseManualTime()->Iterations(kStarts)->Unit(benchmark::kMillisecond);
BENCHMARK(startVides)->UseManualTime()->Iterations(kStarts)->Unit(benchmark::kMillisecond);

// What all threads of a process have run, s.
double secondsRun(pid_t process) {
  double nanoseconds = 0.0;
  const std::string tasks = "/proc/" + std::to_string(process) + "/task";
  for (const auto& task : std::filesystem::directory_iterator(tasks)) {
    double own = 0.0;
    std::ifstream(task.path() / "schedstat") >> own;
    nanoseconds += own;
  }
  return 1e-9 * nanoseconds;
}

// The processor's time in a second without any event: 1 % of a core is 10 ms.
void idleSecond(benchmark::State& state) {
  const test::Screen screen;
  const Eye eye;
  const test::RunningProcess program(vides());
  if (!eye.waitFor(true)) {
    state.SkipWithError("no picture");
    return;
  }
  std::this_thread::sleep_for(std::chrono::seconds(2));  // its start is over
  for (auto _ : state) {
    const double before = secondsRun(program.id());
    const auto from = steady_clock::now();
    std::this_thread::sleep_for(std::chrono::seconds(1));
    const double wall = duration<double>(steady_clock::now() - from).count();
    state.SetIterationTime((secondsRun(program.id()) - before) / wall);
  }
  bench::setLimit(state, 1e7);
}
BENCHMARK(idleSecond)->UseManualTime()->Iterations(3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vides
