// SPDX-License-Identifier: MIT
// What the graphs show of a flight, kept until the flight changes: VPN path, speeds, measures.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "evaluate/evaluation.hpp"
#include "evaluate/quality.hpp"

namespace vides {

// Speed and angular speed at places of the timeline.
struct SpeedStrip {
  std::int64_t first = 0;  // sample i is that of the frame (first + i) · framesPerSample
  double framesPerSample = 1.0;
  std::vector<float> speed;         // cube units per second
  std::vector<float> angularSpeed;  // degrees per second
  float mostSpeed = 0.0f;
  float mostAngularSpeed = 0.0f;
};

class FlightGraphs {
 public:
  // Call once a display frame, before the rest. Frames of a long flight are measured in portions,
  // for as long as the measures are asked for: the first at once, the others where they are shown.
  void follow(const Evaluation& evaluation);

  // The VPN on the unit sphere, at most kMostPath places over the whole flight, and the section
  // that each belongs to.
  struct PathPoint {
    Vec3 direction{0.0};
    std::int64_t frame = 0;
  };
  static constexpr std::int64_t kMostPath = 720;
  const std::vector<PathPoint>& path();

  // Samples so far apart, from the one numbered `first` on. Those that were there at the last call
  // are kept, so that scrolling measures only what comes into sight.
  const SpeedStrip& strip(std::int64_t first, double framesPerSample, int samples);

  // Nothing while it is still being measured.
  const std::optional<Quality>& quality() {
    asked_ = true;
    return quality_;
  }
  // Whether another display frame is wanted to go on measuring.
  bool measuring() const { return asked_ && !quality_; }
  // Measures all that is asked for and missing, and reports frames done and frames altogether.
  void finish(const std::function<void(std::int64_t, std::int64_t)>& report);

 private:
  // Frames that are measured in a display frame: about a millisecond's.
  static constexpr std::int64_t kPortion = 4000;
  void measurePortion();

  std::optional<Evaluation> evaluation_;
  std::vector<PathPoint> path_;
  SpeedStrip strip_;
  std::optional<Quality> quality_;
  std::optional<FrameWalk> walk_;
  std::optional<Frame> lastFrame_;
  Quality soFar_;
  bool asked_ = false;  // since the last follow()
};

}  // namespace vides
