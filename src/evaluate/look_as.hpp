// SPDX-License-Identifier: MIT
// From a camera to the orientation that sees what it sees.
#pragma once

#include "evaluate/section.hpp"
#include "flight/flight.hpp"

namespace vides {

// Gives the orientation, in its own mode, the aim along the camera's VPN at the given distance from
// the key, on which the camera stands, and the camera's roll and zoom.
void lookAs(const Camera& camera, const Key& key, double distance, Orientation& orientation);
// The roll of the camera as it looks to the orientation's aim, degrees in (-180, 180].
double rollOf(const Camera& camera, const Key& key, const Orientation& orientation);

}  // namespace vides
