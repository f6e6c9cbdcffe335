// SPDX-License-Identifier: MIT
// Marks of the timeline moved along: the section before takes from, or gives to, the one after.
#pragma once

#include <cstdint>
#include <optional>

#include "edit/edit_state.hpp"

namespace vides {

// What a mark stands between, holds apart: they stay with it and keep their frames.
struct MarkNeighbours {
  Section before, after;
  // By so many frames it can be moved, so that either keeps one.
  std::int64_t least() const { return 1 - before.frames; }
  std::int64_t most() const { return after.frames - 1; }
};
// Nothing for the first and the last mark, which are fixed; in a closed flight the last one is the
// first again. Several orientations on one frame are one mark.
std::optional<MarkNeighbours> markNeighbours(const Evaluation& evaluation,
                                             const OrientationPlace& place);

// KEY ORIENTATION FRAMES: moves the mark by so many frames, as durations in whole frames. The
// film's length and the frames of all other sections and holds stay.
EditResult moveMarkEdit(const EditState& state, const Arguments& arguments);

}  // namespace vides
