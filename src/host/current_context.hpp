// SPDX-License-Identifier: MIT
// Whose OpenGL context this thread draws with.
//
// Each library knows of its own contexts only: where two of them draw in turn on one thread, each
// takes the one that it made current last for the current one still. So hosts ask here.
#pragma once

namespace vides {

// Contexts are told apart by their addresses; null: none.
bool isCurrentContext(const void* context);
void setCurrentContext(const void* context);

}  // namespace vides
