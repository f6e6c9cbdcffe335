// SPDX-License-Identifier: MIT
// What the timeline says in its first row: frame and time, and the strip's legend with the values
// at the playhead.
#pragma once

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/flight_graphs.hpp"
#include "panels/ui.hpp"

namespace vides {

// The frame at the left end of the row, the legend at the right one. Where there is no room for
// all, what matters least goes first; every number has a place of its own width, so that nothing
// moves while it changes. Frame and time can be typed: the playhead goes there.
void timelineReadout(Ui& ui, const Rect& row, const Session& session, const FlightGraphs& graphs,
                     Actions& actions);

}  // namespace vides
