// SPDX-License-Identifier: MIT
// Makes the tree of records, from scratch or from the one before an edit.
#pragma once

#include "evaluate/records.hpp"

namespace vides {

EvaluationTree buildTree(const Flight& flight);

// `tree` belongs to `old`; the result equals buildTree(flight).
EvaluationTree updateTree(const EvaluationTree& tree, const Flight& old, const Flight& flight);

}  // namespace vides
