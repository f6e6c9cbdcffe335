// SPDX-License-Identifier: MIT
// One number set in all selected keys.
#include "edit/key_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "edit/key_edits.hpp"
#include "edit/sum.hpp"

namespace vides {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
// As a limit of the lens is told: what is typed from there stands for the limit.
double asTold(double limit) { return std::round(limit * 10.0) / 10.0; }

// A coordinate's unit: shown = scale * cube + offset.
struct Unit {
  double scale = 1.0, offset = 0.0;
};
Unit unitOf(const Space& space, int axis, bool offsetOnly, Units units) {
  if (units == Units::kCube) return {};
  return {space.halfSize, offsetOnly ? 0.0 : space.center[axis]};
}

// Rounding on the way through another unit must not push a key on a face beyond it.
double withinFace(double cube) {
  constexpr double kRounding = 1e-12;
  return std::abs(cube) > 1.0 && std::abs(cube) < 1.0 + kRounding ? std::copysign(1.0, cube) : cube;
}

int axisOf(KeyValue which) { return static_cast<int>(which) % 3; }
static_assert(static_cast<int>(KeyValue::kX) == 0 && static_cast<int>(KeyValue::kAimX) == 6);

double& partOf(Shape& shape, KeyValue which) {
  if (which == KeyValue::kTension) return shape.tension;
  return which == KeyValue::kContinuity ? shape.continuity : shape.bias;
}

double degreesOf(const Lens& lens, double focalLength) {
  return 2.0 * std::atan(lens.sensorWidth / (2.0 * focalLength)) / kDegree;
}

// Linear, as the focal length is in the zoom; infinite where the lens has one focal length only.
double zoomOf(const Lens& lens, double focalLength) {
  const double share = (focalLength - lens.focalLengthAtZoom1) /
                       (lens.focalLengthAtZoom100 - lens.focalLengthAtZoom1);
  return kMinZoom + share * (kMaxZoom - kMinZoom);
}

// The zoom of a value between those at the zoom's two ends, or that it lies outside of them.
tl::expected<double, Text> zoomFor(const Lens& lens, double value, bool angle) {
  const auto told = [&](double zoom) {
    const double focalLength = lens.focalLength(zoom);
    return angle ? degreesOf(lens, focalLength) : focalLength;
  };
  const double wide = told(kMinZoom), narrow = told(kMaxZoom);
  const double least = std::min(wide, narrow), most = std::max(wide, narrow);
  const bool limit = value == asTold(least) || value == asTold(most);
  if (!limit && !(value >= least && value <= most)) {
    return tl::unexpected(
        Text(angle ? "refusal.field-of-view" : "refusal.focal-length", {least, most, value}));
  }
  const double in = std::clamp(value, least, most);
  if (in == wide) return kMinZoom;
  if (in == narrow) return kMaxZoom;
  const double focalLength = angle ? lens.sensorWidth / (2.0 * std::tan(0.5 * in * kDegree)) : in;
  return std::clamp(zoomOf(lens, focalLength), kMinZoom, kMaxZoom);
}

struct Place {
  const Flight& flight;
  Units units;
};

double valueIn(const Place& place, const Key& key, std::size_t orientation, KeyValue which) {
  const Orientation& o = key.orientations[orientation];
  const Lens& lens = place.flight.lens;
  const auto shown = [&](const Vec3& at, bool offsetOnly) {
    const Unit unit = unitOf(place.flight.space, axisOf(which), offsetOnly, place.units);
    return unit.scale * at[axisOf(which)] + unit.offset;
  };
  switch (which) {
    case KeyValue::kX:
    case KeyValue::kY:
    case KeyValue::kZ:
      return shown(key.position, false);
    case KeyValue::kTension:
    case KeyValue::kContinuity:
    case KeyValue::kBias: {
      Shape shape = shapeOf(place.flight, key);
      return partOf(shape, which);
    }
    case KeyValue::kAimX:
    case KeyValue::kAimY:
    case KeyValue::kAimZ:
      return shown(o.aim, o.aimMode == AimMode::kRelative);
    case KeyValue::kRoll:
      return o.roll;
    case KeyValue::kZoom:
      return o.zoom;
    case KeyValue::kFocalLength:
      return lens.focalLength(o.zoom);
    case KeyValue::kFieldOfView:
      return degreesOf(lens, lens.focalLength(o.zoom));
  }
  return 0.0;
}

std::optional<Text> setIn(const Place& place, Key& key, std::size_t orientation, KeyValue which,
                          double value) {
  Orientation& o = key.orientations[orientation];
  const auto inCube = [&](bool offsetOnly) {
    const Unit unit = unitOf(place.flight.space, axisOf(which), offsetOnly, place.units);
    return (value - unit.offset) / unit.scale;
  };
  switch (which) {
    case KeyValue::kX:
    case KeyValue::kY:
    case KeyValue::kZ:
      key.position[axisOf(which)] = withinFace(inCube(false));
      return std::nullopt;
    case KeyValue::kTension:
    case KeyValue::kContinuity:
    case KeyValue::kBias: {
      Shape shape = shapeOf(place.flight, key);
      partOf(shape, which) = value;
      key.shape.preset = KeyShape::kOwn;
      key.shape.own = shape;
      return std::nullopt;
    }
    case KeyValue::kAimX:
    case KeyValue::kAimY:
    case KeyValue::kAimZ:
      o.aim[axisOf(which)] = inCube(o.aimMode == AimMode::kRelative);
      return std::nullopt;
    case KeyValue::kRoll:
      o.roll = value;
      return std::nullopt;
    case KeyValue::kZoom:
      o.zoom = value;
      return std::nullopt;
    case KeyValue::kFocalLength:
    case KeyValue::kFieldOfView: {
      const auto zoom = zoomFor(place.flight.lens, value, which == KeyValue::kFieldOfView);
      if (!zoom) return zoom.error();
      o.zoom = *zoom;
      return std::nullopt;
    }
  }
  return std::nullopt;
}

// Its names in "Undo …".
struct StepNames {
  const char* one;
  const char* several;
};
StepNames stepsOf(KeyValue which) {
  switch (which) {
    case KeyValue::kX:
    case KeyValue::kY:
    case KeyValue::kZ:
      return {"step.move-key", "step.move-keys"};
    case KeyValue::kTension:
    case KeyValue::kContinuity:
    case KeyValue::kBias:
      return {"step.set-shape", "step.set-shapes"};
    case KeyValue::kAimX:
    case KeyValue::kAimY:
    case KeyValue::kAimZ:
      return {"step.set-aim", "step.move-aims"};
    case KeyValue::kRoll:
      return {"step.set-roll", "step.set-rolls"};
    case KeyValue::kZoom:
    case KeyValue::kFocalLength:
    case KeyValue::kFieldOfView:
      break;
  }
  return {"step.set-zoom", "step.set-zooms"};
}

}  // namespace

