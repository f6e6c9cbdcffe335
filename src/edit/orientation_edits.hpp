// SPDX-License-Identifier: MIT
// Edits of the current orientation and of the section it begins, and of the orientations that are
// current in the selected keys (aim, roll, zoom). Pure functions.
#pragma once

#include "edit/edit_state.hpp"

namespace vides {

EditResult insertOrientationEdit(const EditState& state, const Arguments& arguments);
EditResult deleteOrientationEdit(const EditState& state, const Arguments& arguments);
EditResult setAimEdit(const EditState& state, const Arguments& arguments);
EditResult setAimCoordinateEdit(const EditState& state, const Arguments& arguments);
EditResult moveAimsEdit(const EditState& state, const Arguments& arguments);
EditResult setAimModeEdit(const EditState& state, const Arguments& arguments);
EditResult setRollEdit(const EditState& state, const Arguments& arguments);
EditResult setZoomEdit(const EditState& state, const Arguments& arguments);
EditResult setFocalLengthEdit(const EditState& state, const Arguments& arguments);
EditResult setFieldOfViewEdit(const EditState& state, const Arguments& arguments);
EditResult setSpeedEdit(const EditState& state, const Arguments& arguments);
EditResult setSpeedValueEdit(const EditState& state, const Arguments& arguments);
EditResult easeEdit(const EditState& state, const Arguments& arguments);
EditResult matchSpeedEdit(const EditState& state, const Arguments& arguments);
EditResult setDurationEdit(const EditState& state, const Arguments& arguments);
EditResult setDurationFramesEdit(const EditState& state, const Arguments& arguments);
EditResult clearDurationEdit(const EditState& state, const Arguments& arguments);
EditResult setHoldEdit(const EditState& state, const Arguments& arguments);

// Whether the current orientation begins a section: all but an open flight's last one.
bool ownsSection(const EditState& state);

// The aims of these keys' current orientations moved by the same way.
Flight withMovedAims(const EditState& state, const KeySelection& keys, const Vec3& offset);

}  // namespace vides
