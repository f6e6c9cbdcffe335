// SPDX-License-Identifier: MIT
// The inside of an Evaluation, shared by random access and the walk.
#pragma once

#include "evaluate/chain.hpp"
#include "evaluate/evaluation.hpp"
#include "evaluate/records.hpp"

namespace vides {

struct Evaluation::State {
  Flight flight;
  EvaluationTree tree;

  Chain chain() const { return Chain(tree, flight.closed, *flight.orientationCurve); }
  std::int64_t frameCount() const;
  // The hold before an orientation, or the section that it begins.
  Section entryAt(const OrientationPlace& place, bool inHold) const;
  // The place of the last orientation of the chain.
  OrientationPlace lastPlace() const;
};

// The orientation curve of a section that has frames; made anew into `made` where the stored one
// was made with other signs.
const OrientationPath& pathOf(const Chain& chain, const OrientationPlace& place,
                              const SectionRecord& section, OrientationPath& made);

// The camera on the orientation that `section` begins with.
Camera cameraAtStart(const KeyRecord& record, const SectionRecord& section);

// The camera so many frames, 0 to less than section.frames, after the section's first.
Camera cameraInSection(const KeyRecord& record, const SectionRecord& section,
                       const OrientationPath& path, double step);

}  // namespace vides
