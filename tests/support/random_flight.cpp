// SPDX-License-Identifier: MIT
// Random valid flights and edits.
#include "support/random_flight.hpp"

#include <algorithm>
#include <cmath>

namespace vides::test {
namespace {

Vec3 pointInCube(Random& random) {
  return {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
}

double onGrid(double value) { return std::round(value * 4.0) / 4.0; }

Vec3 directionOf(Random& random, bool nasty) {
  while (true) {
    Vec3 d = pointInCube(random);
    if (nasty) {
      switch (integer(random, 0, 6)) {
        case 0:
          return {0.0, chance(random, 0.5) ? 1.0 : -1.0, 0.0};
        case 1:
          return {random.between(-3e-7, 3e-7), chance(random, 0.5) ? 1.0 : -1.0,
                  random.between(-3e-7, 3e-7)};
        case 2:
          return {chance(random, 0.5) ? 1.0 : -1.0, 0.0, 0.0};
        case 3:
          return {0.0, 0.0, chance(random, 0.5) ? 1.0 : -1.0};
        default:
          d = {onGrid(d.x), onGrid(d.y), onGrid(d.z)};
      }
    }
    if (glm::length(d) > 1e-3) return d;
  }
}

double rollOf(Random& random, bool nasty) {
  if (!nasty) return chance(random, 0.5) ? 0.0 : random.between(-90.0, 90.0);
  const double choices[] = {0.0, 90.0, 180.0, -180.0, 360.0, 540.0, 720.0, -36000.0, 35999.5};
  if (chance(random, 0.6)) return choices[integer(random, 0, 8)];
  return random.between(-36000.0, 36000.0);
}

Shape randomShape(Random& random, bool nasty) {
  const auto value = [&] {
    const double v = random.between(-1.0, 1.0);
    return nasty && chance(random, 0.4) ? std::round(v * 2.0) / 2.0 : v;
  };
  return {value(), value(), value()};
}

void ensureAim(const Key& key, Orientation& o) {
  if (glm::length(aimOffset(key, o)) < 1e-6) setAimPoint(key, o, key.position + Vec3(0, 0, 0.5));
}

std::size_t pick(Random& random, std::size_t size) {
  return static_cast<std::size_t>(integer(random, 0, static_cast<int>(size) - 1));
}

void editOrientation(Random& random, const Key& key, Orientation& o, bool nasty) {
  switch (integer(random, 0, 6)) {
    case 0:
      o.zoom = onGrid(random.between(1.0, 99.0));
      break;
    case 1:
      o.roll = rollOf(random, nasty);
      break;
    case 2:
      o.hold = chance(random, 0.5) ? 0.0 : random.between(0.0, 0.2);
      break;
    case 3:
      o.speed[pick(random, 10)] = random.between(1.0, 100.0);
      break;
    case 4:
      o.duration = chance(random, 0.4) ? std::nullopt : std::optional(random.between(0.01, 0.5));
      break;
    case 5:
      setAimPoint(key, o, key.position + directionOf(random, nasty));
      break;
    default:
      o = randomOrientation(random, key, nasty);
  }
}

void editKey(Random& random, Flight& flight, bool nasty) {
  const std::size_t k = pick(random, flight.keys.size());
  Key key = flight.keys[k];
  switch (integer(random, 0, 4)) {
    case 0:
      key.position = nasty && chance(random, 0.3)
                         ? flight.keys[pick(random, flight.keys.size())].position
                         : pointInCube(random);
      break;
    case 1:
      key.shape.preset = KeyShape::kOwn;
      key.shape.own = randomShape(random, nasty);
      break;
    case 2:
      if (key.orientations.size() < kMostOrientations) {
        key.orientations.insert(
            key.orientations.begin() +
                static_cast<std::ptrdiff_t>(pick(random, key.orientations.size() + 1)),
            randomOrientation(random, key, nasty));
      }
      break;
    case 3:
      if (key.orientations.size() > 1) {
        key.orientations.erase(key.orientations.begin() +
                               static_cast<std::ptrdiff_t>(pick(random, key.orientations.size())));
      }
      break;
    default:
      editOrientation(random, key, key.orientations[pick(random, key.orientations.size())], nasty);
  }
  for (Orientation& o : key.orientations) ensureAim(key, o);
  flight.keys.set(k, key);
}

}  // namespace

int integer(Random& random, int low, int high) {
  return low + static_cast<int>(random.bits() % static_cast<std::uint64_t>(high - low + 1));
}

bool chance(Random& random, double probability) { return random.between(0.0, 1.0) < probability; }

Orientation randomOrientation(Random& random, const Key& key, bool nasty) {
  Orientation o;
  o.aimMode = chance(random, 0.6) ? AimMode::kAbsolute : AimMode::kRelative;
  if (chance(random, 0.4) && o.aimMode == AimMode::kAbsolute) {
    o.aim = {0.0, 0.5, 0.0};  // one point that many look at: tracking moves
  } else {
    setAimPoint(key, o, key.position + directionOf(random, nasty));
  }
  ensureAim(key, o);
  o.roll = rollOf(random, nasty);
  o.zoom = chance(random, 0.5) ? 12.0 : random.between(1.0, 100.0);
  if (chance(random, 0.6)) {
    for (double& v : o.speed) v = random.between(1.0, 100.0);
  }
  if (chance(random, 0.2)) o.hold = random.between(0.0, nasty ? 0.1 : 0.5);
  if (chance(random, 0.2)) o.duration = random.between(0.01, 0.6);
  if (nasty && chance(random, 0.05)) o.duration = std::exp(random.between(-600.0, -1.0));
  return o;
}

Key randomKey(Random& random, bool nasty) {
  Key key;
  key.position = pointInCube(random);
  if (nasty && chance(random, 0.3)) key.position = glm::round(key.position);
  if (chance(random, 0.6)) {
    key.shape.preset = integer(random, 0, 9);
  } else {
    key.shape.preset = KeyShape::kOwn;
    key.shape.own = randomShape(random, nasty);
  }
  key.orientations.clear();
  const int count = chance(random, 0.6) ? 1 : integer(random, 2, nasty ? 10 : 4);
  for (int j = 0; j < count; ++j) {
    const bool copy = nasty && j > 0 && chance(random, 0.3);
    key.orientations.push_back(copy ? key.orientations.back()
                                    : randomOrientation(random, key, nasty));
    if (copy && chance(random, 0.5)) key.orientations.back().roll = rollOf(random, nasty);
  }
  return key;
}

// One of all that there are: a new one is tried without being told.
const OrientationMethod* anyMethod(Random& random) {
  const auto all = orientationMethods();
  return all[pick(random, all.size())];
}

Flight randomFlight(Random& random, const FlightKind& kind) {
  Flight flight;
  flight.closed = chance(random, 0.4);
  flight.orientationCurve = anyMethod(random);
  flight.frameRate = chance(random, 0.5) ? 25.0 : random.between(5.0, 60.0);
  const auto rate = [&] { return random.between(2.0, 30.0); };
  flight.rates = {rate(), rate(), rate(), rate()};
  flight.presets[9] = randomShape(random, kind.nasty);
  const int count = integer(random, 2, kind.mostKeys);
  std::vector<KeyPointer> keys;
  for (int k = 0; k < count; ++k) {
    Key key = randomKey(random, kind.nasty);
    if (kind.nasty && k > 0 && chance(random, 0.25)) {
      const double offsets[] = {0.0, 0.0, 5e-10, 2e-9, 1e-7};
      const Vec3 step(offsets[integer(random, 0, 4)], 0.0, 0.0);
      key.position = glm::clamp(keys.back()->position + step, Vec3(-1.0), Vec3(1.0));
      if (chance(random, 0.5)) key.orientations = keys.back()->orientations;
    }
    for (Orientation& o : key.orientations) ensureAim(key, o);
    keys.emplace_back(std::move(key));
  }
  flight.keys = KeyList(std::move(keys));
  return flight;
}

void editRandomly(Random& random, Flight& flight, bool nasty) {
  const std::size_t n = flight.keys.size();
  switch (integer(random, 0, 14)) {
    case 0:
      flight.keys.insert(pick(random, n + 1), randomKey(random, nasty));
      break;
    case 1:
      if (n > 2) flight.keys.erase(pick(random, n));
      break;
    case 2:
      flight.closed = !flight.closed;
      break;
    case 3:
      flight.orientationCurve = anyMethod(random);
      break;
    case 4:
      flight.presets[pick(random, kPresets)] = randomShape(random, nasty);
      break;
    case 5: {
      // Several keys at once, as a drag of a selection does.
      for (int i = 0; i < 3; ++i) editKey(random, flight, nasty);
      break;
    }
    case 6: {
      // Several neighbours go or come, as with cut and paste.
      const std::size_t first = pick(random, n);
      for (int i = 0; i < 3 && flight.keys.size() > 2 && first < flight.keys.size(); ++i) {
        flight.keys.erase(first);
      }
      if (chance(random, 0.5)) {
        for (int i = 0; i < 4; ++i) flight.keys.insert(first, randomKey(random, nasty));
      }
      break;
    }
    default:
      editKey(random, flight, nasty);
  }
}

}  // namespace vides::test
