// SPDX-License-Identifier: MIT
// The playhead's arithmetic.
#include "edit/playback.hpp"

#include <algorithm>
#include <cmath>

#include "math/whole.hpp"

namespace vides {

void Playback::goTo(std::int64_t frame) {
  frame_ = frame;
  startFrame_ = frame;
  framesDone_ = 0.0;
  startTime_.reset();
}

void Playback::play(std::int64_t frameCount) {
  goTo(frame_ >= frameCount - 1 ? 0 : frame_);
  playing_ = true;
}

void Playback::advance(double now, std::int64_t frameCount, double frameRate) {
  if (!playing_) return;
  if (!startTime_) {
    startTime_ = now;
    startFrame_ = frame_;
  }
  // A frame that is due within rounding of the clock is due.
  const double due = std::max(0.0, std::floor((now - *startTime_) * frameRate + 1e-6));
  framesDone_ = due;
  if (loop_) {
    const double place =
        std::fmod(static_cast<double>(startFrame_) + due, static_cast<double>(frameCount));
    frame_ = wholeWithin(place, 0, frameCount - 1);
    return;
  }
  const double left = static_cast<double>(frameCount - 1 - startFrame_);
  frame_ = startFrame_ + wholeWithin(std::min(due, left), 0, frameCount - 1);
  if (due >= left) {
    frame_ = frameCount - 1;
    playing_ = false;
  }
}

std::optional<double> Playback::nextFrameAt(double frameRate) const {
  if (!playing_) return std::nullopt;
  if (!startTime_) return 0.0;
  return *startTime_ + (framesDone_ + 1.0) / frameRate;
}

}  // namespace vides
