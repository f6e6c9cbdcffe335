// SPDX-License-Identifier: MIT
// A thread that reads one scene.
#include "scene/scene_reading.hpp"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace vides {
namespace {

// Of all the work, what reading is taken for; making it ready for drawing is the rest.
constexpr double kReadingShare = 0.6;

tl::unexpected<SceneProblem> unreadable(std::string why) {
  return tl::unexpected(SceneProblem{SceneFault::kUnreadable, 0, std::move(why)});
}

}  // namespace

// What the thread and whoever waits for it have in common: it lives as long as either.
struct SceneReading::Work {
  explicit Work(std::filesystem::path path) : file(std::move(path)) {}

  const std::filesystem::path file;
  std::atomic<double> share{0.0};
  std::atomic<bool> cancelled{false};
  std::mutex mutex;
  std::condition_variable done;
  // Set once, under the mutex; not changed from then on.
  std::optional<Result> result;

  Result read();
  void end(Result how);
};

SceneReading::Result SceneReading::Work::read() {
  const auto keepGoing = [this](double from, double to) {
    return [this, from, to](double part) {
      share = from + (to - from) * part;
      return !cancelled;
    };
  };
  try {
    const ReadScene scene = readSceneFile(file, keepGoing(0.0, kReadingShare));
    if (!scene) return tl::unexpected(scene.error());
    auto drawable = DrawableScene::make(*scene, keepGoing(kReadingShare, 1.0));
    if (!drawable) return tl::unexpected(SceneProblem{SceneFault::kCancelled, 0, ""});
    return drawable;
  } catch (const std::bad_alloc&) {
    return unreadable(std::make_error_code(std::errc::not_enough_memory).message());
  } catch (const std::exception& error) {
    return unreadable(error.what());
  }
}

void SceneReading::Work::end(Result how) {
  const std::lock_guard lock(mutex);
  result = std::move(how);
  done.notify_all();
}

SceneReading::SceneReading(std::filesystem::path file)
    : work_(std::make_shared<Work>(std::move(file))) {
  try {
    // Nobody waits for its end: a disk that doesn't answer would keep the window.
    std::thread([work = work_] { work->end(work->read()); }).detach();
  } catch (const std::system_error& error) {
    work_->end(unreadable(error.code().message()));  // no thread is left
  }
}

SceneReading::~SceneReading() { cancel(); }

const std::filesystem::path& SceneReading::file() const { return work_->file; }
double SceneReading::share() const { return work_->share; }
void SceneReading::cancel() { work_->cancelled = true; }

bool SceneReading::ended() const {
  const std::lock_guard lock(work_->mutex);
  return work_->result.has_value();
}

const SceneReading::Result* SceneReading::result() const {
  return ended() ? &*work_->result : nullptr;
}

void SceneReading::wait() const {
  std::unique_lock lock(work_->mutex);
  work_->done.wait(lock, [&] { return work_->result.has_value(); });
}

void SceneReading::waitFor(std::chrono::milliseconds time) const {
  std::unique_lock lock(work_->mutex);
  work_->done.wait_for(lock, time, [&] { return work_->result.has_value(); });
}

}  // namespace vides
