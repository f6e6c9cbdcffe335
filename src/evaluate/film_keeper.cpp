// SPDX-License-Identifier: MIT
// The same film from a divided flight: several ways are tried, the one that changes least first.
#include "evaluate/film_keeper.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "evaluate/timed_parts.hpp"
#include "math/speed_fit.hpp"

namespace vides {
namespace {

// Shares that differ by less look the same: a little within what is promised (1e-3). Of a
// neighbour, whose curve has bent anyway, they may differ more before it must leave its rate.
constexpr double kSameShares = 8e-4;
constexpr double kSameNeighbour = 6e-3;
// Frames by rate are rounded: how far from the whole number a section may be without and with new
// speeds.
constexpr double kNearEnough = 0.48;
constexpr double kAimedAt = 0.45;

// How the sections get their frames.
struct Way {
  bool halvesByRate = true;
  bool allNeighbours = false;    // also those that would keep their frames get new speeds
  bool neighboursByRate = true;  // else those that would lose their frames get durations
};

// 50 rate M of a section: its frames times its mean speed; nothing where it has no rate.
std::optional<double> workByRate(const Evaluation& evaluation, const OrientationPlace& place) {
  const auto section = evaluation.sectionFrom(place);
  if (!section) return std::nullopt;
  const Flight& flight = evaluation.flight();
  const auto at = [&](const OrientationPlace& p) -> const Orientation& {
    return flight.keys[p.key].orientations[p.orientation];
  };
  const Orientation& a = at(section->from);
  const Orientation& b = at(section->to);
  switch (section->kind) {
    case SectionKind::kMove:
      return kBaseSpeed * flight.rates.move * section->length;
    case SectionKind::kPan:
      return kBaseSpeed * flight.rates.pan * (section->angle / 2.0) / 90.0;
    case SectionKind::kRoll:
      return kBaseSpeed * flight.rates.roll * std::abs(std::remainder(b.roll - a.roll, 360.0)) /
             90.0;
    case SectionKind::kZoom:
      return kBaseSpeed * flight.rates.zoom * std::abs(b.zoom - a.zoom) / 99.0;
    case SectionKind::kHold:
      break;
  }
  return std::nullopt;
}

double meanOf(const Course& course) {
  const double way = course.speed.integral(course.to) - course.speed.integral(course.from);
  return way / (course.to - course.from);
}

// The mean speed that gives the frames, as near to the course's own as may be, and so that its
// values stay in [1, 100] where that is possible.
double wantedMean(const Course& course, double work, const SpeedValues& values) {
  const double own = meanOf(course);
  const double natural = work / own;
  const auto frames = static_cast<double>(course.frames);
  const double fewest = course.frames == 1 ? 0.0 : frames - kNearEnough;
  if (natural >= fewest && natural <= frames + kNearEnough) return own;
  const double aim = std::clamp(natural, frames - kAimedAt, frames + kAimedAt);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double mean = std::clamp(work / aim, own * kMinSpeed / *low, own * kMaxSpeed / *high);
  return std::clamp(mean, work / (frames + kNearEnough), work / (frames - kNearEnough));
}

// Whether the section runs as it did with the speeds that it had: on as many frames, and with the
// same neighbours' speeds (a half may be of another kind than the whole).
bool staysAsItIs(const Evaluation& evaluation, const Course& course) {
  if (!(evaluation.speedCurve(course.place) == course.speed)) return false;
  if (!course.byRate) return true;
  const auto work = workByRate(evaluation, course.place);
  if (!work) return false;
  const double natural = *work / course.speed.mean();
  const auto frames = static_cast<double>(course.frames);
  return std::abs(natural - frames) <= kNearEnough || (course.frames == 1 && natural <= 1.0);
}

class Keeper {
 public:
  Keeper(const Evaluation& before, const DividedFilm& film) : before_(before), film_(film) {}
  std::optional<Flight> best();

