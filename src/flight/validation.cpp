// SPDX-License-Identifier: MIT
// Walks over a flight in the order of the file and checks every value.
#include "flight/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flight/utf8.hpp"

namespace vides {
namespace {

std::string numberText(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
  return fmt::format("{}", value == 0.0 ? 0.0 : value);  // never -0
}

std::string pointText(const Vec3& p) {
  return fmt::format("[{}, {}, {}]", numberText(p.x), numberText(p.y), numberText(p.z));
}

Problem problem(ProblemCode code, std::string_view pointer, Expectation expected,
                std::string found) {
  Problem p;
  p.code = code;
  p.pointer = pointer;
  p.expected = std::move(expected);
  p.found = std::move(found);
  return p;
}

// Without overflow, and NaN if one of them is (libstdc++'s hypot of three may lose it).
double distance(const Vec3& v) { return std::hypot(std::hypot(v.x, v.y), v.z); }

// Collects problems while the walk goes down into the members and up again.
class Walk {
 public:
  explicit Walk(std::size_t most, std::string pointer = {})
      : most_(most), pointer_(std::move(pointer)) {}

  bool full() const { return problems_.size() >= most_; }
  std::vector<Problem> take() { return std::move(problems_); }

  // Goes down into a member or an element for as long as it lives.
  class Step {
   public:
    Step(Walk& walk, std::string_view member) : walk_(walk), size_(walk.pointer_.size()) {
      (walk.pointer_ += '/') += member;
    }
    Step(Walk& walk, std::size_t index) : Step(walk, std::to_string(index)) {}
    ~Step() { walk_.pointer_.resize(size_); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

   private:
    Walk& walk_;
    std::size_t size_;
  };

  // `check` is one of the single-value checks, called only where something is wrong is possible.
  void note(std::optional<Problem> found) {
    if (found && !full()) problems_.push_back(std::move(*found));
  }
  const std::string& pointer() const { return pointer_; }

  void number(std::string_view member, double value, const Range& range) {
    if (range.contains(value)) return;
    const Step step(*this, member);
    note(checkNumber(value, range, pointer_));
  }
  void integer(std::string_view member, int value, const Range& range) {
    if (range.contains(value)) return;
    const Step step(*this, member);
    note(checkInteger(value, range, pointer_));
  }
  template <class Numbers>
  void numbers(std::string_view member, const Numbers& values, std::size_t size,
               const Range& range) {
    const Step step(*this, member);
    for (std::size_t i = 0; i < size; ++i) {
      const double value = values[static_cast<typename Numbers::size_type>(i)];
      if (range.contains(value)) continue;
      const Step element(*this, i);
      note(checkNumber(value, range, pointer_));
    }
  }
  void point(std::string_view member, const Vec3& p, const Range& range) {
    numbers(member, std::array<double, 3>{p.x, p.y, p.z}, 3, range);
  }
  void shape(const Shape& shape) {
    number("tension", shape.tension, limits::kShape);
    number("continuity", shape.continuity, limits::kShape);
    number("bias", shape.bias, limits::kShape);
  }
  void count(std::size_t size, const CountRange& range) {
    if (range.contains(size)) return;
    note(problem(ProblemCode::kWrongCount, pointer_, expectCount(range), std::to_string(size)));
  }
  void orientation(const Key& key, const Orientation& o);
  void key(const Key& key);

