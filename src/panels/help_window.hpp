// SPDX-License-Identifier: MIT
// The help (F1): every shortcut of the one table, and what the mouse does.
#pragma once

#include "edit/session.hpp"
#include "edit/texts.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"

namespace vides {

void helpWindow(Ui& ui, const Session& session, const Texts& texts, Actions& actions);

}  // namespace vides
