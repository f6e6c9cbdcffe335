// SPDX-License-Identifier: MIT
// The inside of an Evaluation, shared by random access and the walk.
#pragma once

#include "evaluate/chain.hpp"
#include "evaluate/evaluation.hpp"
#include "evaluate/records.hpp"
#include "evaluate/vanished_holds.hpp"

namespace vides {

struct Evaluation::State {
  State(Flight ofFlight, EvaluationTree ofTree)
      : flight(std::move(ofFlight)), tree(std::move(ofTree)) {}

  Flight flight;
  EvaluationTree tree;
  VanishedHolds vanished;

  Chain chain() const { return Chain(tree, flight.closed, flight.orientationCurve); }
  std::int64_t frameCount() const;
  // The hold before an orientation, or the section that it begins; it must have frames.
  Section entryAt(const OrientationPlace& place, bool inHold) const;
  // The number, in the list of sections, of the entry that so many others precede.
  std::int64_t indexAfter(std::int32_t entries) const {
    return entries - vanished.before(entries, tree);
  }
  // The place of the last orientation of the chain.
  OrientationPlace lastPlace() const;
};

// The orientation curve of a section that has frames; made anew into `made` where the stored one
// was made with other signs.
const OrientationPath& pathOf(const Chain& chain, const OrientationPlace& place,
                              const SectionRecord& section, OrientationPath& made);

// The camera on the orientation that `section` begins with.
Camera cameraAtStart(const KeyRecord& record, const SectionRecord& section);

// The camera at tau in [0, 1), the share of the section's time that has passed.
Camera cameraInSection(const KeyRecord& record, const SectionRecord& section,
                       const OrientationPath& path, double tau);

}  // namespace vides