 private:
  // A try: the flight as far as it has got, and the speeds that are looked for.
  struct Try {
    Flight flight;
    std::vector<const Course*> courses;
    std::vector<SpeedWish> wishes;
    std::vector<TimedPart> timed;
  };
  void attempt(const Way& way);
  bool begin(const Way& way, Try& t) const;
  bool addWish(const Evaluation& evaluation, const Course& course, bool byRate, Try& t) const;
  void link(const Evaluation& evaluation, Try& t) const;
  static bool needsFit(const Try& t);
  bool sameFilm(const Evaluation& evaluation) const;
  void setDuration(Flight& flight, const OrientationPlace& place,
                   std::optional<double> seconds) const;

  const Evaluation& before_;
  const DividedFilm& film_;
  std::optional<Flight> best_;
  double bestError_ = 1e300;  // as a share of what is allowed
};

void Keeper::setDuration(Flight& flight, const OrientationPlace& place,
                         std::optional<double> seconds) const {
  Key key = flight.keys[place.key];
  key.orientations[place.orientation].duration = seconds;
  flight.keys.set(place.key, std::move(key));
}

// Durations to begin with: what they must be is settled when the speeds are known.
bool Keeper::begin(const Way& way, Try& t) const {
  t.flight = film_.flight;
  const auto timed = [&](const Course& course, std::optional<double> together) {
    setDuration(t.flight, course.place, static_cast<double>(course.frames) / t.flight.frameRate);
    t.timed.push_back({course.place, false, course.frames, together});
  };
  for (int i = 0; i < 2; ++i) {
    if (way.halvesByRate) {
      setDuration(t.flight, film_.halves[i].place, std::nullopt);
    } else {
      timed(film_.halves[i], i == 1 ? film_.duration : std::nullopt);
    }
  }
  Evaluation evaluation = before_.updated(t.flight);
  std::vector<const Course*> neighbours;
  for (const Course& course : film_.neighbours) {
    const bool stays = staysAsItIs(evaluation, course);
    if (!stays && course.byRate && !way.neighboursByRate) {
      timed(course, std::nullopt);
    } else if (!stays || way.allNeighbours) {
      neighbours.push_back(&course);
    }
  }
  evaluation = before_.updated(t.flight);
  for (const Course& half : film_.halves) {
    if (!addWish(evaluation, half, way.halvesByRate, t)) return false;
  }
  for (const Course* course : neighbours) {
    if (!addWish(evaluation, *course, course->byRate, t)) return false;
  }
  link(evaluation, t);
  return true;
}

bool Keeper::addWish(const Evaluation& evaluation, const Course& course, bool byRate,
                     Try& t) const {
  SpeedWish wish;
  const auto time = [&](double part) { return course.from + (course.to - course.from) * part; };
  const double start = course.speed.integral(course.from);
  const double way = course.speed.integral(course.to) - start;
  for (std::size_t i = 0; i < wish.shares.size(); ++i) {
    const double part = static_cast<double>(i + 1) / SpeedWish::kSteps;
    wish.shares[i] = (course.speed.integral(time(part)) - start) / way;
  }
  for (std::size_t j = 0; j < kSpeedValues; ++j) {
    wish.values[j] = course.speed.at(time(static_cast<double>(j) / (kSpeedValues - 1)));
  }
  if (byRate) {
    const auto work = workByRate(evaluation, course.place);
    if (!work) return false;
    wish.mean = wantedMean(course, *work, wish.values);
    const double factor = *wish.mean / meanOf(course);
    for (double& v : wish.values) v *= factor;
  }
  for (double& v : wish.values) v = std::clamp(v, kMinSpeed, kMaxSpeed);
  wish.weight = kSameShares / (t.wishes.size() < 2 ? kSameShares : kSameNeighbour);
  t.wishes.push_back(wish);
  t.courses.push_back(&course);
  return true;
}

// What each curve continues: another of the wishes, or a section whose values stay and which
// continues with the old ones.
void Keeper::link(const Evaluation& evaluation, Try& t) const {
  const auto wishAt = [&](const std::optional<OrientationPlace>& place) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; place && i < t.courses.size(); ++i) {
      if (t.courses[i]->place == *place) found = i;
    }
    return found;
  };
  for (std::size_t i = 0; i < t.wishes.size(); ++i) {
    SpeedWish& wish = t.wishes[i];
    const Course& course = *t.courses[i];
    if (const auto before = evaluation.speedBefore(course.place)) {
      wish.previous = wishAt(evaluation.before(course.place).section);
      if (!wish.previous) {
        wish.before = before;
        wish.keepsFirst = true;
        wish.values.front() = course.speed.at(course.from);
      }
    }
    if (const auto after = evaluation.speedAfter(course.place)) {
      wish.next = wishAt(evaluation.after(course.place).section);
      if (!wish.next) {
        wish.after = after;
        wish.keepsLast = true;
        wish.values.back() = course.speed.at(course.to);
      }
    }
  }
}

