// SPDX-License-Identifier: MIT
// Finds the holds without a frame, passing over all that has none.
#include "evaluate/vanished_holds.hpp"

#include <algorithm>

namespace vides {
namespace {

std::vector<std::int32_t> vanishedIn(const EvaluationTree& tree) {
  std::vector<std::int32_t> list;
  const auto wanted = [](const RecordSummary& sum) { return sum.vanishingHolds > 0; };
  tree.forEachWhere(wanted, [&](std::size_t, RecordSummary sum, const RecordPointer& record) {
    for (std::size_t j = 0; j < record->sections.size(); ++j) {
      const SectionRecord& s = record->sections[j];
      if (s.holdMayVanish() && (sum.frames + s.ofHold()).frames() == sum.index()) {
        list.push_back(sum.entries);
      }
      sum = sum + RecordSummary::of(*record, j);
    }
  });
  return list;
}

}  // namespace

const std::vector<std::int32_t>& VanishedHolds::list(const EvaluationTree& tree) const {
  std::call_once(made_, [&] { list_ = vanishedIn(tree); });
  return list_;
}

std::int64_t VanishedHolds::before(std::int32_t entries, const EvaluationTree& tree) const {
  if (tree.summary().vanishingHolds == 0) return 0;
  const std::vector<std::int32_t>& vanished = list(tree);
  return std::lower_bound(vanished.begin(), vanished.end(), entries) - vanished.begin();
}

std::int64_t VanishedHolds::entriesBefore(std::int64_t index, const EvaluationTree& tree) const {
  if (tree.summary().vanishingHolds == 0) return index;
  // As many are skipped as have no more than `index` others before them; that number ascends with
  // their own.
  const std::vector<std::int32_t>& vanished = list(tree);
  std::int64_t first = 0;
  std::int64_t last = static_cast<std::int64_t>(vanished.size());
  while (first < last) {
    const std::int64_t middle = (first + last) / 2;
    if (vanished[static_cast<std::size_t>(middle)] - middle <= index) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  return index + first;
}

}  // namespace vides
