// SPDX-License-Identifier: MIT
// How a section meets what lies beyond its start or end: what the speed does there.
#pragma once

#include <optional>

#include "evaluate/evaluation.hpp"

namespace vides {

enum class SectionEnd { kStart, kEnd };

struct Joint {
  enum class Meeting {
    kNothing,    // an open flight begins or ends here; or the section itself stands still
    kRests,      // a hold lies between, or the section beyond is one: the camera stops
    kOtherKind,  // another kind of section lies beyond: what moves here stops
    kGoesOn
  };
  Meeting meeting = Meeting::kNothing;
  // The end value of the section beyond, as it was drawn there; nothing where there is none.
  std::optional<double> value;
  // The value that is as fast here as that is there. Where it goes on; both are the same where
  // neither section has a duration.
  double asFast = 0.0;
  // Where it goes on: whether the speed itself changes, beyond what whole frames make of it.
  bool jumps = false;
  // |b - a| / max(a, b) of the speeds in the two frames' intervals that meet here, as the measures
  // of quality have it: of the way in a move, of the turn in a pan or roll. 1 for a full stop.
  double change = 0.0;

  bool stops() const { return meeting == Meeting::kRests || meeting == Meeting::kOtherKind; }
};

// Of the section that the orientation begins; kNothing where it has no frames.
Joint jointAt(const Evaluation& evaluation, const OrientationPlace& place, SectionEnd end);

// The first (last) speed value with which the section is as fast as the one beyond, to 1e-6 of it:
// of few decimals where one is. Nothing where it doesn't go on, or no value from 1 to 100 does it.
std::optional<double> matchingSpeed(const Evaluation& evaluation, const OrientationPlace& place,
                                    SectionEnd end);

}  // namespace vides
