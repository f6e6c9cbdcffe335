// SPDX-License-Identifier: MIT
// Which host has made its OpenGL context current last on this thread.
//
// Each library knows of its own contexts only: where two of them draw in turn on one thread, each
// takes the one that it made current last for the current one still. And other code may make its
// own current without telling us. So a host's context is current where both say so: its library,
// and what is kept here.
#pragma once

namespace vides {

// Contexts are told apart by their addresses; null: none.
bool isCurrentContext(const void* context);
void setCurrentContext(const void* context);

}  // namespace vides
