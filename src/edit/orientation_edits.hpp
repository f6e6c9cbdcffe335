// SPDX-License-Identifier: MIT
// Edits of the current orientation and of the section it begins. Pure functions.
#pragma once

#include "edit/edit_state.hpp"

namespace vides {

EditResult insertOrientationEdit(const EditState& state, const Arguments& arguments);
EditResult deleteOrientationEdit(const EditState& state, const Arguments& arguments);
EditResult setAimEdit(const EditState& state, const Arguments& arguments);
EditResult moveAimsEdit(const EditState& state, const Arguments& arguments);
EditResult setAimModeEdit(const EditState& state, const Arguments& arguments);
EditResult setRollEdit(const EditState& state, const Arguments& arguments);
EditResult setZoomEdit(const EditState& state, const Arguments& arguments);
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

// Of a selected key the orientation that "the current orientations" of several keys means: that of
// the current one's number, or the key's last.
OrientationPlace orientationLikeCurrent(const EditState& state, std::size_t key);
// The aims of these keys' orientations (like the current one) moved by the same way.
Flight withMovedAims(const EditState& state, const KeySelection& keys, const Vec3& offset);

}  // namespace vides
