// SPDX-License-Identifier: MIT
// The playhead and its playback in real time. The clock is passed in, never read.
#pragma once

#include <cstdint>
#include <optional>

namespace vides {

class Playback {
 public:
  std::int64_t frame() const { return frame_; }
  bool playing() const { return playing_; }
  bool loop() const { return loop_; }
  void setLoop(bool on) { loop_ = on; }

  // Puts the playhead on a frame; playback goes on from there.
  void goTo(std::int64_t frame);
  // From the playhead; from frame 0 where it stands on the last frame.
  void play(std::int64_t frameCount);
  void stop() { playing_ = false; }
  // Moves the playhead to the frame that is due `now` (seconds; the first call after play() is when
  // playback begins). Frames that no picture was drawn for are dropped. Without a loop it stops at
  // the last frame.
  void advance(double now, std::int64_t frameCount, double frameRate);
  // When the next frame is due; nothing while it stands.
  std::optional<double> nextFrameAt(double frameRate) const;

 private:
  std::int64_t frame_ = 0;
  bool playing_ = false;
  bool loop_ = false;
  std::optional<double> startTime_;
  std::int64_t startFrame_ = 0;
  double framesDone_ = 0.0;  // since startTime_, dropped ones too
};

}  // namespace vides
