// SPDX-License-Identifier: MIT
// The numbers of a key that are set in all selected keys at once: its place, its shape, and of its
// current orientation aim, roll and zoom (also as focal length and field of view).
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

#include "edit/display.hpp"
#include "edit/edit_state.hpp"

namespace vides {

enum class KeyValue {
  kX,
  kY,
  kZ,
  kTension,
  kContinuity,
  kBias,
  kAimX,  // as a field shows it: a point, or a relative aim's offset
  kAimY,
  kAimZ,
  kRoll,  // degrees
  kZoom,
  kFocalLength,  // millimetres
  kFieldOfView,  // degrees, across the picture's width
};
inline constexpr std::size_t kKeyValues = static_cast<std::size_t>(KeyValue::kFieldOfView) + 1;

// What a key has; places and aims in the units.
double valueOf(const EditState& state, std::size_t key, KeyValue which, Units units);

// That value in all selected keys: one number, or a text that starts from each one's own
// (edit/sum). Refused for one, it is refused for all.
EditResult setInSelected(const EditState& state, KeyValue which, const Argument& value,
                         Units units = Units::kCube);

// The units that an optional argument names.
Units unitsFrom(const Arguments& arguments, std::size_t i);

// Another change of each selected key; `step` is its name with one key, `steps` with several.
using KeyChange = std::function<std::optional<Text>(Key& key, std::size_t orientation)>;
EditResult changeSelected(const EditState& state, const char* step, const char* steps,
                          const KeyChange& change);

// In which of the values the selected keys differ: found once for as long as nothing changes.
class DifferingValues {
 public:
  bool differs(const EditState& state, KeyValue which);

 private:
  std::optional<EditState> of_;
  std::array<std::optional<bool>, kKeyValues> differs_;
};

}  // namespace vides
