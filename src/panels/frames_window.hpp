// SPDX-License-Identifier: MIT
// Output → Frames…: which frames are written, how, and into which file.
#pragma once

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"
#include "panels/window_frame.hpp"

namespace vides {

// While frames are written it shows how far it is.
void framesWindow(Ui& ui, const Session& session, WindowPlace& place, Actions& actions);

}  // namespace vides
