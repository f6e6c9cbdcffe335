// SPDX-License-Identifier: MIT
// What the graphs show of a flight, kept until the flight changes: VPN path, speeds, measures.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "evaluate/evaluation.hpp"
#include "evaluate/quality.hpp"
#include "panels/sphere_path.hpp"

namespace vides {

// Speed and angular speed along the timeline, each sample the mean over its stretch.
struct SpeedStrip {
  // Sample i is that of the frames (first + i) · framesPerSample to (first + i + 1) ·
  // framesPerSample.
  std::int64_t first = 0;
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

  // The way of the VPN, not farther from the exact one than `tolerance` radii; of `current`'s
  // section in any case.
  const SpherePath& path(const OrientationPlace& current, double tolerance);

  // Samples so far apart, from the one numbered `first` on. Those that were there at the last call
  // are kept, so that scrolling measures only what comes into sight. Where several frames share a
  // sample, and the flight is not yet measured (or has more than kMostSums frames and samples are
  // finer than the sums), they are estimated from some of the frames.
  const SpeedStrip& strip(std::int64_t first, double framesPerSample, int samples);

  // What the camera does from a frame to the next (at the last one, up to it), and the most of it:
  // as far as it is known, of what the strip shows while the flight is measured.
  struct Rates {
    double speed = 0.0;  // cube units per second
    double turn = 0.0;   // degrees per second
  };
  Rates ratesAt(std::int64_t frame) const;
  Rates most() const;

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
  static constexpr std::int64_t kMostSums = 1 << 18;
  // What the camera has done: way in cube units, turn in degrees.
  struct Motion {
    double way = 0.0, turn = 0.0;
    Motion& operator+=(const Motion& o) {
      way += o.way, turn += o.turn;
      return *this;
    }
  };
  static Motion between(const Camera& a, const Camera& b);
  void measurePortion();
  // From the start up to a frame, linear between the sums.
  Motion upTo(double frame) const;
  // In the stretch of a sample; `from` is the camera at its start and becomes that at its end.
  Motion within(double begin, double end, std::optional<Camera>& from) const;
  Motion estimated(double begin, double end) const;

  std::optional<Evaluation> evaluation_;
  SpherePath path_;
  SpeedStrip strip_;
  std::optional<Quality> quality_;
  std::optional<FrameWalk> walk_;
  std::optional<Frame> lastFrame_;
  Quality soFar_;
  bool asked_ = false;        // since the last follow()
  std::vector<Motion> sums_;  // up to every sumEvery_-th frame
  std::int64_t sumEvery_ = 1;
  Motion sum_;
};

}  // namespace vides
