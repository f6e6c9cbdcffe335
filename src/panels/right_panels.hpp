// SPDX-License-Identifier: MIT
// The right column: what the camera sees, the orientation sphere, the flight's measures.
#pragma once

#include <string>

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/flight_graphs.hpp"
#include "panels/ui.hpp"

namespace vides {

// The camera's picture is drawn by somebody else: returns the room for it, of that height and as
// wide as the panel. Where swapped, it is the room for the viewport.
Rect cameraPanel(Ui& ui, Stack& column, float height, const Session& session, Actions& actions);
// Without the picture.
float cameraPanelHeight(const Ui& ui, float width, const Session& session);
// As high as the camera's picture in a column of that width is to be, where `height` is what the
// column has and `rest` what the other panels need at least, and at most: edge to edge in the
// flight's format, though of a usual column at most 40 %, unless there is room to spare.
float pictureHeight(const Ui& ui, float width, float height, const Range& rest,
                    const Session& session);
// Which frame the camera view shows; of a camera that was flown away from it, how far it is zoomed.
std::string cameraCaption(const Ui& ui, const Session& session);
// As large as there is room above `bottom`, between the least and the most side.
void spherePanel(Ui& ui, Stack& column, float bottom, const Session& session, FlightGraphs& graphs,
                 Actions& actions);
float leastSphere(const Ui& ui);
float mostSphere(const Ui& ui);
float measuresPanelHeight(const Ui& ui);
void measuresPanel(Ui& ui, Stack& column, const Session& session, FlightGraphs& graphs);

}  // namespace vides
