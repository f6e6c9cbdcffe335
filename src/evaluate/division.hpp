// SPDX-License-Identifier: MIT
// Dividing what happens at a moment of the film by a key or an orientation there (2-flight-model
// and 5-editor, "Insert at the playhead").
//
// The film stays: as many frames in all, the divided moment on the same frame, and up to it and
// from it on the same shares of the way, frame by frame, as nearly as ten speeds can say it. Only
// the curve may bend, as after `Pos +`.
#pragma once

#include <cstdint>
#include <tl/expected.hpp>

#include "evaluate/evaluation.hpp"

namespace vides {

enum class DivisionRefusal {
  kNothingHappens,       // no section has frames
  kSectionBegins,        // an orientation stands on the frame already
  kFlightEnds,           // on the last frame of an open flight
  kOneFrame,             // the section is too short to be divided
  kKeyIsThere,           // the place is a key's, or the piece has no length
  kTooManyKeys,          // more than a file may hold
  kTooManyOrientations,  // more than a key may have
  kOutsideCube,          // the curve has left the cube there
  kNoSuchPiece,
};

struct Division {
  Flight flight;
  OrientationPlace place;  // of what has been inserted
};

// On a frame. In a move a key comes on the curve, in a pan, roll or zoom an orientation at the same
// key, in a hold an orientation that goes on resting.
tl::expected<Division, DivisionRefusal> divideAtFrame(const Evaluation& evaluation,
                                                      std::int64_t frame);
// At a fraction (0 to 1) of the arc length of the piece that begins at key `piece`: the key comes
// to that place, and the frame next to the moment hits it.
tl::expected<Division, DivisionRefusal> divideAtPlace(const Evaluation& evaluation,
                                                      std::size_t piece, double fraction);

// The camera at the moment that would be divided at that place.
Camera cameraAtPlace(const Evaluation& evaluation, std::size_t piece, double fraction);

}  // namespace vides
