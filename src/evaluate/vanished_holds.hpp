// SPDX-License-Identifier: MIT
// Holds that a timed stretch leaves without a frame: lists of sections leave them out.
//
// A hold between half a frame and a whole one gets a frame or none, depending on where in its
// stretch it falls. An edit changes that for all that follow in the stretch, so it is no sum over
// the records: it is found out when first asked for, and only where there are such holds.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "evaluate/records.hpp"

namespace vides {

// Of one tree, which must not change. Any number of threads may ask at once.
class VanishedHolds {
 public:
  // How many of the first `entries` entries of the tree (holds and sections) have vanished.
  std::int64_t before(std::int32_t entries, const EvaluationTree& tree) const;
  // How many entries of the tree, the vanished ones included, stand before the one that is number
  // `index` of those that haven't vanished.
  std::int64_t entriesBefore(std::int64_t index, const EvaluationTree& tree) const;

 private:
  // Numbers of entries, ascending.
  const std::vector<std::int32_t>& list(const EvaluationTree& tree) const;

  mutable std::once_flag made_;
  mutable std::vector<std::int32_t> list_;
};

}  // namespace vides
