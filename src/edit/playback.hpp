// SPDX-License-Identifier: MIT
// The playhead and its playback in real time, all of the flight or a range of it, at a speed. The
// clock is passed in, never read.
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

  // The first and the last frame that are played: in point and out point, where they are set. A
  // point on the wrong side of the other takes that one away. They stay while the flight becomes
  // shorter; what lies beyond its end counts as its last frame.
  const std::optional<std::int64_t>& in() const { return in_; }
  const std::optional<std::int64_t>& out() const { return out_; }
  void setIn(std::int64_t frame);
  void setOut(std::int64_t frame);
  void clearRange();
  struct Span {
    std::int64_t first = 0, last = 0;
  };
  Span span(std::int64_t frameCount) const;

  // Times the flight's frame rate, above 0.
  double speed() const { return speed_; }
  void setSpeed(double speed);

  // Puts the playhead on a frame; playback goes on from there.
  void goTo(std::int64_t frame);
  // From the playhead; from the span's first frame where it stands outside or on its last one.
  void play(std::int64_t frameCount);
  void stop() { playing_ = false; }
  // Moves the playhead to the frame that is due `now` (seconds; the first call after play() is when
  // playback begins). Frames that no picture was drawn for are dropped. Without a loop it stops at
  // the span's last frame. A playhead put behind the span plays on to the flight's end.
  void advance(double now, std::int64_t frameCount, double frameRate);
  // When the next frame is due; nothing while it stands.
  std::optional<double> nextFrameAt(double frameRate) const;

 private:
  std::int64_t frame_ = 0;
  bool playing_ = false;
  bool loop_ = false;
  double speed_ = 1.0;
  std::optional<std::int64_t> in_, out_;
  std::optional<double> startTime_;
  std::int64_t startFrame_ = 0;
  double framesDone_ = 0.0;  // since startTime_, dropped ones too
};

}  // namespace vides
