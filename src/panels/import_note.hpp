// SPDX-License-Identifier: MIT
// The note about a scene that has just come in: what it is, which way is up, and flying round it.
#pragma once

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"

namespace vides {

// Over the viewport, `top` pixels below its upper edge, until the next edit or its close button.
void importNote(Ui& ui, const Rect& viewport, float top, const Session& session, Actions& actions);

}  // namespace vides
