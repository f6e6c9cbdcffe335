// SPDX-License-Identifier: MIT
// The program in a real window on a screen in memory: how soon it shows something, and what it
// costs while nothing happens.
#include <benchmark/benchmark.h>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

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

// From starting a program to the first picture on the screen.
void start(benchmark::State& state, const std::vector<std::string>& command) {
  const test::Screen screen;
  const Eye eye;
  for (auto _ : state) {
    const auto from = steady_clock::now();
    {
      const test::RunningProcess program(command);
      if (!eye.waitFor(true)) {
        state.SkipWithError("no picture");
        return;
      }
      state.SetIterationTime(duration<double>(steady_clock::now() - from).count());
    }
    if (!eye.waitFor(false)) state.SkipWithError("the picture stays");
  }
}

std::vector<std::string> vides() {
  return {VIDES_PROGRAM, VIDES_SOURCE_DIR "/assets/flights/pyramid.vid"};
}

void startBare(benchmark::State& state) { start(state, {VIDES_BARE_WINDOW}); }
void startVides(benchmark::State& state) {
  start(state, vides());
  bench::setPeer(state, "startBare/iterations:9/manual_time");
}
BENCHMARK(startBare)->UseManualTime()->Iterations(9)->Unit(benchmark::kMillisecond);
BENCHMARK(startVides)->UseManualTime()->Iterations(9)->Unit(benchmark::kMillisecond);

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
