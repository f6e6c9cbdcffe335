// SPDX-License-Identifier: MIT
// When unsaved work is written, removed and offered.
#include "app/recovery_keeper.hpp"

#include <ctime>

namespace vides {
namespace {

// From the first edit that isn't on the disk to its writing: long enough that a drag is written a
// few times only, and with room for a slow disk below the five seconds that are promised.
constexpr double kDelay = 2.0;

std::string clockTime(std::int64_t seconds) {
  const auto time = static_cast<std::time_t>(seconds);
  std::tm local{};
  char text[32] = {};
  if (localtime_r(&time, &local) == nullptr) return {};
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &local);
  return text;
}

}  // namespace

RecoveryKeeper::RecoveryKeeper(BackgroundWriter& writer, std::filesystem::path folder)
    : writer_(writer),
      folder_(std::move(folder)),
      own_(folder_.empty() ? nullptr : std::make_shared<RecoveryFile>(folder_)) {}

void RecoveryKeeper::offer(Session& session) {
  if (!own_) return;
  left_ = RecoveryFile::abandoned(folder_);
  askNext(session);
}

void RecoveryKeeper::askNext(Session& session) {
  while (!left_.empty()) {
    if (auto work = left_.front()->read()) {
      session.offerRecovery(std::move(work->flight), std::move(work->path), clockTime(work->time));
      return;
    }
    // Nobody can do anything with it, but it isn't ours to throw away.
    left_.erase(left_.begin());
  }
}

void RecoveryKeeper::takeAnswer(Session& session) {
  const auto answer = session.takeRecoveryAnswer();
  if (!answer || left_.empty()) return;
  if (*answer == RecoveryAnswer::kRecover) {
    // From now on it is this editor's, until the work is saved or given up.
    own_ = std::move(left_.front());
    written_ = true;
    kept_ = session.flight();
    keptPath_ = session.path();
    left_.clear();
    return;
  }
  if (*answer == RecoveryAnswer::kForget) left_.front()->remove();
  left_.erase(left_.begin());
  askNext(session);
}

std::optional<double> RecoveryKeeper::follow(Session& session, double now) {
  if (!own_) return std::nullopt;
  takeAnswer(session);
  if (!session.modified()) {
    dueAt_.reset();
    if (written_) writer_.post("recovery", [own = own_] { own->remove(); });
    written_ = false;
    kept_.reset();
    return std::nullopt;
  }
  if (kept_ && keptPath_ == session.path() && *kept_ == session.flight()) {
    dueAt_.reset();
    return std::nullopt;
  }
  if (!dueAt_) dueAt_ = now + kDelay;
  if (now < *dueAt_) return *dueAt_ - now;
  write(session);
  return std::nullopt;
}

void RecoveryKeeper::write(const Session& session) {
  dueAt_.reset();
  written_ = true;
  kept_ = session.flight();
  keptPath_ = session.path();
  writer_.post("recovery", [own = own_, flight = *kept_, path = keptPath_] {
    // What can't be kept here can be saved all the same, and that will tell.
    static_cast<void>(own->write(flight, path));
  });
}

bool RecoveryKeeper::keepNow(const Session& session) {
  const bool unsaved = own_ && session.modified();
  if (unsaved) write(session);
  writer_.finish();
  return unsaved;
}

void RecoveryKeeper::close() {
  if (own_ && written_) writer_.post("recovery", [own = own_] { own->remove(); });
  writer_.finish();
}

}  // namespace vides
