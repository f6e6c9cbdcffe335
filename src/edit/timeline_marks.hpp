// SPDX-License-Identifier: MIT
// What of a flight is seen on a timeline: as many marks as it has pixels, however many keys.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
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
  // A section without frames lies here: several orientations stand on the frame.
  bool silent = false;
};

// From left to right, each in its place, at least kLeastApart pixels apart.
inline constexpr double kLeastApart = 2.0;
std::vector<TimelineMark> timelineMarks(const Evaluation& evaluation, const TimelineRange& range);
// The sections that are seen; of those that begin nearer to each other the first.
std::vector<Section> timelineSections(const Evaluation& evaluation, const TimelineRange& range);

// Both for pieces of the flight, kept while it is scrolled: only what comes into sight is looked up
// then, however many keys there are.
class TimelineCache {
 public:
  static constexpr double kChunkPixels = 64.0;
  struct Chunk {
    std::vector<Section> sections;
    std::vector<TimelineMark> marks;
  };
  // Call before the rest. Another flight, or another scale, and everything is looked up anew.
  void follow(const Evaluation& evaluation, double framesPerPixel);
  // Chunk n begins n · kChunkPixels pixels after frame 0.
  const Chunk& chunk(std::int64_t number);

 private:
  static constexpr std::size_t kMostChunks = 512;
  std::optional<Evaluation> evaluation_;
  double framesPerPixel_ = 0.0;
  std::unordered_map<std::int64_t, Chunk> chunks_;
};

// The section (or hold) whose end lies within `reach` pixels of a place; of two the nearer one.
std::optional<Section> sectionEndAt(const Evaluation& evaluation, const TimelineRange& range,
                                    double x, double reach);

}  // namespace vides
