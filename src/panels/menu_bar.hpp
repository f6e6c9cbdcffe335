// SPDX-License-Identifier: MIT
// The menus, and at their right the output line and the flight's name.
#pragma once

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/menu_entries.hpp"
#include "panels/menu_memory.hpp"
#include "panels/ui.hpp"

namespace vides {

// At the top of a window, `height` pixels high; gives back how much the output line takes below it.
float menuBar(Ui& ui, const Session& session, const OutputLine& output, float height,
              MenuMemory& memory, Actions& actions);
// The session's open menu, over all that was drawn before.
void openMenu(Ui& ui, const Session& session, const Layout& layout, MenuMemory& memory,
              Actions& actions);

}  // namespace vides
