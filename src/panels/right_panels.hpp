// SPDX-License-Identifier: MIT
// The right column: what the camera sees, the orientation sphere, the flight's measures.
#pragma once

#include <string>

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/flight_graphs.hpp"
#include "panels/ui.hpp"

namespace vides {

// The camera's picture is drawn by somebody else: returns the room for it.
// Where swapped, it is the room for the viewport.
Rect cameraPanel(Ui& ui, Stack& column, const Session& session, Actions& actions);
// Which frame the camera view shows; of a camera that was flown away from it, how far it is zoomed.
std::string cameraCaption(const Ui& ui, const Session& session);
// As large as there is room above `bottom`.
void spherePanel(Ui& ui, Stack& column, float bottom, const Session& session, FlightGraphs& graphs,
                 Actions& actions);
float measuresPanelHeight(const Ui& ui);
void measuresPanel(Ui& ui, Stack& column, const Session& session, FlightGraphs& graphs);

}  // namespace vides
