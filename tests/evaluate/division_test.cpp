// SPDX-License-Identifier: MIT
// Dividing a section at a frame keeps the film (2-flight-model, 5-editor: "Insert at the playhead").
#include "evaluate/division.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flight/validation.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

using test::Random;


// A speed curve as a hand draws a smooth one.
SpeedValues smoothSpeeds(Random& random) {
  const double middle = random.between(20.0, 80.0);
  const double most = std::min(middle - 2.0, 99.0 - middle);
  const double a = random.between(-0.5, 0.5) * most, b = random.between(-0.5, 0.5) * most;
  const double turns = random.between(0.0, 1.0), phase = random.between(0.0, 6.3);
  SpeedValues values;
  for (int j = 0; j < kSpeedValues; ++j) {
    const double t = j / 9.0;
    values[static_cast<std::size_t>(j)] =
        middle + a * std::sin(2.0 * std::numbers::pi * turns * t + phase) + b * (2.0 * t - 1.0);
  }
  return values;
}

Flight smoothFlight(Random& random, bool nasty) {
  Flight flight = test::randomFlight(random, {.nasty = nasty, .mostKeys = 6});
  flight.rates.move = random.between(5.0, 100.0);
  for (std::size_t k = 0; k < flight.keys.size(); ++k) {
    Key key = flight.keys[k];
    for (Orientation& o : key.orientations) {
      if (o.duration) o.duration = std::max(1.0, std::round(*o.duration * flight.frameRate)) / flight.frameRate;
      o.hold = std::round(o.hold * flight.frameRate) / flight.frameRate;
      if (test::chance(random, 0.7)) o.speed = smoothSpeeds(random);
      else o.speed.fill(50.0);
    }
    flight.keys.set(k, key);
  }
  return flight;
}

double shareAt(const Evaluation& e, const OrientationPlace& place, double tau) {
  return e.speedCurve(place).progress(tau);
}

TEST(Division, Statistics) {
  int done = 0, refused[16] = {}, bad = 0, rate = 0, duration = 0, lost = 0;
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    Random random(seed);
    const Flight flight = smoothFlight(random, seed % 4 == 0);
    const Evaluation e(flight);
    const auto n = static_cast<std::int64_t>(random.between(0.0, 1.0) * static_cast<double>(e.frameCount()));
    const auto d = divideAtFrame(e, n);
    if (!d) {
      ++refused[static_cast<int>(d.error())];
      if (d.error() == DivisionRefusal::kOneFrame) {
        if (++lost < 15) {
          const Section s = *e.sectionAtFrame(n);
          std::printf("lost seed %d frame %d of %d in section %s with %d frames first %d closed %d\n", (int)seed, (int)n, (int)e.frameCount(),
                      std::string(name(s.kind)).c_str(), (int)s.frames, (int)s.firstFrame, flight.closed);
        }
      }
      continue;
    }
    ++done;
    const Section s = *e.sectionAtFrame(n);
    const Evaluation after(d->flight);
    const bool wasRate = !flight.keys[s.from.key].orientations[s.from.orientation].duration && s.from != s.to;
    const bool isRate = !d->flight.keys[d->place.key].orientations[d->place.orientation].duration;
    if (wasRate) ++(isRate ? rate : duration);
    EXPECT_EQ(after.frameCount(), e.frameCount()) << seed;
    EXPECT_EQ(after.frameOf(d->place), n) << seed;
    const Camera a = e.frame(n).camera, b = after.frame(n).camera;
    const double apart = glm::length(a.viewReferencePoint - b.viewReferencePoint) + glm::length(a.viewPlaneNormal - b.viewPlaneNormal) + glm::length(a.viewUpVector - b.viewUpVector) + std::abs(a.zoom - b.zoom);
    EXPECT_LT(apart, 1e-9) << seed;
    if (s.from == s.to) continue;
    const double cut = shareAt(e, s.from, double(n - s.firstFrame) / double(s.frames));
    double error = 0.0;
    for (std::int64_t j = 0; j < s.frames; ++j) {
      const double was = shareAt(e, s.from, double(j) / double(s.frames));
      const std::int64_t half = n - s.firstFrame;
      const double is = j < half ? cut * shareAt(after, s.from, double(j) / double(half))
                                 : cut + (1 - cut) * shareAt(after, d->place, double(j - half) / double(s.frames - half));
      error = std::max(error, std::abs(is - was));
    }
    worst = std::max(worst, error);
    if (error > 1e-3 && getenv("DBG")) {
      for (int q = 0; q <= 18; ++q) std::printf(" %.1f", e.speedCurve(s.from).at(q / 18.0));
      std::printf("\n  before %.1f after %.1f | ", e.speedBefore(s.from).value_or(-1), e.speedAfter(s.from).value_or(-1));
      for (int q = 0; q <= 18; ++q) std::printf(" %.1f", after.speedCurve(s.from).at(q / 18.0));
      std::printf(" | ");
      for (int q = 0; q <= 18; ++q) std::printf(" %.1f", after.speedCurve(d->place).at(q / 18.0));
      std::printf("\n");
      for (std::int64_t j = 0; j < s.frames; j += 4) {
      const double was = shareAt(e, s.from, double(j) / double(s.frames));
      const std::int64_t half = n - s.firstFrame;
      const double is = j < half ? cut * shareAt(after, s.from, double(j) / double(half))
                                 : cut + (1 - cut) * shareAt(after, d->place, double(j - half) / double(s.frames - half));
        std::printf(" %.1f", 1e4 * (is - was));
      }
      std::printf("\n");
    }
    if (error > 1e-3 && ++bad < 15) {
      std::printf("seed %d error %g kind %s frames %d cut %d rate %d/%d\n", (int)seed, error, std::string(name(s.kind)).c_str(), (int)s.frames, (int)(n - s.firstFrame), wasRate, isRate);
    }
  }
  std::printf("done %d bad %d worst %g rate %d duration %d refused", done, bad, worst, rate, duration);
  for (int i = 0; i < 9; ++i) std::printf(" %d", refused[i]);
  std::printf("\n");
}

}  // namespace
}  // namespace vides
