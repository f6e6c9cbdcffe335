// SPDX-License-Identifier: MIT
// New keys on the curve and beyond its end (2-flight-model, "Insert").
#pragma once

#include <tl/expected.hpp>

#include "evaluate/evaluation.hpp"

namespace vides {

enum class InsertRefusal {
  kAfterLastKey,  // an open flight has no section after its last key
  kTooMany,       // count outside 1 to 10, or more keys than a file may hold
  kAimAtKey,      // an absolute aim would lie on the new key
  kNoRoom,        // the cube leaves no room beyond the last key
};

// Flight with `count` (1 to 10) new keys after key `after`, at equal arc-length distances. They
// take over the key's shape and orientations; their holds are 0; a duration of the divided section
// is split in proportion to arc length. Points outside the cube are brought to its face. Where the
// piece has no length the new keys lie on it all the same.
tl::expected<Flight, InsertRefusal> insertKeys(const Evaluation& evaluation, std::size_t after,
                                               int count);
// One key beyond the last: along the end tangent (the chord where that is zero), a third of the
// last piece's length away, or as far as the cube allows. In a closed flight: halfway to the first
// key.
tl::expected<Flight, InsertRefusal> appendKey(const Evaluation& evaluation);

}  // namespace vides
