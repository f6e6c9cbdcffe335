// SPDX-License-Identifier: MIT
// Writes files beside the editor: the window never waits for a disk.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace vides {

// Jobs run one after the other on a thread of their own, in the order of their posting.
class BackgroundWriter {
 public:
  BackgroundWriter();
  // Runs what is still waiting.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  // A job of that name that still waits is replaced: only the newest state of a file is worth
  // writing. What a job throws ends that job.
  void post(std::string name, std::function<void()> job);
  // Returns when everything posted has run.
  void finish();

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::pair<std::string, std::function<void()>>> waiting_;
  bool running_ = false;  // a job
  bool ending_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace vides