// What is simple (constant, a slope) is right at once, and keeps its round numbers.
bool Keeper::needsFit(const Try& t) {
  for (const SpeedWish& wish : t.wishes) {
    const auto before = wish.previous ? t.wishes[*wish.previous].values.back() : wish.before;
    const auto after = wish.next ? t.wishes[*wish.next].values.front() : wish.after;
    const SpeedCurve curve(wish.values, before, after);
    if (shareError(curve, wish) > 1e-7) return true;
    if (wish.mean && std::abs(curve.mean() / *wish.mean - 1.0) > 1e-12) return true;
  }
  return false;
}

bool Keeper::sameFilm(const Evaluation& evaluation) const {
  if (evaluation.frameCount() != before_.frameCount()) return false;
  if (evaluation.frameOf(film_.place) != film_.frame) return false;
  const auto keeps = [&](const Course& course) {
    const auto section = evaluation.sectionFrom(course.place);
    return section && section->frames == course.frames;
  };
  // A timed neighbour may have given way to halves that count as a frame each.
  return keeps(film_.halves[0]) && keeps(film_.halves[1]) &&
         std::all_of(film_.neighbours.begin(), film_.neighbours.end(),
                     [&](const Course& course) { return !course.byRate || keeps(course); });
}

void Keeper::attempt(const Way& way) {
  Try t;
  if (!begin(way, t)) return;
  if (needsFit(t)) fitSpeeds(t.wishes);
  for (std::size_t i = 0; i < t.wishes.size(); ++i) {
    const OrientationPlace place = t.courses[i]->place;
    Key key = t.flight.keys[place.key];
    key.orientations[place.orientation].speed = t.wishes[i].values;
    t.flight.keys.set(place.key, std::move(key));
  }
  if (!t.timed.empty()) settleTimedParts(t.flight, before_.updated(t.flight), t.timed);
  const Evaluation evaluation = before_.updated(t.flight);
  if (!sameFilm(evaluation)) return;
  double error = 0.0;
  for (std::size_t i = 0; i < t.wishes.size(); ++i) {
    const double promised = i < 2 ? kSameShares : kSameNeighbour;
    error = std::max(
        error, shareError(evaluation.speedCurve(t.courses[i]->place), t.wishes[i]) / promised);
  }
  // A way further down must be clearly better: of a curve that no ten values follow, none is.
  if (error < 0.9 * bestError_ - 0.1) {
    best_ = t.flight;
    bestError_ = error;
  }
}

std::optional<Flight> Keeper::best() {
  constexpr std::array<Way, 5> kWays{Way{true, false, true}, Way{true, true, true},
                                     Way{true, true, false}, Way{false, false, true},
                                     Way{false, false, false}};
  for (const Way& way : kWays) {
    if (way.halvesByRate && film_.duration) continue;
    attempt(way);
    if (bestError_ <= 1.0) break;
  }
  return best_;
}

}  // namespace

std::optional<Flight> keepFilm(const Evaluation& before, const DividedFilm& film) {
  return Keeper(before, film).best();
}

}  // namespace vides
