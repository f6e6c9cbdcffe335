// SPDX-License-Identifier: MIT
// Edits of keys: insert, append, delete, move, copies. Pure functions.
#pragma once

#include <vector>

#include "edit/edit_state.hpp"

namespace vides {

EditResult insertKeyEdit(const EditState& state, const Arguments& arguments);
EditResult insertKeysEdit(const EditState& state, const Arguments& arguments);
EditResult appendKeyEdit(const EditState& state, const Arguments& arguments);
EditResult deleteKeysEdit(const EditState& state, const Arguments& arguments);
EditResult duplicateKeysEdit(const EditState& state, const Arguments& arguments);
EditResult moveKeyEdit(const EditState& state, const Arguments& arguments);
EditResult moveKeysEdit(const EditState& state, const Arguments& arguments);

// The keys after the current one; they become the selection, the last of them current.
EditResult pastedKeys(const EditState& state, const std::vector<Key>& keys, Text step);

// The part of a way, each coordinate for itself, that keeps all of these keys in the cube.
Vec3 offsetWithinCube(const Flight& flight, const KeySelection& keys, const Vec3& offset);
// All of these keys moved by the same way; absolute aims stay.
Flight withMovedKeys(const Flight& flight, const KeySelection& keys, const Vec3& offset);

}  // namespace vides
