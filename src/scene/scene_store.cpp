// SPDX-License-Identifier: MIT
// Begins readings and finds them again.
#include "scene/scene_store.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace vides {
namespace {

namespace fs = std::filesystem;

// Readings at work at the same time.
constexpr std::size_t kMostAtOnce = 4;
// Kept of what the flight doesn't name any more: for undo and redo.
constexpr std::size_t kMostUnused = 4;
// A display frame or two: small scenes are there in the same one.
constexpr std::chrono::milliseconds kPatience{30};

bool hasFailed(const SharedReading& reading) {
  return reading && reading->result() != nullptr && !*reading->result();
}

}  // namespace

SceneStore::Stamp SceneStore::stampOf(const fs::path& file) {
  Stamp stamp;
  std::error_code error;
  stamp.size = fs::file_size(file, error);
  stamp.time = fs::last_write_time(file, error);
  return stamp;
}

SceneStore::Known* SceneStore::find(const fs::path& file) {
  const auto found = std::ranges::find(known_, file, &Known::file);
  return found != known_.end() ? &*found : nullptr;
}

SharedReading SceneStore::read(const fs::path& file) {
  const Stamp stamp = stampOf(file);
  Known* known = find(file);
  if (known == nullptr) known = &known_.emplace_back(Known{file, stamp, nullptr, false});
  if (!known->reading || !(known->stamp == stamp) || hasFailed(known->reading)) {
    *known = {file, stamp, std::make_shared<SceneReading>(file), false};
  }
  known->told = true;
  const SharedReading reading = known->reading;
  waits_ ? reading->wait() : reading->waitFor(kPatience);
  return reading;
}

void SceneStore::setFiles(const std::vector<fs::path>& files, std::int64_t document) {
  const bool again = document != document_;
  files_ = files;
  document_ = document;
  for (const fs::path& file : files_) {
    const Stamp stamp = stampOf(file);
    const auto known = std::ranges::find(known_, file, &Known::file);
    Known now{file, stamp, nullptr, false};
    if (known != known_.end()) {
      const bool keeps = !again || (known->stamp == stamp && !hasFailed(known->reading));
      if (keeps) now = std::move(*known);
      known_.erase(known);
    }
    known_.push_back(std::move(now));
  }
  // What nobody waits for any more is given up: named again it is begun anew. An import waits for
  // its reading by holding it.
  const auto isUnused = [&](const Known& known) {
    return known.reading.use_count() <= 1 && std::ranges::find(files_, known.file) == files_.end();
  };
  std::erase_if(known_, [&](const Known& known) {
    const bool read = known.reading && known.reading->ended() && !hasFailed(known.reading);
    return isUnused(known) && !read;
  });
  auto unused = static_cast<std::size_t>(std::ranges::count_if(known_, isUnused));
  std::erase_if(known_, [&](const Known& known) {
    return isUnused(known) && unused > kMostUnused && unused-- > 0;
  });
}

void SceneStore::start() {
  std::size_t atWork = reading().size();
  for (Known& known : known_) {
    if (known.reading || (!waits_ && atWork >= kMostAtOnce)) continue;
    known.reading = std::make_shared<SceneReading>(known.file);
    ++atWork;
    if (waits_) known.reading->wait();
  }
}

std::vector<SharedDrawable> SceneStore::scenes(const std::vector<fs::path>& files,
                                               std::int64_t document) {
  const bool changed = files != files_ || document != document_;
  if (changed) setFiles(files, document);
  start();
  if (changed) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    for (const SharedReading& reading : reading()) {
      reading->waitFor(std::chrono::duration_cast<std::chrono::milliseconds>(
          end - std::chrono::steady_clock::now()));
    }
  }
  std::vector<SharedDrawable> result;
  for (const fs::path& file : files_) {
    Known& known = *find(file);
    const SceneReading::Result* const read = known.reading ? known.reading->result() : nullptr;
    if (read == nullptr) continue;
    if (*read) result.push_back(**read);
    if (std::exchange(known.told, true)) continue;
    if (!*read) {
      refused_.push_back(known.reading);
    } else if (!(**read)->report().notes.empty()) {
      noted_.push_back(known.reading);
    }
  }
  return result;
}

SharedReading SceneStore::readingOf(const fs::path& file) const {
  const auto known = std::ranges::find(known_, file, &Known::file);
  return known != known_.end() ? known->reading : nullptr;
}

void SceneStore::readAgain(const fs::path& file) {
  Known* const known = find(file);
  if (known == nullptr) return;
  if (known->reading && !known->reading->ended()) {
    known->reading->cancel();
    leaving_.push_back(std::move(known->reading));
  }
  *known = {file, stampOf(file), nullptr, false};
}

std::vector<fs::path> SceneStore::changedOnDisk() const {
  std::vector<fs::path> changed;
  for (const Known& known : known_) {
    if (!known.reading || !known.reading->ended()) continue;
    const bool named = std::ranges::find(files_, known.file) != files_.end();
    if (named && !(stampOf(known.file) == known.stamp)) changed.push_back(known.file);
  }
  return changed;
}

std::vector<SharedReading> SceneStore::takeRefused() { return std::exchange(refused_, {}); }

std::vector<SharedReading> SceneStore::takeNoted() { return std::exchange(noted_, {}); }

std::vector<SharedReading> SceneStore::reading() const {
  std::vector<SharedReading> result;
  for (const Known& known : known_) {
    if (known.reading && !known.reading->ended()) result.push_back(known.reading);
  }
  return result;
}

void SceneStore::cancel() {
  for (const SharedReading& each : reading()) each->cancel();
}

}  // namespace vides
