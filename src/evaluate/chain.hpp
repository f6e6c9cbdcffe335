// SPDX-License-Identifier: MIT
// Walking along the chain of all orientations: neighbours, holds between them, signs.
#pragma once

#include <optional>

#include "evaluate/records.hpp"

namespace vides {

// The nearest sections with frames before and after one.
struct Neighbours {
  std::optional<OrientationPlace> previous;
  std::optional<OrientationPlace> next;
};

// A view of the records of one flight. The tree must be complete in stage 1. Records are looked up
// through record(), which a builder overrides to show its unfinished ones.
class Chain {
 public:
  Chain(const EvaluationTree& tree, bool closed, const OrientationMethod& method)
      : tree_(tree), closed_(closed), method_(method) {}
  virtual ~Chain() = default;
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  virtual const KeyRecord& record(std::size_t key) const { return *tree_[key]; }
  const SectionRecord& at(const OrientationPlace& place) const {
    return record(place.key).sections[place.orientation];
  }
  std::size_t keys() const { return tree_.size(); }
  const OrientationMethod& method() const { return method_; }

  // The orientation after `place`; wraps, also in an open flight.
  OrientationPlace after(const OrientationPlace& place) const;
  // The nearest section with frames that begins after (before) `place`. In a closed flight the
  // search goes over the seam and may come back to `place` itself.
  std::optional<OrientationPlace> nextSection(const OrientationPlace& place) const;
  std::optional<OrientationPlace> previousSection(const OrientationPlace& place) const;
  Neighbours neighbours(const OrientationPlace& place) const {
    return {previousSection(place), nextSection(place)};
  }
  // The section with frames that is number `rank` of all.
  OrientationPlace sectionOfRank(std::int64_t rank) const;

  // The last speed value of the section before, the first of the section after.
  std::optional<double> speedBefore(const OrientationPlace& place) const;
  std::optional<double> speedAfter(const OrientationPlace& place) const;

  // Hold frames of the orientations from `first` to `last`, both included, over the seam if need
  // be.
  std::int64_t holdsThrough(const OrientationPlace& first, const OrientationPlace& last) const;

  // The sign that the chain gives to the orientation's quaternion.
  int sign(const OrientationPlace& place) const;
  // The sign between an orientation and the next one (over the seam after the last).
  int linkSign(const OrientationPlace& place) const;

  // What stage 3 needs for the section that begins at `place`, beside those neighbours.
  PathInput pathInput(const OrientationPlace& place, const Neighbours& beside) const;
  LinkSigns linkSigns(const OrientationPlace& place, const Neighbours& beside) const;
  // Whether those signs can be changed by an edit far away.
  bool signsDependOnChain(const OrientationPlace& place, const Neighbours& beside) const;

 private:
  std::int64_t holdsBefore(const OrientationPlace& place) const;
  // The product of the signs from `first` on to `last`, over the seam if need be.
  int signBetween(const OrientationPlace& first, const OrientationPlace& last) const;
  PathSection pathSection(const OrientationPlace& place, int startSign, int linkSign) const;

  const EvaluationTree& tree_;
  bool closed_;
  const OrientationMethod& method_;
};

}  // namespace vides
