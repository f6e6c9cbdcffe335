// SPDX-License-Identifier: MIT
// Edits of a flight's scenes and of the space that is fitted to them. Pure functions.
#pragma once

#include <cstddef>
#include <string>

#include "edit/edit_state.hpp"
#include "flight/limits.hpp"
#include "scene/scene_geometry.hpp"

namespace vides {

// How much of the cube a scene takes that is fitted when it is imported, and one that is to be
// flown round.
inline constexpr double kImportShare = 0.8;
inline constexpr double kFlyRoundShare = 0.3;
inline constexpr Range kFitShares{0.05, 1.0};

// add-scene FILE [LOW HIGH [UP]]: the box of what is drawn, in scene units, where it is known, is
// fitted to 80 % of the cube if this is the first scene and `space` the default.
EditResult addSceneEdit(const EditState& state, const Arguments& arguments);
EditResult removeSceneEdit(const EditState& state, const Arguments& arguments);
// show-scene N [on|off|toggle]
EditResult showSceneEdit(const EditState& state, const Arguments& arguments);

// Why there is no scene `index`.
Text noSuchScene(const Flight& flight, std::size_t index);

// Whether an import fits `space`: nothing has been fitted or set yet.
bool takesFirstScene(const Flight& flight);

// The space in which a box takes `share` of the cube; of a box without any size its place only.
Space fittedSpace(const Space& space, const BoundingBox& box, double share);

// The flight with its space fitted to the box. New's two untouched keys then stand before it and
// look at its middle, with the largest zoom up to 12 that shows all of it from both; other keys
// keep their places in the scene, and it is refused where they can't.
EditResult fitSpaceEdit(const EditState& state, const BoundingBox& box, double share);

}  // namespace vides
