// SPDX-License-Identifier: MIT
// Cameras as Euler angles in Nuke's default order ZXY, continuous from frame to frame.
//
// Camera to world: [right up back] = R_y(ry) R_x(rx) R_z(rz), with right = VPN x VUP, up = VUP and
// back = -VPN; so rx > 0 looks up.
#pragma once

#include <optional>

#include "evaluate/section.hpp"

namespace vides {

struct CameraAngles {
  double rx = 0.0;  // degrees
  double ry = 0.0;
  double rz = 0.0;
};

// The angles of one camera after the other. The first camera's lie in [-180, 180], its rx in
// [-90, 90]. The following ones continue: of all triples that give the camera, the one that is
// nearest to the triple before. So no angle jumps at +-180 degrees, nor do ry and rz turn by half a
// turn where the camera passes over a pole: there rx goes on beyond 90 degrees. Where the camera
// looks straight up or down (within 1e-7 rad) only rx and the sum (looking up, the difference) of
// the others are fixed: rz stays as it was (0 at the start), and ry takes the rest.
class AngleChain {
 public:
  CameraAngles next(const Camera& camera);

 private:
  std::optional<CameraAngles> before_;
};

}  // namespace vides
