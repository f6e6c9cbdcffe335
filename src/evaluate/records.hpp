// SPDX-License-Identifier: MIT
// What the evaluator keeps for each key, and the tree of these records with its prefix sums.
//
// A record is made in three stages, each a pure function of what stands before:
//   1 the curve piece and what differs (the flight's keys k-1 ... k+2);
//   2 the speed curve, the number of frames by rate (stage 1 of the nearest sections with frames);
//   3 the orientation curve (stages 1 and 2 of the nearest sections with frames).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "evaluate/frame_sum.hpp"
#include "evaluate/orientation_path.hpp"
#include "evaluate/section.hpp"
#include "flight/flight.hpp"
#include "math/arc_length.hpp"

namespace vides {

struct CurvePiece {
  CubicSegment curve;
  ArcLength arc;
  double length = 0.0;      // cube units; 0 between coincident keys
  bool coincident = false;  // the keys are one place
};

// How the sign of an orientation's quaternion leads to that of the next one: kept, flipped, or,
// where they are perpendicular, always +1.
enum class SignLink : std::uint8_t { kKeep, kFlip, kReset };

// A function from sign to sign; composition is associative.
struct SignMap {
  std::int8_t ofPlus = 1;
  std::int8_t ofMinus = -1;
  int operator()(int sign) const { return sign > 0 ? ofPlus : ofMinus; }
  // First this, then `later`.
  SignMap then(const SignMap& later) const {
    return {static_cast<std::int8_t>(later(ofPlus)), static_cast<std::int8_t>(later(ofMinus))};
  }
  static SignMap of(SignLink link) {
    if (link == SignLink::kKeep) return {1, -1};
    return link == SignLink::kFlip ? SignMap{-1, 1} : SignMap{1, 1};
  }
};

// The signs that a stored orientation curve was made with, each relative to the start of the
// section that it belongs to.
struct LinkSigns {
  std::int8_t own = 1;
  std::int8_t previous = 1;
  std::int8_t next = 1;
  bool operator==(const LinkSigns&) const = default;
};

// One orientation and the section that it begins.
struct SectionRecord {
  // Stage 1: the orientation itself.
  Quaternion q{1.0, 0.0, 0.0, 0.0};  // without the chain's sign
  double zoom = 12.0;
  double roll = 0.0;          // degrees
  FrameParts holdLength = 0;  // 0: none
  // Stage 1: up to the next orientation.
  Quaternion qEnd{1.0, 0.0, 0.0, 0.0};
  double zoomEnd = 12.0;
  Vec3 positionEnd{0.0};
  Vec3 aim{0.0};                 // cube coordinates, where tracking
  double rollChange = 0.0;       // degrees, in [-180, 180]
  double workByRate = 0.0;       // 50 rate M
  double durationFrames = -1.0;  // duration * frame rate, negative where there is none
  FrameParts timedLength = 0;    // the same as a part of a timed stretch; 0 where there is none
  SectionKind kind = SectionKind::kHold;
  SignLink link = SignLink::kKeep;
  bool exists = false;    // has frames
  bool tracking = false;  // a move between absolute aims on one point
  // Stage 2.
  SpeedCurve speed;
  double work = 0.0;
  std::int64_t framesByRate = 0;  // 0 where it is timed
  // Stage 3.
  OrientationPath path;
  LinkSigns signs;
  bool signsDependOnChain = false;

  // Holds of less than half a frame count as none. Those of less than a whole one may be left
  // without a frame by the stretch that they lie in; sections never are.
  bool holds() const { return holdLength > 0; }
  bool holdMayVanish() const { return holds() && holdLength < FrameSum::kFrame; }
  FrameSum ofHold() const { return FrameSum::timed(holdLength); }
  // Of the section itself; nothing where it has no frames.
  FrameSum ofSection() const {
    return framesByRate > 0 ? FrameSum::byRate(framesByRate) : FrameSum::timed(timedLength);
  }
};

// The sections of one key. Most keys have one orientation: that lies in the record itself, so that
// looking up a frame in a long flight waits for memory less often.
class SectionList {
 public:
  std::size_t size() const { return 1 + more_.size(); }
  SectionRecord& operator[](std::size_t j) { return j == 0 ? first_ : more_[j - 1]; }
  const SectionRecord& operator[](std::size_t j) const { return j == 0 ? first_ : more_[j - 1]; }
  // size >= 1.
  void resize(std::size_t size) { more_.resize(size - 1); }

 private:
  SectionRecord first_;
  std::vector<SectionRecord> more_;
};

struct KeyRecord {
  Vec3 position{0.0};
  std::shared_ptr<const CurvePiece> piece;  // null after the last key of an open flight
  SectionList sections;                     // one per orientation

  double lengthOf(const SectionRecord& s) const {
    return s.kind == SectionKind::kMove ? piece->length : 0.0;
  }
};

// A shared record, and beside the pointer to it that to its piece: a search waits for both at once.
class RecordPointer {
 public:
  RecordPointer() = default;
  explicit RecordPointer(std::shared_ptr<const KeyRecord> record)
      : record_(std::move(record)), piece_(record_->piece.get()) {}
  const KeyRecord& operator*() const { return *record_; }
  const KeyRecord* operator->() const { return record_.get(); }
  const KeyRecord* get() const { return record_.get(); }
  const CurvePiece* piece() const { return piece_; }
  bool operator==(const RecordPointer& other) const { return record_ == other.record_; }

 private:
  std::shared_ptr<const KeyRecord> record_;
  const CurvePiece* piece_ = nullptr;
};

__extension__ typedef __int128 FixedPoint;

// Sums over records. Lengths are summed in fixed point (units of 2^-60), so that the sum does not
// depend on the shape of the tree.
struct RecordSummary {
  FrameSum frames;
  std::int32_t entries = 0;         // sections with frames, and holds, those that vanish included
  std::int32_t sections = 0;        // sections with frames, without the holds before them
  std::int32_t vanishingHolds = 0;  // holds that may be left without a frame
  SignMap signs;
  FixedPoint length = 0;

  static RecordSummary of(const RecordPointer& record);
  // Of one orientation with its hold and section.
  static RecordSummary of(const KeyRecord& record, std::size_t orientation);
  RecordSummary operator+(const RecordSummary& o) const {
    return {frames + o.frames,     entries + o.entries,
            sections + o.sections, vanishingHolds + o.vanishingHolds,
            signs.then(o.signs),   length + o.length};
  }
  std::int32_t holds() const { return entries - sections; }
  std::int64_t index() const { return frames.frames(); }
  bool addsUp() const { return frames.addsUp(); }
  static constexpr std::int64_t kIndexSlack = FrameSum::kSlack;
};

class EvaluationTree : public SharedSequence<RecordPointer, RecordSummary> {
 public:
  using SharedSequence::SharedSequence;
};

// Stage 1 of a key's record, in a fresh `record`, from the key and its neighbours (null beyond the
// flight's ends). Its piece is `reuse`, if that has the same curve, else made in `piece`.
void fillRecord(KeyRecord& record, const Flight& flight, const Key* before, const Key& key,
                const Key* next, const Key* afterNext,
                const std::shared_ptr<const CurvePiece>& reuse,
                const std::shared_ptr<CurvePiece>& piece);
// Stage 2.
void setSpeed(SectionRecord& section, std::optional<double> before, std::optional<double> after);

}  // namespace vides