double valueOf(const EditState& state, std::size_t key, KeyValue which, Units units) {
  return valueIn({state.flight, units}, state.flight.keys[key], state.orientationAt(key), which);
}

Units unitsFrom(const Arguments& arguments, std::size_t i) {
  return arguments.has(i) && arguments.text(i) == "scene" ? Units::kScene : Units::kCube;
}

EditResult changeSelected(const EditState& state, const char* step, const char* steps,
                          const KeyChange& change) {
  const KeySelection& selected = state.marks.selected;
  Edit edit{state.flight,
            selected.size() == 1 ? Text(step, {selected.keys().front() + 1})
                                 : Text(steps, {selected.size()}),
            state.marks};
  for (const std::size_t k : selected.keys()) {
    Key key = state.flight.keys[k];
    if (auto refused = change(key, state.orientationAt(k))) return tl::unexpected(*refused);
    edit.flight.keys.set(k, std::move(key));
  }
  return edit;
}

EditResult setInSelected(const EditState& state, KeyValue which, const Argument& value,
                         Units units) {
  const Place place{state.flight, units};
  const auto [step, steps] = stepsOf(which);
  return changeSelected(
      state, step, steps, [&](Key& key, std::size_t orientation) -> std::optional<Text> {
        if (const double* number = std::get_if<double>(&value)) {
          return setIn(place, key, orientation, which, *number);
        }
        const auto sum =
            evaluateSum(std::get<std::string>(value), valueIn(place, key, orientation, which));
        return sum ? setIn(place, key, orientation, which, *sum) : std::optional(sum.error());
      });
}

bool DifferingValues::differs(const EditState& state, KeyValue which) {
  if (state.marks.selected.size() < 2) return false;
  const bool same = of_ && of_->evaluation.sameAs(state.evaluation) && of_->marks == state.marks &&
                    of_->chosen.sameAs(state.chosen);
  if (!same) {
    of_ = state;
    differs_.fill(false);
    // One look at each key: there may be many, and a drag changes them in each display frame.
    const std::vector<std::size_t>& keys = state.marks.selected.keys();
    const Key& first = state.flight.keys[keys.front()];
    const Shape shape = shapeOf(state.flight, first);
    const Orientation& orientation = first.orientations[state.orientationAt(keys.front())];
    const auto note = [&](KeyValue value, bool differs) {
      if (differs) differs_[static_cast<std::size_t>(value)] = true;
    };
    for (const std::size_t k : keys) {
      const Key& key = state.flight.keys[k];
      const Shape other = shapeOf(state.flight, key);
      const Orientation& o = key.orientations[state.orientationAt(k)];
      for (int axis = 0; axis < 3; ++axis) {
        note(static_cast<KeyValue>(static_cast<int>(KeyValue::kX) + axis),
             key.position[axis] != first.position[axis]);
        note(static_cast<KeyValue>(static_cast<int>(KeyValue::kAimX) + axis),
             o.aim[axis] != orientation.aim[axis] || o.aimMode != orientation.aimMode);
      }
      note(KeyValue::kTension, other.tension != shape.tension);
      note(KeyValue::kContinuity, other.continuity != shape.continuity);
      note(KeyValue::kBias, other.bias != shape.bias);
      note(KeyValue::kRoll, o.roll != orientation.roll);
      for (const KeyValue zoom :
           {KeyValue::kZoom, KeyValue::kFocalLength, KeyValue::kFieldOfView}) {
        note(zoom, o.zoom != orientation.zoom);
      }
    }
  }
  return *differs_[static_cast<std::size_t>(which)];
}

}  // namespace vides
