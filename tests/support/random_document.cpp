// SPDX-License-Identifier: MIT
// Draws random documents member by member, with every edge of every range.
#include "support/random_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "flight/limits.hpp"
#include "io/frame_limit.hpp"

namespace vides::test {
namespace {

std::size_t below(Random& random, std::size_t n) { return random.bits() % n; }
bool oneIn(Random& random, std::size_t n) { return below(random, n) == 0; }

// Bounds, whole numbers, short decimals, any double.
double valueIn(Random& random, const Range& range) {
  // Of ranges without an end the middle; else halves of what could be any double.
  const double low = std::max(range.min, -1e12);
  const double high = std::min(range.max, 1e12);
  const auto fits = [&](double v) { return range.contains(v) ? v : high; };
  switch (below(random, 8)) {
    case 0:
      return range.minOpen ? std::nextafter(range.min, range.max) : range.min;
    case 1:
      return range.max;
    case 2:
      return fits(std::round(random.between(low, high)));
    case 3:
      return fits(std::round(random.between(low, high) * 1000.0) / 1000.0);
    case 4:
      return fits(random.magnitude(-12, 3) * (random.coin() ? 1 : -1));
    case 5:
      return fits(oneIn(random, 2) ? -0.0 : std::numeric_limits<double>::denorm_min());
    default:
      return fits(random.between(low, high));
  }
}

int wholeIn(Random& random, const Range& range) {
  return static_cast<int>(std::floor(valueIn(random, range)));
}

Vec3 pointIn(Random& random, const Range& range) {
  const double x = valueIn(random, range);
  const double y = valueIn(random, range);
  return {x, y, valueIn(random, range)};
}

Shape shapeIn(Random& random) {
  const double tension = valueIn(random, limits::kShape);
  const double continuity = valueIn(random, limits::kShape);
  return {tension, continuity, valueIn(random, limits::kShape)};
}

void appendCodePoint(std::string& text, std::uint64_t code) {
  const auto add = [&](std::uint64_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | code >> 6);
    add(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12);
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  } else {
    add(0xF0 | code >> 18);
    add(0x80 | (code >> 12 & 0x3F));
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  }
}

std::string randomSpace(Random& random) {
  static constexpr const char* kSpaces[] = {"", "", "", " ", "\n", "\r\n\t", "   "};
  return kSpaces[below(random, 7)];
}

// The text of a JSON string, with escapes that needn't be.
std::string randomJsonString(Random& random, const std::string& prefix = {}) {
  static constexpr const char* kPieces[] = {
      "a",   "Z",   "0",  " ",       "ü",       "🛩",           "\\\"", "\\\\",
      "\\/", "\\b", "~1", "\\u0000", "\\u00fC", "\\uD83D\\uDEE9", "\\n"};
  std::string text = "\"" + prefix;
  for (std::size_t n = below(random, 6); n > 0; --n) text += kPieces[below(random, 15)];
  return text + "\"";
}

std::string randomScalar(Random& random) {
  static constexpr const char* kScalars[] = {
      "true",   "false", "null", "0", "-0", "1e999", "-1E-999", "123456789012345678901234567890",
      "0.1e+5", "1.50"};
  return oneIn(random, 3) ? randomJsonString(random) : kScalars[below(random, 10)];
}

Extra randomExtra(Random& random) {
  if (!oneIn(random, 6)) return nullptr;
  auto members = std::make_shared<ExtraMembers>();
  const std::size_t count = 1 + below(random, 3);
  for (std::size_t i = 0; i < count; ++i) {
    // The number makes the names differ.
    members->emplace_back(randomJsonString(random, fmt::format("x_{}", i)), randomJson(random, 3));
  }
  return members;
}

Orientation orientationFor(Random& random, const Key& key) {
  Orientation o;
  o.aimMode = random.coin() ? AimMode::kAbsolute : AimMode::kRelative;
  do {
    o.aim = pointIn(random, limits::kAim);
  } while (glm::length(aimOffset(key, o)) < 1e-8);
  o.roll = valueIn(random, limits::kRoll);
  o.zoom = valueIn(random, limits::kZoom);
  if (random.coin()) {
    for (double& v : o.speed) v = valueIn(random, limits::kSpeed);
  }
  if (oneIn(random, 3)) o.duration = valueIn(random, limits::kDuration);
  o.hold = valueIn(random, limits::kHold);
  o.extra = randomExtra(random);
  return o;
}

Key keyIn(Random& random) {
  Key key;
  key.position = pointIn(random, limits::kPosition);
  if (random.coin()) {
    key.shape.preset = wholeIn(random, limits::kPreset);
  } else {
    key.shape.preset = KeyShape::kOwn;
    key.shape.own = shapeIn(random);
  }
  key.shape.extra = randomExtra(random);
  key.orientations.clear();
  const std::size_t count = random.coin() ? 1 : 1 + below(random, kMostOrientations);
  for (std::size_t i = 0; i < count; ++i) {
    key.orientations.push_back(orientationFor(random, key));
  }
  key.extra = randomExtra(random);
  return key;
}

double outOf(Random& random, const Range& range) {
  const double above = std::nextafter(range.max, std::numeric_limits<double>::infinity());
  const double under = std::nextafter(range.min, -std::numeric_limits<double>::infinity());
  if (random.coin() && std::isfinite(above)) return above;
  return range.minOpen ? range.min : under;
}

void spoilOrientation(Random& random, const Key& key, Orientation& o) {
  switch (below(random, 7)) {
    case 0:
      o.aim[static_cast<int>(below(random, 3))] = outOf(random, limits::kAim);
      break;
    case 1:
      setAimPoint(key, o, key.position);
      break;
    case 2:
      o.roll = outOf(random, limits::kRoll);
      break;
    case 3:
      o.zoom = outOf(random, limits::kZoom);
      break;
    case 4:
      o.speed[below(random, 10)] = outOf(random, limits::kSpeed);
      break;
    case 5:
      o.duration = outOf(random, limits::kDuration);
      break;
    default:
      o.hold = outOf(random, limits::kHold);
  }
}

void spoilKey(Random& random, Key& key) {
  if (key.orientations.empty()) return;  // spoilt already
  switch (below(random, 6)) {
    case 0:
      key.position[static_cast<int>(below(random, 3))] = outOf(random, limits::kPosition);
      break;
    case 1:
      key.shape.preset = random.coin() ? 10 : -2;
      break;
    case 2:
      key.shape.preset = KeyShape::kOwn;
      key.shape.own.bias = outOf(random, limits::kShape);
      break;
    case 3:
      key.orientations.clear();
      break;
    case 4:
      while (key.orientations.size() <= kMostOrientations) {
        key.orientations.push_back(key.orientations.front());
      }
      break;
    default:
      spoilOrientation(random, key, key.orientations[below(random, key.orientations.size())]);
  }
}

}  // namespace

