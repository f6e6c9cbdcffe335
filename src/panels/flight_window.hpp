// SPDX-License-Identifier: MIT
// File → Flight…: what belongs to the flight as a whole.
#pragma once

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"
#include "panels/window_frame.hpp"

namespace vides {

// Each change is a step of its own; the values follow what else happens to the flight.
void flightWindow(Ui& ui, const Session& session, WindowPlace& place, Actions& actions);

}  // namespace vides