 private:
  std::size_t most_;
  std::string pointer_;
  std::vector<Problem> problems_;
};

bool inRange(const Vec3& p, const Range& range) {
  return range.contains(p.x) && range.contains(p.y) && range.contains(p.z);
}

void Walk::orientation(const Key& key, const Orientation& o) {
  point("aim", o.aim, limits::kAim);
  if (inRange(o.aim, limits::kAim) && inRange(key.position, limits::kPosition)) {
    const Step step(*this, "aim");
    note(checkAimDistance(key.position, o.aimMode, o.aim, pointer_));
  }
  number("roll", o.roll, limits::kRoll);
  number("zoom", o.zoom, limits::kZoom);
  numbers("speed", o.speed, o.speed.size(), limits::kSpeed);
  if (o.duration) number("duration", *o.duration, limits::kDuration);
  number("hold", o.hold, limits::kHold);
}

void Walk::key(const Key& key) {
  point("position", key.position, limits::kPosition);
  {
    const Step step(*this, "shape");
    if (key.shape.preset == KeyShape::kOwn) {
      shape(key.shape.own);
    } else {
      integer("preset", key.shape.preset, limits::kPreset);
    }
  }
  const Step step(*this, "orientations");
  count(key.orientations.size(), limits::kOrientations);
  // What is too many isn't looked at; nor does the reader.
  const std::size_t size = std::min(key.orientations.size(), limits::kOrientations.max);
  for (std::size_t i = 0; i < size && !full(); ++i) {
    const Step element(*this, i);
    orientation(key, key.orientations[i]);
  }
}

void checkMembers(Walk& walk, const Flight& flight) {
  using Step = Walk::Step;
  walk.note(checkName(flight.name, "/name"));
  walk.number("frame_rate", flight.frameRate, limits::kFrameRate);
  {
    const Step step(walk, "picture");
    walk.integer("width", flight.picture.width, limits::kPictureSize);
    walk.integer("height", flight.picture.height, limits::kPictureSize);
  }
  {
    const Step step(walk, "lens");
    walk.number("sensor_width_mm", flight.lens.sensorWidth, limits::kSensorWidth);
    walk.numbers(
        "focal_length_mm",
        std::array<double, 2>{flight.lens.focalLengthAtZoom1, flight.lens.focalLengthAtZoom100}, 2,
        limits::kFocalLength);
  }
  walk.note(checkSpaceCenter(flight.space.center, "/space/center"));
  walk.number("space/half_size", flight.space.halfSize, limits::kSpaceHalfSize);
  {
    const Step step(walk, "rates");
    walk.number("move", flight.rates.move, limits::kRate);
    walk.number("pan", flight.rates.pan, limits::kRate);
    walk.number("roll", flight.rates.roll, limits::kRate);
    walk.number("zoom", flight.rates.zoom, limits::kRate);
  }
  const Step step(walk, "presets");
  for (std::size_t i = 0; i < kPresets; ++i) {
    const Step element(walk, i);
    walk.shape(flight.presets[i]);
  }
}

std::optional<Problem> first(Walk& walk) {
  std::vector<Problem> problems = walk.take();
  if (problems.empty()) return std::nullopt;
  return std::move(problems.front());
}

}  // namespace

std::vector<Problem> validate(const Flight& flight) {
  Walk walk(kMostProblems);
  checkMembers(walk, flight);
  {
    const Walk::Step step(walk, "keys");
    walk.count(flight.keys.size(), limits::kKeys);
    std::size_t i = 0;
    flight.keys.forEach([&](const Key& key) {
      if (!walk.full() && i < limits::kKeys.max) {
        const Walk::Step element(walk, i);
        walk.key(key);
      }
      ++i;
    });
  }
  for (std::size_t i = 0; i < flight.scene.size() && !walk.full(); ++i) {
    walk.note(checkPath(flight.scene[i].file, fmt::format("/scene/{}/file", i)));
  }
  return walk.take();
}

std::optional<Problem> checkKey(const Flight& flight, std::size_t index) {
  return checkKey(flight.keys[index], index);
}

std::optional<Problem> checkKey(const Key& key, std::size_t index) {
  Walk walk(1, fmt::format("/keys/{}", index));
  walk.key(key);
  return first(walk);
}

std::optional<Problem> checkNumber(double value, const Range& range, std::string_view pointer) {
  if (range.contains(value)) return std::nullopt;
  return problem(ProblemCode::kOutOfRange, pointer, expectNumber(range), numberText(value));
}

std::optional<Problem> checkInteger(double value, const Range& range, std::string_view pointer) {
  const bool whole = std::trunc(value) == value;
  if (range.contains(value) && whole) return std::nullopt;
  return problem(whole ? ProblemCode::kOutOfRange : ProblemCode::kWrongType, pointer,
                 expectInteger(range), numberText(value));
}

std::optional<Problem> checkName(std::string_view name, std::string_view pointer) {
  const std::optional<std::size_t> length = codePoints(name);
  if (length && *length <= limits::kNameCharacters) return std::nullopt;
  Expectation expected;
  expected.kind = Expected::kString;
  expected.max = static_cast<double>(limits::kNameCharacters);
  return problem(ProblemCode::kOutOfRange, pointer, expected,
                 shortened(fmt::format("\"{}\"", name)));
}

std::optional<Problem> checkPath(std::string_view path, std::string_view pointer) {
  if (!path.empty() && path.find('\0') == path.npos && codePoints(path)) return std::nullopt;
  Expectation expected;
  expected.kind = Expected::kPath;
  return problem(ProblemCode::kOutOfRange, pointer, expected,
                 shortened(fmt::format("\"{}\"", path)));
}

std::optional<Problem> checkSpaceCenter(const Vec3& center, std::string_view pointer) {
  if (distance(center) <= limits::kSpaceCenterDistance) return std::nullopt;
  Expectation expected;
  expected.kind = Expected::kPoint;
  expected.max = limits::kSpaceCenterDistance;
  return problem(ProblemCode::kOutOfRange, pointer, expected, pointText(center));
}

std::optional<Problem> checkAimDistance(const Vec3& position, AimMode mode, const Vec3& aim,
                                        std::string_view pointer) {
  const Vec3 offset = mode == AimMode::kAbsolute ? aim - position : aim;
  if (distance(offset) >= limits::kAimDistance) return std::nullopt;
  Expectation expected;
  expected.kind = Expected::kAway;
  expected.min = limits::kAimDistance;
  return problem(ProblemCode::kAimAtKey, pointer, expected, pointText(aim));
}

Expectation expectNumber(const Range& range) {
  Expectation expected;
  expected.kind = Expected::kNumber;
  expected.min = range.min;
  expected.max = range.max;
  expected.minOpen = range.minOpen;
  return expected;
}

Expectation expectInteger(const Range& range) {
  Expectation expected = expectNumber(range);
  expected.kind = Expected::kInteger;
  return expected;
}

Expectation expectNumbers(int count, const Range& range) {
  Expectation expected = expectNumber(range);
  expected.kind = Expected::kNumbers;
  expected.count = count;
  return expected;
}

Expectation expectCount(const CountRange& range) {
  Expectation expected;
  expected.kind = Expected::kCount;
  expected.min = static_cast<double>(range.min);
  expected.max = static_cast<double>(range.max);
  return expected;
}

}  // namespace vides
