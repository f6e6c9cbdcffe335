// SPDX-License-Identifier: MIT
// Durations and holds that give whole numbers of frames.
#include "evaluate/timed_parts.hpp"

#include <algorithm>
#include <cmath>

#include "evaluate/frame_sum.hpp"

namespace vides {
namespace {

constexpr FrameParts kFrame = FrameSum::kFrame;

std::int64_t framesAt(FrameParts parts) { return (parts + kFrame / 2) >> FrameSum::kBits; }

FrameParts leastOf(bool hold) { return hold ? kFrame / 2 : kFrame; }

FrameParts partsOf(double seconds, double rate, bool hold) {
  return FrameSum::partsOf(hold ? seconds * rate : std::max(1.0, seconds * rate));
}

// Seconds that are so many parts: `wanted`, a shorter number perhaps, where it is as good.
double secondsOf(FrameParts parts, double rate, double wanted) {
  if (FrameSum::partsOf(wanted * rate) == parts) return wanted;
  double seconds = static_cast<double>(parts) / static_cast<double>(kFrame) / rate;
  while (FrameSum::partsOf(seconds * rate) < parts) seconds = std::nextafter(seconds, 1e6);
  while (FrameSum::partsOf(seconds * rate) > parts) seconds = std::nextafter(seconds, 0.0);
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
  // Walks over a hold or a section, which may be one of the parts.
  void step(const OrientationPlace& place, bool hold, std::vector<bool>& met);
  // Sets a part; its length.
  FrameParts settled(std::vector<TimedPart>::const_iterator part);
  void set(const OrientationPlace& place, bool hold, double seconds);

  Flight& flight_;
  const Evaluation& evaluation_;
  const std::vector<TimedPart>& parts_;
  double rate_;
  FrameParts end_ = 0;     // of what has been walked through
  FrameParts before_ = 0;  // the end before the last one
  FrameParts late_ = 0;    // by how much the last part ends too late
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

FrameParts Stretch::settled(const std::vector<TimedPart>::const_iterator part) {
  FrameParts wanted = (framesAt(end_) + part->frames) * kFrame;
  double shown = static_cast<double>(part->frames) / rate_;
  if (part->together) {
    wanted = before_ + partsOf(*part->together, rate_, part->hold);
    shown = *part->together - lastSeconds_;
  }
  const FrameParts least = leastOf(part->hold);
  FrameParts most = wanted - end_;
  // The second half needs its least too.
  if (const auto second = part + 1; second != parts_.end() && second->together) {
    most = std::min(most, partsOf(*second->together, rate_, part->hold) - least);
  }
  const FrameParts length = std::max(most, least);
  late_ = end_ + length - wanted;
  set(part->place, part->hold, secondsOf(length, rate_, shown));
  return length;
}

void Stretch::step(const OrientationPlace& place, bool hold, std::vector<bool>& met) {
  const double seconds = hold ? at(place).hold : *at(place).duration;
  FrameParts length = partsOf(seconds, rate_, hold);
  const auto part = std::find_if(parts_.begin(), parts_.end(), [&](const TimedPart& p) {
    return p.place == place && p.hold == hold;
  });
  if (part != parts_.end()) {
    met[static_cast<std::size_t>(part - parts_.begin())] = true;
    length = settled(part);
  } else if (late_ != 0) {
    const FrameParts shorter = std::max(length - late_, leastOf(hold));
    late_ -= length - shorter;
    length = shorter;
    set(place, hold, secondsOf(length, rate_, seconds));
  }
  before_ = end_;
  end_ += length;
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
