// SPDX-License-Identifier: MIT
// A thread that reads one scene.
#include "scene/scene_reading.hpp"

#include <new>
#include <system_error>
#include <utility>

namespace vides {
namespace {

// Of all the work, what reading is taken for; making it ready for drawing is the rest.
constexpr double kReadingShare = 0.6;

}  // namespace

SceneReading::SceneReading(std::filesystem::path file)
    : file_(std::move(file)), thread_([this] {
        Result result = read();
        const std::lock_guard lock(mutex_);
        result_ = std::move(result);
        done_.notify_all();
      }) {}

SceneReading::~SceneReading() {
  cancel();
  thread_.join();
}

SceneReading::Result SceneReading::read() {
  const auto keepGoing = [this](double from, double to) {
    return [this, from, to](double share) {
      share_ = from + (to - from) * share;
      return !cancelled_;
    };
  };
  try {
    const ReadScene scene = readSceneFile(file_, keepGoing(0.0, kReadingShare));
    if (!scene) return tl::unexpected(scene.error());
    auto drawable = DrawableScene::make(*scene, keepGoing(kReadingShare, 1.0));
    if (!drawable) return tl::unexpected(SceneProblem{SceneFault::kCancelled, 0, ""});
    return drawable;
  } catch (const std::bad_alloc&) {
    const auto reason = std::make_error_code(std::errc::not_enough_memory).message();
    return tl::unexpected(SceneProblem{SceneFault::kUnreadable, 0, reason});
  }
}

bool SceneReading::ended() const {
  const std::lock_guard lock(mutex_);
  return result_.has_value();
}

void SceneReading::wait() const {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return result_.has_value(); });
}

void SceneReading::waitFor(std::chrono::milliseconds time) const {
  std::unique_lock lock(mutex_);
  done_.wait_for(lock, time, [&] { return result_.has_value(); });
}

}  // namespace vides
