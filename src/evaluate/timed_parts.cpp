// SPDX-License-Identifier: MIT
// Durations and holds that give whole numbers of frames.
#include "evaluate/timed_parts.hpp"

#include <algorithm>
#include <cmath>

namespace vides {
namespace {

// Parts of a frame are counted in these units.
constexpr std::int64_t kUnit = std::int64_t{1} << 24;

std::int64_t unitsOf(double frames) {
  return static_cast<std::int64_t>(std::floor(frames * static_cast<double>(kUnit) + 0.5));
}

std::int64_t framesAt(std::int64_t units) {
  return static_cast<std::int64_t>(
      std::floor(static_cast<double>(units) / static_cast<double>(kUnit) + 0.5));
}

std::int64_t sectionUnits(double seconds, double rate) {
  return unitsOf(std::max(1.0, seconds * rate));
}

// Seconds that are these units: `wanted`, a shorter number perhaps, where it is as good.
double secondsOf(std::int64_t units, double rate, double wanted) {
  if (unitsOf(wanted * rate) == units) return wanted;
  double seconds = static_cast<double>(units) / static_cast<double>(kUnit) / rate;
  while (unitsOf(seconds * rate) < units) seconds = std::nextafter(seconds, 1e6);
  while (unitsOf(seconds * rate) > units) seconds = std::nextafter(seconds, 0.0);
  return seconds;
}

// Walks through one stretch from its start and sets what is to be set.
class Stretch {
 public:
  Stretch(Flight& flight, const Evaluation& evaluation, const std::vector<TimedPart>& parts)
      : flight_(flight), evaluation_(evaluation), parts_(parts), rate_(flight.frameRate) {}
  // The parts that were met are marked.
  void settle(OrientationPlace place, std::vector<bool>& met);

 private:
  const Orientation& at(const OrientationPlace& place) const {
    return flight_.keys[place.key].orientations[place.orientation];
  }
  OrientationPlace start(OrientationPlace place) const;
  bool byRate(const OrientationPlace& place) const {
    return !at(place).duration && evaluation_.sectionFrom(place);
  }
  void step(const OrientationPlace& place, bool hold, std::vector<bool>& met);
  void set(const OrientationPlace& place, bool hold, double seconds);

  Flight& flight_;
  const Evaluation& evaluation_;
  const std::vector<TimedPart>& parts_;
  double rate_;
  std::int64_t end_ = 0;      // of what has been walked through, units
  std::int64_t before_ = 0;   // the end before the last one
  std::int64_t missing_ = 0;  // units by which the last part ends too late
  double lastSeconds_ = 0.0;
};

OrientationPlace Stretch::start(OrientationPlace place) const {
  while (place != OrientationPlace{}) {
    OrientationPlace before{place.key, place.orientation - 1};
    if (place.orientation == 0) {
      before = {place.key - 1, flight_.keys[place.key - 1].orientations.size() - 1};
    }
    if (byRate(before)) break;
    place = before;
  }
  return place;
}

void Stretch::set(const OrientationPlace& place, bool hold, double seconds) {
  Key key = flight_.keys[place.key];
  Orientation& o = key.orientations[place.orientation];
  if (hold) {
    o.hold = seconds;
  } else {
    o.duration = seconds;
  }
  lastSeconds_ = seconds;
  flight_.keys.set(place.key, std::move(key));
}

void Stretch::step(const OrientationPlace& place, bool hold, std::vector<bool>& met) {
  const double seconds = hold ? at(place).hold : *at(place).duration;
  std::int64_t units = hold ? unitsOf(seconds * rate_) : sectionUnits(seconds, rate_);
  const std::int64_t least = hold ? kUnit / 2 : kUnit;
  const auto part = std::find_if(parts_.begin(), parts_.end(), [&](const TimedPart& p) {
    return p.place == place && p.hold == hold;
  });
  if (part != parts_.end()) {
    met[static_cast<std::size_t>(part - parts_.begin())] = true;
    std::int64_t wanted = (framesAt(end_) + part->frames) * kUnit;
    double shown = static_cast<double>(part->frames) / rate_;
    if (part->together) {
      const double together = *part->together;
      wanted = before_ + (hold ? unitsOf(together * rate_) : sectionUnits(together, rate_));
      shown = together - lastSeconds_;
    }
    // The second half needs its least too.
    std::int64_t most = wanted - end_;
    if (const auto second = part + 1; second != parts_.end() && second->together) {
      most = (hold ? unitsOf(*second->together * rate_) : sectionUnits(*second->together, rate_)) -
             least;
    }
    units = std::max(std::min(wanted - end_, most), least);
    missing_ = end_ + units - wanted;
    set(place, hold, secondsOf(units, rate_, shown));
  } else if (missing_ != 0) {
    const std::int64_t shorter = std::max(units - missing_, least);
    missing_ -= units - shorter;
    units = shorter;
    set(place, hold, secondsOf(units, rate_, seconds));
  }
  before_ = end_;
  end_ += units;
}

void Stretch::settle(OrientationPlace place, std::vector<bool>& met) {
  place = start(place);
  while (true) {
    if (std::floor(at(place).hold * rate_ + 0.5 + 1e-9) >= 1.0) step(place, true, met);
    if (evaluation_.sectionFrom(place)) {
      if (!at(place).duration) return;
      step(place, false, met);
    }
    const OrientationPlace next = evaluation_.next(place);
    if (next == place || next == OrientationPlace{}) return;
    place = next;
  }
}

}  // namespace

void settleTimedParts(Flight& flight, const Evaluation& evaluation,
                      const std::vector<TimedPart>& parts) {
  std::vector<bool> met(parts.size(), false);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!met[i]) Stretch(flight, evaluation, parts).settle(parts[i].place, met);
    met[i] = true;
  }
}

}  // namespace vides
