// SPDX-License-Identifier: MIT
// What the graphs show of a flight.
#include "panels/flight_graphs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "math/whole.hpp"

namespace vides {
namespace {

// Samples finer than this are measured between frames.
constexpr double kFinest = 1.0;

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace

void FlightGraphs::follow(const Evaluation& evaluation) {
  if (!evaluation_ || !(evaluation_->flight() == evaluation.flight())) {
    evaluation_ = evaluation;
    strip_ = {};
    quality_.reset();
    soFar_ = {};
    lastFrame_.reset();
    sum_ = {};
    sums_.clear();
    sumEvery_ = 1 + evaluation.frameCount() / kMostSums;
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

FlightGraphs::Motion FlightGraphs::between(const Camera& a, const Camera& b) {
  return {glm::distance(a.viewReferencePoint, b.viewReferencePoint),
          degrees(rotationBetween(a, b))};
}

void FlightGraphs::measurePortion() {
  const double fps = evaluation_->flight().frameRate;
  Frame frame;
  for (std::int64_t i = 0; i < kPortion; ++i) {
    if (!walk_->next(frame)) {
      quality_ = soFar_;
      sums_.push_back(sum_);
      walk_.reset();
      // What was only estimated is known now.
      strip_ = {};
      return;
    }
    if (lastFrame_) {
      const Motion step = between(lastFrame_->camera, frame.camera);
      soFar_.maxSpeed = std::max(soFar_.maxSpeed, step.way * fps);
      soFar_.maxAngularSpeed = std::max(soFar_.maxAngularSpeed, step.turn * fps);
      sum_ += step;
    }
    if (frame.number % sumEvery_ == 0) sums_.push_back(sum_);
    lastFrame_ = frame;
  }
}

FlightGraphs::Motion FlightGraphs::upTo(double frame) const {
  const double place = frame / static_cast<double>(sumEvery_);
  const auto before =
      static_cast<std::size_t>(wholeWithin(place, 0, static_cast<std::int64_t>(sums_.size())));
  if (before + 1 >= sums_.size()) return sums_.back();
  const Motion &a = sums_[before], &b = sums_[before + 1];
  const double share = place - static_cast<double>(before);
  return {a.way + share * (b.way - a.way), a.turn + share * (b.turn - a.turn)};
}

// Cut at whole frames, where a section may end.
FlightGraphs::Motion FlightGraphs::within(double begin, double end,
                                          std::optional<Camera>& from) const {
  if (!from) from = evaluation_->cameraBetween(begin);
  Motion motion;
  for (double at = begin; at < end;) {
    const double next = std::min(end, std::floor(at) + 1.0);
    const Camera to = evaluation_->cameraBetween(next);
    motion += between(*from, to);
    from = to;
    at = next;
  }
  return motion;
}

FlightGraphs::Motion FlightGraphs::estimated(double begin, double end) const {
  constexpr int kPairs = 2;
  Motion motion;
  for (int i = 0; i < kPairs; ++i) {
    const double n = std::floor(begin + (end - begin) * (i + 0.5) / kPairs);
    motion += between(evaluation_->cameraBetween(n), evaluation_->cameraBetween(n + 1.0));
  }
  const double share = (end - begin) / kPairs;
  return {share * motion.way, share * motion.turn};
}

FlightGraphs::Rates FlightGraphs::ratesAt(std::int64_t frame) const {
  const std::int64_t last = evaluation_->frameCount() - 1;
  const std::int64_t from = std::clamp<std::int64_t>(frame, 0, std::max<std::int64_t>(0, last - 1));
  const Motion step = between(evaluation_->frame(from).camera, evaluation_->frame(from + 1).camera);
  const double fps = evaluation_->flight().frameRate;
  return {step.way * fps, step.turn * fps};
}

FlightGraphs::Rates FlightGraphs::most() const {
  if (quality_) return {quality_->maxSpeed, quality_->maxAngularSpeed};
  return {static_cast<double>(strip_.mostSpeed), static_cast<double>(strip_.mostAngularSpeed)};
}

const SpherePath& FlightGraphs::path(const OrientationPlace& current, double tolerance) {
  path_.follow(*evaluation_, current, tolerance);
  return path_;
}

const SpeedStrip& FlightGraphs::strip(std::int64_t first, double framesPerSample, int samples) {
  const auto wanted = static_cast<std::size_t>(std::max(samples, 0));
  if (framesPerSample >= kFinest) asked_ = true;
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
  const auto last = static_cast<double>(evaluation_->frameCount() - 1);
  const bool summed = quality_ && framesPerSample >= static_cast<double>(sumEvery_);
  std::optional<Camera> camera;  // at the start of the sample that comes
  for (std::int64_t i = first; i < first + samples; ++i) {
    const auto there = static_cast<std::size_t>(i - old.first);
    if (sameSteps && i >= old.first && there < old.speed.size()) {
      strip_.speed.push_back(old.speed[there]);
      strip_.angularSpeed.push_back(old.angularSpeed[there]);
      camera.reset();
      continue;
    }
    const double begin = std::clamp(static_cast<double>(i) * framesPerSample, 0.0, last);
    const double end = std::clamp(static_cast<double>(i + 1) * framesPerSample, 0.0, last);
    Motion motion;
    if (framesPerSample < kFinest) {
      motion = within(begin, end, camera);
    } else if (summed) {
      motion = upTo(end);
      const Motion before = upTo(begin);
      motion += {-before.way, -before.turn};
    } else {
      motion = estimated(begin, end);
    }
    const double perSecond = end > begin ? evaluation_->flight().frameRate / (end - begin) : 0.0;
    strip_.speed.push_back(static_cast<float>(motion.way * perSecond));
    strip_.angularSpeed.push_back(static_cast<float>(motion.turn * perSecond));
  }
  for (const float v : strip_.speed) strip_.mostSpeed = std::max(strip_.mostSpeed, v);
  for (const float v : strip_.angularSpeed) {
    strip_.mostAngularSpeed = std::max(strip_.mostAngularSpeed, v);
  }
  return strip_;
}

}  // namespace vides
