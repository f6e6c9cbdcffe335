// SPDX-License-Identifier: MIT
// Flying the camera by hand: pure functions from camera to camera.
//
// Ways and places are in cube units, angles in radians; "right" is VPN x VUP. VPN and VUP stay unit
// vectors, perpendicular to each other.
#pragma once

#include "evaluate/section.hpp"

namespace vides {

// Yaw about the world's y axis (to the left where positive), pitch about the camera's right axis
// (down where positive), as one turns one's head; the pitch stops at straight up and down.
Camera turnedCamera(const Camera& camera, double yaw, double pitch);
// Sideways, up and ahead, in the camera's axes.
Camera movedCamera(const Camera& camera, double right, double up, double ahead);
// About the VPN: positive turns the VUP as a positive roll does.
Camera rolledCamera(const Camera& camera, double roll);
// Brought into 1 to 100.
Camera zoomedCamera(const Camera& camera, double zoomBy);
// VPN and VUP made unit and perpendicular again.
Camera normalized(Camera camera);

// The roll in degrees that gives this VUP at this VPN, in [-180, 180].
double rollOf(const Camera& camera);

}  // namespace vides
