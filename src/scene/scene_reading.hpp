// SPDX-License-Identifier: MIT
// Reads a scene file and makes it ready for drawing, in a thread of its own.
//
// All functions belong to the thread that made it, and only wait() and waitFor() ever wait.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/drawable_scene.hpp"

namespace vides {

class SceneReading {
 public:
  using Result = tl::expected<SharedDrawable, SceneProblem>;

  // Begins at once. Where the system has no thread left it has ended, and says so. Whatever the
  // thread runs into is a result, too.
  explicit SceneReading(std::filesystem::path file);
  // Cancels what isn't done, and leaves it to end by itself.
  ~SceneReading();
  SceneReading(const SceneReading&) = delete;
  SceneReading& operator=(const SceneReading&) = delete;

  const std::filesystem::path& file() const;
  // 0 to 1.
  double share() const;
  // It ends soon after, refused with SceneFault::kCancelled, unless it is done already.
  void cancel();
  bool ended() const;
  // Nothing while it reads.
  const Result* result() const;
  void wait() const;
  // At most so long.
  void waitFor(std::chrono::milliseconds time) const;

 private:
  struct Work;
  std::shared_ptr<Work> work_;
};
using SharedReading = std::shared_ptr<SceneReading>;

}  // namespace vides
