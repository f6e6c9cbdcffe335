// SPDX-License-Identifier: MIT
// Edits of shapes, presets, the flight's settings and its space. Pure functions.
#pragma once

#include "edit/edit_state.hpp"

namespace vides {

EditResult setPresetEdit(const EditState& state, const Arguments& arguments);
EditResult setShapeEdit(const EditState& state, const Arguments& arguments);
EditResult setTensionEdit(const EditState& state, const Arguments& arguments);
EditResult setContinuityEdit(const EditState& state, const Arguments& arguments);
EditResult setBiasEdit(const EditState& state, const Arguments& arguments);
EditResult setPresetShapeEdit(const EditState& state, const Arguments& arguments);

EditResult setNameEdit(const EditState& state, const Arguments& arguments);
EditResult setFrameRateEdit(const EditState& state, const Arguments& arguments);
EditResult setPictureEdit(const EditState& state, const Arguments& arguments);
EditResult setLensEdit(const EditState& state, const Arguments& arguments);
EditResult setRatesEdit(const EditState& state, const Arguments& arguments);
EditResult setClosedEdit(const EditState& state, const Arguments& arguments);
EditResult setOrientationCurveEdit(const EditState& state, const Arguments& arguments);
EditResult setSpaceEdit(const EditState& state, const Arguments& arguments);

// The flight in another space: every world position and every frame stays. Refused where that would
// push a key out of the cube.
tl::expected<Flight, Text> inSpace(const Flight& flight, const Space& space);
// The smallest space with the same center that holds a point (given in cube coordinates) with 5 %
// to spare; the same space where it does so already.
Space spaceAround(const Space& space, const Vec3& point);

}  // namespace vides