std::string randomText(Random& random, int mostCharacters) {
  std::string text;
  for (std::size_t n = below(random, static_cast<std::size_t>(mostCharacters) + 1); n > 0; --n) {
    static constexpr std::uint64_t kBounds[] = {0x20, 0x80, 0x800, 0xD800, 0x110000};
    std::uint64_t code = 1 + below(random, kBounds[below(random, 5)] - 1);
    if (code >= 0xD800 && code <= 0xDFFF) code -= 0x800;
    appendCodePoint(text, code);
  }
  return text;
}

std::string randomJson(Random& random, int depth) {
  const std::size_t kind = depth > 0 ? below(random, 3) : 0;
  if (kind == 0) return randomScalar(random);
  const bool object = kind == 1;
  std::string text = object ? "{" : "[";
  const std::size_t count = below(random, 4);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ",";
    text += randomSpace(random);
    if (object) {
      text += randomJsonString(random, std::to_string(i)) + randomSpace(random) + ":" +
              randomSpace(random);
    }
    text += randomJson(random, depth - 1) + randomSpace(random);
  }
  return text + (object ? "}" : "]");
}

Flight randomDocument(Random& random, int mostKeys) {
  Flight f;
  f.name = randomText(random, oneIn(random, 20) ? 1000 : 20);
  f.frameRate = valueIn(random, limits::kFrameRate);
  f.picture.width = wholeIn(random, limits::kPictureSize);
  f.picture.height = wholeIn(random, limits::kPictureSize);
  f.lens.sensorWidth = valueIn(random, limits::kSensorWidth);
  f.lens.focalLengthAtZoom1 = valueIn(random, limits::kFocalLength);
  f.lens.focalLengthAtZoom100 = valueIn(random, limits::kFocalLength);
  f.space.center = pointIn(random, {-5e8, 5e8});
  f.space.halfSize = valueIn(random, limits::kSpaceHalfSize);
  f.rates.move = valueIn(random, limits::kRate);
  f.rates.pan = valueIn(random, limits::kRate);
  f.rates.roll = valueIn(random, limits::kRate);
  f.rates.zoom = valueIn(random, limits::kRate);
  f.closed = random.coin();
  f.orientationCurve = orientationMethods()[below(random, orientationMethods().size())];
  for (Shape& shape : f.presets) shape = shapeIn(random);
  const std::size_t count = 2 + below(random, static_cast<std::size_t>(mostKeys) - 1);
  std::vector<KeyPointer> keys;
  for (std::size_t k = 0; k < count; ++k) keys.emplace_back(keyIn(random));
  f.keys = KeyList(std::move(keys));
  for (std::size_t n = below(random, 3); n > 0; --n) {
    f.scene.push_back({"f" + randomText(random, 9), randomExtra(random)});
  }
  f.extras.flight = randomExtra(random);
  f.extras.picture = randomExtra(random);
  f.extras.lens = randomExtra(random);
  f.extras.space = randomExtra(random);
  f.extras.rates = randomExtra(random);
  for (Extra& extra : f.extras.presets) extra = randomExtra(random);
  if (checkFrameCount(f)) {
    f.frameRate = 1;
    f.rates = Rates{};
  }
  return f;
}

void spoil(Random& random, Flight& f) {
  switch (below(random, 12)) {
    case 0:
      f.name = std::string(1001, 'n');
      break;
    case 1:
      f.frameRate = outOf(random, limits::kFrameRate);
      break;
    case 2:
      f.picture = {0, 65537};
      break;
    case 3:
      f.lens.focalLengthAtZoom100 = 0;
      break;
    case 4:
      f.space = {{0, 1e9, 1}, outOf(random, limits::kSpaceHalfSize)};
      break;
    case 5:
      f.rates.roll = outOf(random, limits::kRate);
      break;
    case 6:
      f.presets[below(random, kPresets)].tension = outOf(random, limits::kShape);
      break;
    case 7:
      while (f.keys.size() > 1) f.keys.erase(1);
      break;
    case 8:
      f.scene.push_back({});
      break;
    default: {
      const std::size_t k = below(random, f.keys.size());
      Key key = f.keys[k];
      spoilKey(random, key);
      f.keys.set(k, key);
    }
  }
}

}  // namespace vides::test
