// SPDX-License-Identifier: MIT
// The ways in which VPN and VUP go from orientation to orientation (2-flight-model, "Orientation
// curves"): what the reader, lists, commands, the evaluator and the tests know of each.
//
// A method is one file of src/evaluate/ and its line in vides_source_array(… orientationMethods …)
// of the CMakeLists.txt there; its words are flight/orientation_curve_NAME and the tip of that.
#pragma once

#include <span>
#include <string_view>

namespace vides {

class OrientationPath;
struct PathInput;

struct OrientationMethod {
  std::string_view name;  // "smooth": as files, commands and lists name it
  // Moves between absolute aims on one point keep looking at it; their neighbours join in.
  bool tracks = false;
  // The way through one section, given its nearest neighbours with frames. A pure function.
  OrientationPath (*make)(const PathInput&) = nullptr;
};

// All of them, in the order in which they are listed; the first one is the default. Written by the
// build.
std::span<const OrientationMethod* const> orientationMethods();
// The method of that name; null where there is none.
const OrientationMethod* orientationMethod(std::string_view name);

}  // namespace vides
