// SPDX-License-Identifier: MIT
// The one evaluator: a flight becomes curve, sections and frames (2-flight-model).
//
// An Evaluation is an immutable value and a pure function of the flight; copies are O(1) and may be
// read by any number of threads. It keeps one record per key in a tree with prefix sums, so that
// frame n is found in O(log n). updated() recomputes only the records that an edit reaches: the
// curve pieces of four, the speeds of six and the orientation curves of eight neighbouring keys.
// How many frames a part of a timed stretch has is found when it is asked for, from prefix sums too
// (frame_sum.hpp), so that an edit early in a long one costs no more than any other.
// What it yields equals an evaluation from scratch, bit for bit.
//
// Signs of the orientation quaternions depend on the chain before them only where two consecutive
// ones are perpendicular; that parity is prefix data of the tree, looked up where it matters.
//
// The flight must be valid (flight/validation.hpp): at least two keys, every value in its range.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "evaluate/section.hpp"
#include "flight/flight.hpp"
#include "math/arc_length.hpp"
#include "math/cubic_segment.hpp"
#include "math/speed_curve.hpp"

namespace vides {

struct KeyRecord;
struct SectionRecord;
class EvaluationTree;

class Evaluation {
 public:
  // Of newFlight().
  Evaluation();
  explicit Evaluation(const Flight& flight);
  // The evaluation of `flight`, reusing what it shares with the flight of this one.
  Evaluation updated(const Flight& flight) const;

  const Flight& flight() const;
  // Whether both are copies of one evaluation: a cheap look for what is kept between pictures.
  bool sameAs(const Evaluation& other) const { return state_ == other.state_; }

  // At least 1.
  std::int64_t frameCount() const;
  // The camera of frame n, clamped into [0, frameCount() - 1].
  Frame frame(std::int64_t n) const;
  // The camera at a moment between frames, as the curves lead through it: frame(n)'s where
  // `position` is the whole number n. Clamped like there; not a number counts as 0.
  Camera cameraBetween(double position) const;

  std::int64_t sectionCount() const;
  // index < sectionCount().
  Section section(std::int64_t index) const;
  // The section that frame n belongs to; nothing in a flight whose sections have no frames.
  std::optional<Section> sectionAtFrame(std::int64_t n) const;
  // The section (or, where it has no frames, nothing) that the orientation begins.
  std::optional<Section> sectionFrom(const OrientationPlace& place) const;
  // The hold before an orientation, where it has frames.
  std::optional<Section> holdBefore(const OrientationPlace& place) const;
  // The length of the whole curve that is travelled, cube units.
  double length() const;

  // The first frame that stands on the orientation.
  std::int64_t frameOf(const OrientationPlace& place) const;
  // The camera on an orientation.
  Camera cameraAt(const OrientationPlace& place) const;
  // The orientation that a section from `place` leads to: the next one, or its own place at the end
  // of an open flight.
  OrientationPlace next(const OrientationPlace& place) const;

  // The curve: piece k leads from key k to the next. An open flight has one piece less than keys.
  std::size_t pieceCount() const;
  const CubicSegment& piece(std::size_t k) const;
  double pieceLength(std::size_t k) const;
  // The point at the given fraction (0 to 1) of a piece's arc length, and its curve parameter.
  double pieceParameter(std::size_t k, double fraction) const;
  Vec3 piecePoint(std::size_t k, double fraction) const;
  // Changes when the piece is recomputed, stays when it is shared between evaluations: a key for
  // caches of what is drawn. Valid while some evaluation that holds the piece lives.
  const void* pieceIdentity(std::size_t k) const;
  // All at once for the pieces [first, last): much quicker than asking for one after the other.
  using PieceVisitor =
      std::function<void(std::size_t k, const void* identity, const CubicSegment& piece)>;
  void forEachPiece(std::size_t first, std::size_t last, const PieceVisitor& visit) const;
  // Ranges [first, last) of pieces, ascending, outside which all pieces are those of `other`, a
  // flight with as many keys. In time proportional to what the two do not share.
  struct PieceRange {
    std::size_t first = 0;
    std::size_t last = 0;
  };
  std::vector<PieceRange> changedPieces(const Evaluation& other) const;

  // The speed curve as it is used: with its neighbours' ends, limited.
  const SpeedCurve& speedCurve(const OrientationPlace& place) const;
  // The last speed value of the section before and the first of the section after, where the curve
  // goes on over the joint: between sections of one kind, without a rest.
  std::optional<double> speedBefore(const OrientationPlace& place) const;
  std::optional<double> speedAfter(const OrientationPlace& place) const;
  // What lies beyond the start or the end of the section that the orientation begins.
  struct Beyond {
    std::optional<OrientationPlace> section;  // the nearest with frames; none at a flight's end
    bool rests = false;                       // a hold lies between, or at the flight's end
  };
  Beyond before(const OrientationPlace& place) const;
  Beyond after(const OrientationPlace& place) const;
  // By how many whole turns the roll differs between the orientation and the next one where
  // nothing else does: such a section has nothing to do. 0 for all others.
  std::int64_t idleTurns(const OrientationPlace& place) const;

 private:
  friend class FrameWalk;
  struct State;
  explicit Evaluation(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

// All frames from `first` up to, not including, `last` (clipped to the flight), one after the
// other. Each equals Evaluation::frame of its number bit for bit. Holds its own copy of the
// evaluation.
class FrameWalk {
 public:
  explicit FrameWalk(const Evaluation& evaluation);
  FrameWalk(const Evaluation& evaluation, std::int64_t first, std::int64_t last);
  ~FrameWalk();
  FrameWalk(FrameWalk&&) noexcept;
  FrameWalk& operator=(FrameWalk&&) noexcept;

  // The next frame; false (and `frame` untouched) after the last.
  bool next(Frame& frame);
  std::int64_t position() const { return position_; }  // the number of the frame that comes next
  std::int64_t last() const { return last_; }

 private:
  struct Place;
  std::shared_ptr<const Evaluation::State> state_;
  std::int64_t position_ = 0;
  std::int64_t last_ = 0;
  std::unique_ptr<Place> place_;
};

}  // namespace vides
