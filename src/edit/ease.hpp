// SPDX-License-Identifier: MIT
// Speed curves that start or end at rest (the lecture's ease functions, as speeds).
//
// At tau = j/9, with the peak P chosen so that the mean is the base speed 50 (before the floor at
// 1), so that a section keeps about its length in frames:
//   constant      v = 50
//   sine          in: P sin(pi tau / 2); out: P cos(pi tau / 2); in and out: P sin(pi tau); P = 25
//   pi parabola      the way is a parabola, the acceleration constant:
//                 in: P tau; out: P (1 - tau); in and out: P min(2 tau, 2 - 2 tau); P = 100
//   acceleration  constant acceleration, then speed, then deceleration, each ramp a third long:
//                 in: P min(3 tau, 1); out: P min(3 - 3 tau, 1), P = 60;
//                 in and out: P min(3 tau, 1, 3 - 3 tau), P = 75
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "math/speed_curve.hpp"

namespace vides {

// "constant", "in-sine", "out-sine", "in-out-sine", "in-parabola", …, "in-out-acceleration".
const std::vector<std::string_view>& easeNames();
// Nothing for other names. Values in [1, 100].
std::optional<SpeedValues> easeValues(std::string_view name);

}  // namespace vides
