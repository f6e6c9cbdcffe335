// SPDX-License-Identifier: MIT
// How many frames a run of holds and sections has (2-flight-model, "Frames").
//
// What is given in seconds is rounded together: holds and sections with a duration that follow one
// another are a timed stretch, whose parts end at the sums of their lengths, rounded. A section by
// rate has a number of its own and ends the stretch. How many frames a part has therefore depends
// on the stretch before it; the sum of a run does not depend on how it is divided.
#pragma once

#include <cstdint>

namespace vides {

// A length in seconds, as whole parts of a frame: 2^24 make a frame.
using FrameParts = std::int64_t;

class FrameSum {
 public:
  FrameSum() = default;
  // A hold or a section with a duration; parts >= 0.
  static FrameSum timed(FrameParts parts) {
    FrameSum sum;
    sum.whole_ = parts >> kBits;
    sum.first_ = static_cast<std::uint32_t>(parts & kMask);
    return sum;
  }
  // A section by rate.
  static FrameSum byRate(std::int64_t frames) {
    FrameSum sum;
    sum.whole_ = frames;
    sum.divided_ = true;
    return sum;
  }
  // seconds * frame rate >= 0 in parts of a frame.
  static FrameParts partsOf(double frames) {
    return static_cast<FrameParts>(frames * static_cast<double>(kFrame) + 0.5);
  }

  // First this run, then `o`. Associative.
  FrameSum operator+(const FrameSum& o) const {
    FrameSum sum;
    sum.whole_ = whole_ + o.whole_;
    sum.divided_ = divided_ || o.divided_;
    const std::uint32_t joined = open() + o.first_;
    sum.first_ = first_;
    sum.last_ = o.last_;
    if (divided_ && o.divided_) {
      sum.whole_ += rounded(joined);
    } else {
      sum.whole_ += joined >> kBits;
      (divided_ ? sum.last_ : sum.first_) = joined & static_cast<std::uint32_t>(kMask);
    }
    return sum;
  }

  bool operator==(const FrameSum&) const = default;

  // Of the run, as if the film began with it.
  std::int64_t frames() const { return whole_ + rounded(first_) + rounded(last_); }
  // Whether a run that follows has as many frames as it has alone.
  bool addsUp() const { return open() == 0; }
  // frames() of a sum lies at most so far from the sum of frames().
  static constexpr std::int64_t kSlack = 1;

  static constexpr int kBits = 24;
  static constexpr FrameParts kFrame = FrameParts{1} << kBits;

 private:
  static constexpr FrameParts kMask = kFrame - 1;

  static std::int64_t rounded(std::uint32_t parts) { return (parts + kFrame / 2) >> kBits; }
  // What the stretch at the end has beyond whole frames.
  std::uint32_t open() const { return divided_ ? last_ : first_; }

  std::int64_t whole_ = 0;
  std::uint32_t first_ = 0;  // parts of a frame in the stretch before the first section by rate
  std::uint32_t last_ = 0;   // and in that after the last; 0 where there is none
  bool divided_ = false;     // there is a section by rate
};

}  // namespace vides
