// SPDX-License-Identifier: MIT
// Edits that divide what happens at a moment.
#include "edit/division_edits.hpp"

#include "evaluate/division.hpp"

namespace vides {
namespace {

Text textOf(DivisionRefusal refusal) {
  switch (refusal) {
    case DivisionRefusal::kNothingHappens:
      return "refusal.nothing-happens";
    case DivisionRefusal::kSectionBegins:
      return "refusal.section-begins";
    case DivisionRefusal::kFlightEnds:
      return "refusal.flight-ends";
    case DivisionRefusal::kOneFrame:
      return "refusal.one-frame";
    case DivisionRefusal::kKeyIsThere:
      return "refusal.key-is-there";
    case DivisionRefusal::kTooManyKeys:
      return "refusal.too-many-keys";
    case DivisionRefusal::kTooManyOrientations:
      return "refusal.ten-orientations";
    case DivisionRefusal::kOutsideCube:
      return kCurveOutsideCube;
    case DivisionRefusal::kNoSuchPiece:
      return "refusal.after-last-key";
  }
  return {};
}

// What has been inserted becomes current; the playhead stands on it.
EditResult edited(const EditState& state, const tl::expected<Division, DivisionRefusal>& division) {
  if (!division) return tl::unexpected(textOf(division.error()));
  const OrientationPlace place = division->place;
  const bool key = division->flight.keys.size() > state.flight.keys.size();
  Edit edit{division->flight,
            Text(key ? "step.insert-key" : "step.insert-orientation", {place.key + 1}),
            marksAt(place)};
  return edit;
}

}  // namespace

EditResult insertAtFrame(const EditState& state, std::int64_t frame) {
  EditResult edit = edited(state, divideAtFrame(state.evaluation, frame));
  if (edit) edit->keepsPlayhead = true;
  return edit;
}

EditResult insertAtPlace(const EditState& state, std::size_t after, double fraction) {
  const std::size_t size = state.flight.keys.size();
  if (after >= size) return tl::unexpected(Text("refusal.no-such-key", {after + 1, size}));
  if (fraction < 0.0 || fraction > 1.0) {
    return tl::unexpected(Text("refusal.fraction", {fraction}));
  }
  return edited(state, divideAtPlace(state.evaluation, after, fraction));
}

}  // namespace vides
