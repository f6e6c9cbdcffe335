// SPDX-License-Identifier: MIT
// From a camera that was flown by hand to orientations and keys. Pure functions.
#pragma once

#include "edit/edit_state.hpp"
#include "evaluate/section.hpp"

namespace vides {

// The current orientation takes over the camera; its key moves where the place differs. The aim
// keeps its mode and its distance.
EditResult useView(const EditState& state, const Camera& camera);
// A key with the camera after the current key. A duration of the section that is divided is split
// in proportion to the distances. Shape and speed are the current key's.
EditResult newKeyFromView(const EditState& state, const Camera& camera);
// Whether the camera stands in the cube.
bool insideCube(const Camera& camera);
// The flight in a space that holds the camera (its place in cube coordinates is changed with it).
tl::expected<Flight, Text> enlargedFor(const Flight& flight, Camera& camera);

}  // namespace vides
