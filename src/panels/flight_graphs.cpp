// SPDX-License-Identifier: MIT
// What the graphs show of a flight.
#include "panels/flight_graphs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vides {
namespace {

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace

void FlightGraphs::follow(const Evaluation& evaluation) {
  if (!evaluation_ || !(evaluation_->flight() == evaluation.flight())) {
    evaluation_ = evaluation;
    path_.clear();
    strip_ = {};
    quality_.reset();
    soFar_ = {};
    lastFrame_.reset();
    walk_.emplace(*evaluation_);
    asked_ = true;
  }
  if (measuring()) measurePortion();
  asked_ = false;
}

void FlightGraphs::finish(const std::function<void(std::int64_t, std::int64_t)>& report) {
  while (measuring()) {
    measurePortion();
    if (walk_) report(walk_->position(), walk_->last());
  }
}

void FlightGraphs::measurePortion() {
  const double fps = evaluation_->flight().frameRate;
  Frame frame;
  for (std::int64_t i = 0; i < kPortion; ++i) {
    if (!walk_->next(frame)) {
      quality_ = soFar_;
      walk_.reset();
      return;
    }
    if (lastFrame_) {
      const Vec3 step = frame.camera.viewReferencePoint - lastFrame_->camera.viewReferencePoint;
      soFar_.maxSpeed = std::max(soFar_.maxSpeed, glm::length(step) * fps);
      const double angle = rotationBetween(lastFrame_->camera, frame.camera);
      soFar_.maxAngularSpeed = std::max(soFar_.maxAngularSpeed, degrees(angle) * fps);
    }
    lastFrame_ = frame;
  }
}

const std::vector<FlightGraphs::PathPoint>& FlightGraphs::path() {
  if (!path_.empty()) return path_;
  const std::int64_t last = evaluation_->frameCount() - 1;
  const std::int64_t points = std::min(kMostPath, last + 1);
  for (std::int64_t i = 0; i < points; ++i) {
    const std::int64_t n = points == 1 ? 0 : last * i / (points - 1);
    path_.push_back({evaluation_->frame(n).camera.viewPlaneNormal, n});
  }
  return path_;
}

const SpeedStrip& FlightGraphs::strip(std::int64_t first, double framesPerSample, int samples) {
  const auto wanted = static_cast<std::size_t>(std::max(samples, 0));
  const bool sameSteps = strip_.framesPerSample == framesPerSample;
  if (!strip_.speed.empty() && sameSteps && strip_.first == first &&
      strip_.speed.size() == wanted) {
    return strip_;
  }
  SpeedStrip old;
  std::swap(old, strip_);
  strip_.first = first;
  strip_.framesPerSample = framesPerSample;
  strip_.speed.reserve(wanted);
  strip_.angularSpeed.reserve(wanted);
  const double fps = evaluation_->flight().frameRate;
  const std::int64_t last = evaluation_->frameCount() - 1;
  std::optional<std::int64_t> before;
  for (std::int64_t i = first; i < first + samples; ++i) {
    const auto n = std::clamp<std::int64_t>(
        static_cast<std::int64_t>(std::floor(static_cast<double>(i) * framesPerSample)), 0,
        std::max<std::int64_t>(0, last - 1));
    const auto there = static_cast<std::size_t>(i - old.first);
    if (sameSteps && i >= old.first && there < old.speed.size()) {
      strip_.speed.push_back(old.speed[there]);
      strip_.angularSpeed.push_back(old.angularSpeed[there]);
    } else if (before == n) {  // zoomed in: several samples a frame
      strip_.speed.push_back(strip_.speed.back());
      strip_.angularSpeed.push_back(strip_.angularSpeed.back());
    } else {
      const Camera a = evaluation_->frame(n).camera;
      const Camera b = evaluation_->frame(std::min(n + 1, last)).camera;
      const Vec3 step = b.viewReferencePoint - a.viewReferencePoint;
      strip_.speed.push_back(static_cast<float>(glm::length(step) * fps));
      strip_.angularSpeed.push_back(static_cast<float>(degrees(rotationBetween(a, b)) * fps));
    }
    before = n;
  }
  for (const float v : strip_.speed) strip_.mostSpeed = std::max(strip_.mostSpeed, v);
  for (const float v : strip_.angularSpeed) {
    strip_.mostAngularSpeed = std::max(strip_.mostAngularSpeed, v);
  }
  return strip_;
}

}  // namespace vides
