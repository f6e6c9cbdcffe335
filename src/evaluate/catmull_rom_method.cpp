// SPDX-License-Identifier: MIT
// The method `catmull_rom`: the paper's, by Schlag's construction (4.4.4).
#include "evaluate/orientation_path.hpp"

namespace vides {
namespace {

struct StillCurve {
  Quaternion q;
  Quaternion at(double) const { return q; }
};

OrientationPath make(const PathInput& in) {
  const PathSection& s = in.section;
  if (s.still()) return OrientationPath(TurningPath{StillCurve{s.start}});
  const Quaternion q0 = in.previous ? in.previous->start : slerp(s.end, s.start, 2.0);
  const Quaternion q3 = in.next ? in.next->end : slerp(s.start, s.end, 2.0);
  return OrientationPath(TurningPath{SchlagCurve(q0, s.start, s.end, q3)});
}

}  // namespace

extern const OrientationMethod kCatmullRomMethod{.name = "catmull_rom", .make = make};

}  // namespace vides
