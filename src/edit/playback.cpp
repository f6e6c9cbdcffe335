// SPDX-License-Identifier: MIT
// The playhead's arithmetic.
#include "edit/playback.hpp"

#include <algorithm>
#include <cmath>

#include "math/whole.hpp"

namespace vides {

void Playback::setIn(std::int64_t frame) {
  in_ = frame;
  if (out_ && *out_ < frame) out_.reset();
}

void Playback::setOut(std::int64_t frame) {
  out_ = frame;
  if (in_ && *in_ > frame) in_.reset();
}

void Playback::clearRange() {
  in_.reset();
  out_.reset();
}

Playback::Span Playback::span(std::int64_t frameCount) const {
  const std::int64_t end = frameCount - 1;
  return {std::min(in_.value_or(0), end), std::min(out_.value_or(end), end)};
}

void Playback::setSpeed(double speed) {
  speed_ = speed;
  goTo(frame_);  // what was played at another speed no longer counts
}

void Playback::goTo(std::int64_t frame) {
  frame_ = frame;
  startFrame_ = frame;
  framesDone_ = 0.0;
  startTime_.reset();
}

void Playback::play(std::int64_t frameCount) {
  const Span range = span(frameCount);
  goTo(frame_ >= range.first && frame_ < range.last ? frame_ : range.first);
  playing_ = true;
}

void Playback::advance(double now, std::int64_t frameCount, double frameRate) {
  if (!playing_) return;
  if (!startTime_) {
    startTime_ = now;
    startFrame_ = frame_;
  }
  // A frame that is due within rounding of the clock is due.
  const double due = std::max(0.0, std::floor((now - *startTime_) * frameRate * speed_ + 1e-6));
  framesDone_ = due;
  const Span range = span(frameCount);
  const std::int64_t end = startFrame_ > range.last ? frameCount - 1 : range.last;
  const double left = static_cast<double>(end - startFrame_);
  if (due <= left && (loop_ || due < left)) {
    frame_ = startFrame_ + wholeWithin(due, 0, frameCount);
  } else if (loop_) {
    const auto length = static_cast<double>(range.last - range.first + 1);
    frame_ = range.first + wholeWithin(std::fmod(due - left - 1.0, length), 0, frameCount);
  } else {
    frame_ = end;
    playing_ = false;
  }
}

std::optional<double> Playback::nextFrameAt(double frameRate) const {
  if (!playing_) return std::nullopt;
  if (!startTime_) return 0.0;
  return *startTime_ + (framesDone_ + 1.0) / (frameRate * speed_);
}

}  // namespace vides
