// SPDX-License-Identifier: MIT
// File → Scenes…: a row a file, shown or hidden, its up axis, sought, read again, removed.
#pragma once

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"
#include "panels/window_frame.hpp"

namespace vides {

void sceneWindow(Ui& ui, const Session& session, WindowPlace& place, Actions& actions);

}  // namespace vides
