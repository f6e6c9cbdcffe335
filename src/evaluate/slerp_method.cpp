// SPDX-License-Identifier: MIT
// The method `slerp`: the shortest way from each orientation to the next, with jumps of angular
// velocity at the joints.
#include "evaluate/orientation_path.hpp"

namespace vides {
namespace {

OrientationPath make(const PathInput& in) {
  return OrientationPath(TurningPath{SlerpArc(in.section.start, in.section.end)});
}

}  // namespace

extern const OrientationMethod kSlerpMethod{.name = "slerp", .make = make};

}  // namespace vides
