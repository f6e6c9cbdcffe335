// SPDX-License-Identifier: MIT
// The signals that ask the program to end: SIGTERM, SIGHUP (the terminal is gone, the user logs
// out) and SIGINT. The editor ends on them like on its own Quit, but asks nothing: what is unsaved
// is kept for the next start.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace vides {

// From construction to destruction. To be constructed before any other thread, so that none of them
// gets the signals. Those that are ignored (nohup) stay ignored.
class EndSignals {
 public:
  EndSignals();
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  // Until now a signal ends the process at once. From now on the first one only calls `wake`, from
  // another thread; a second one, should the first take too long, ends the process. An empty `wake`
  // takes that back.
  void leaveTo(std::function<void()> wake);
  // The first signal since then; 0 where there was none.
  int came() const { return came_; }
  // Does what the signal would have done without us: the parent sees what ended the process.
  [[noreturn]] void finish();

 private:
  void watch();
  void onSignal(int signal);

  std::atomic<int> came_ = 0;
  std::mutex mutex_;
  std::function<void()> wake_;  // empty: not left to anybody
  int signals_ = -1;            // descriptors
  int stop_ = -1;
  std::thread thread_;  // last: it uses the others
};

}  // namespace vides
