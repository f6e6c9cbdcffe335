// SPDX-License-Identifier: MIT
// What of a flight is seen on a timeline: as many marks as it has pixels, however many keys.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evaluate/evaluation.hpp"

namespace vides {

// A part of the flight along a row of pixels.
struct TimelineRange {
  double firstFrame = 0.0;  // at pixel 0
  double framesPerPixel = 1.0;
  double pixels = 1.0;
  double x(double frame) const { return (frame - firstFrame) / framesPerPixel; }
  double frame(double x) const { return firstFrame + x * framesPerPixel; }
};

struct TimelineMark {
  OrientationPlace place;  // the key's first orientation where several stand on the frame
  std::int64_t frame = 0;
  bool key = false;  // else one of a key's further orientations
};

// From left to right, at least a pixel apart, each in its place.
std::vector<TimelineMark> timelineMarks(const Evaluation& evaluation, const TimelineRange& range);

// The section (or hold) whose end lies within `reach` pixels of a place; of two the nearer one.
std::optional<Section> sectionEndAt(const Evaluation& evaluation, const TimelineRange& range,
                                    double x, double reach);

}  // namespace vides
