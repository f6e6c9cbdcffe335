// SPDX-License-Identifier: MIT
// A queue and the thread that empties it.
#include "app/background_writer.hpp"

#include <algorithm>
#include <exception>

namespace vides {

BackgroundWriter::BackgroundWriter() : thread_([this] { run(); }) {}

BackgroundWriter::~BackgroundWriter() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundWriter::post(std::string name, std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    const auto same = std::find_if(waiting_.begin(), waiting_.end(),
                                   [&](const auto& other) { return other.first == name; });
    if (same != waiting_.end()) waiting_.erase(same);
    waiting_.emplace_back(std::move(name), std::move(job));
  }
  changed_.notify_all();
}

void BackgroundWriter::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.empty() && !running_; });
}

void BackgroundWriter::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return !waiting_.empty() || ending_; });
    if (waiting_.empty()) return;
    {
      const std::function<void()> job = std::move(waiting_.front().second);
      waiting_.pop_front();
      running_ = true;
      lock.unlock();
      try {
        job();
      } catch (const std::exception&) {
        // There is nobody to tell here; what it should have written is written with the next one.
      }
    }
    lock.lock();
    running_ = false;
    changed_.notify_all();
  }
}

}  // namespace vides
