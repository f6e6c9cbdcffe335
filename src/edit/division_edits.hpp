// SPDX-License-Identifier: MIT
// Edits that insert a key or an orientation at a moment of the film, which stays as it is. Pure
// functions.
#pragma once

#include <cstdint>

#include "edit/edit_state.hpp"

namespace vides {

// What `I` does: at the playhead's frame.
EditResult insertAtFrame(const EditState& state, std::int64_t frame);
// The same at a place of the curve: a fraction (0 to 1) of the arc length of the section that
// begins at key `after`.
EditResult insertAtPlace(const EditState& state, std::size_t after, double fraction);

// Refused so where the new key would stand outside the cube.
inline constexpr const char* kCurveOutsideCube = "refusal.curve-outside-cube";

}  // namespace vides
