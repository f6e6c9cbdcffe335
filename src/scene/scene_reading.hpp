// SPDX-License-Identifier: MIT
// Reads a scene file and makes it ready for drawing, in a thread of its own.
//
// All functions belong to the thread that made it.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "scene/drawable_scene.hpp"

namespace vides {

class SceneReading {
 public:
  using Result = tl::expected<SharedDrawable, SceneProblem>;

  // Begins at once.
  explicit SceneReading(std::filesystem::path file);
  // Cancels what isn't done and waits for it.
  ~SceneReading();
  SceneReading(const SceneReading&) = delete;
  SceneReading& operator=(const SceneReading&) = delete;

  const std::filesystem::path& file() const { return file_; }
  // 0 to 1.
  double share() const { return share_; }
  // It ends soon after, refused with SceneFault::kCancelled, unless it is done already.
  void cancel() { cancelled_ = true; }
  bool ended() const;
  // Nothing while it reads.
  const Result* result() const { return ended() ? &*result_ : nullptr; }
  void wait() const;
  // At most so long.
  void waitFor(std::chrono::milliseconds time) const;

 private:
  Result read();

  const std::filesystem::path file_;
  std::atomic<double> share_{0.0};
  std::atomic<bool> cancelled_{false};
  mutable std::mutex mutex_;
  mutable std::condition_variable done_;
  // Set once, under the mutex; not changed from then on.
  std::optional<Result> result_;
  std::thread thread_;  // the last member: it uses the others
};
using SharedReading = std::shared_ptr<SceneReading>;

}  // namespace vides
