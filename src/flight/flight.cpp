// SPDX-License-Identifier: MIT
// The document's values: equality, defaults, aims.
#include "flight/flight.hpp"

namespace vides {

bool sameExtra(const Extra& a, const Extra& b) {
  if (a == b) return true;
  const bool noneInA = !a || a->empty();
  const bool noneInB = !b || b->empty();
  return noneInA || noneInB ? noneInA == noneInB : *a == *b;
}

bool Orientation::operator==(const Orientation& other) const {
  return aim == other.aim && aimMode == other.aimMode && roll == other.roll && zoom == other.zoom &&
         speed == other.speed && duration == other.duration && hold == other.hold &&
         sameExtra(extra, other.extra);
}

bool KeyShape::operator==(const KeyShape& other) const {
  return preset == other.preset && (preset != kOwn || own == other.own) &&
         sameExtra(extra, other.extra);
}

bool Key::operator==(const Key& other) const {
  return position == other.position && shape == other.shape && orientations == other.orientations &&
         sameExtra(extra, other.extra);
}

bool SceneFile::operator==(const SceneFile& other) const {
  return file == other.file && up == other.up && visible == other.visible &&
         sameExtra(extra, other.extra);
}

bool Flight::Extras::operator==(const Extras& other) const {
  for (std::size_t i = 0; i < kPresets; ++i) {
    if (!sameExtra(presets[i], other.presets[i])) return false;
  }
  return sameExtra(flight, other.flight) && sameExtra(picture, other.picture) &&
         sameExtra(lens, other.lens) && sameExtra(space, other.space) &&
         sameExtra(rates, other.rates);
}

KeyList::KeyList(std::initializer_list<Key> keys) {
  std::vector<KeyPointer> pointers;
  pointers.reserve(keys.size());
  for (const Key& key : keys) pointers.emplace_back(key);
  sequence_ = Sequence(std::move(pointers));
}

std::array<Shape, kPresets> paperPresets() {
  return {{{0.0, 0.0, 0.0},
           {0.3, 0.0, 0.0},
           {0.6, 0.0, 0.0},
           {-0.3, 0.0, 0.0},
           {-0.6, 0.0, 0.0},
           {0.0, -0.5, 0.0},
           {0.0, 0.5, 0.0},
           {0.0, 0.0, 0.5},
           {0.0, 0.0, -0.5},
           {0.0, 0.0, 0.0}}};
}

Flight newFlight() {
  Flight flight;
  Key first;
  first.position = {-0.5, 0.2, 0.8};
  Key second;
  second.position = {0.5, 0.2, 0.8};
  flight.keys = KeyList{first, second};
  return flight;
}

const Shape& shapeOf(const Flight& flight, const Key& key) {
  return key.shape.preset == KeyShape::kOwn
             ? key.shape.own
             : flight.presets[static_cast<std::size_t>(key.shape.preset)];
}

Vec3 aimPoint(const Key& key, const Orientation& orientation) {
  return orientation.aimMode == AimMode::kAbsolute ? orientation.aim
                                                   : key.position + orientation.aim;
}

Vec3 aimOffset(const Key& key, const Orientation& orientation) {
  return orientation.aimMode == AimMode::kAbsolute ? orientation.aim - key.position
                                                   : orientation.aim;
}

void setAimPoint(const Key& key, Orientation& orientation, const Vec3& point) {
  orientation.aim = orientation.aimMode == AimMode::kAbsolute ? point : point - key.position;
}

}  // namespace vides
