// SPDX-License-Identifier: MIT
// A mark's two sections get durations; what is timed behind them keeps its frames.
#include "edit/mark_edits.hpp"

#include <cmath>

namespace vides {
namespace {

// A hold before a section, which is an entry of its own.
bool isHold(const Section& entry) { return entry.from == entry.to; }

bool isTimed(const Flight& flight, const Section& entry) {
  const Orientation& o = flight.keys[entry.from.key].orientations[entry.from.orientation];
  return isHold(entry) || o.duration.has_value();
}

// Gives an entry a length in whole frames.
Flight withFrames(const Flight& flight, const Section& entry, std::int64_t frames) {
  Key key = flight.keys[entry.from.key];
  Orientation& o = key.orientations[entry.from.orientation];
  const double seconds = static_cast<double>(frames) / flight.frameRate;
  if (isHold(entry)) {
    o.hold = seconds;
  } else {
    o.duration = seconds;
  }
  return withKey(flight, entry.from.key, std::move(key));
}

// What is given in seconds is rounded together over a whole stretch: behind a section that has
// another length now, one may have gained or lost a frame. Of the entries [first, past), up to the
// first section by rate, such a one gets the frames that it had.
Flight withFramesKept(const Evaluation& before, Flight flight, std::int64_t first,
                      std::int64_t past) {
  Evaluation now = before.updated(flight);
  for (std::int64_t i = first; i < past; ++i) {
    const Section had = before.section(i);
    if (!isTimed(flight, had)) break;
    if (i < now.sectionCount()) {
      const Section has = now.section(i);
      if (has.from == had.from && has.to == had.to && has.frames == had.frames) continue;
    }
    flight = withFrames(flight, had, had.frames);
    now = now.updated(flight);
  }
  return flight;
}

}  // namespace

std::optional<MarkNeighbours> markNeighbours(const Evaluation& evaluation,
                                             const OrientationPlace& place) {
  const std::int64_t frame = evaluation.frameOf(place);
  const auto at = evaluation.sectionAtFrame(frame);
  // Inside a section stands only what lies behind the flight's last one.
  if (!at || at->firstFrame != frame) return std::nullopt;
  std::int64_t before = at->index - 1, after = at->index;
  while (before >= 0 && isHold(evaluation.section(before))) --before;
  while (after < evaluation.sectionCount() && isHold(evaluation.section(after))) ++after;
  if (before < 0 || after == evaluation.sectionCount()) return std::nullopt;
  return MarkNeighbours{evaluation.section(before), evaluation.section(after)};
}

EditResult moveMarkEdit(const EditState& state, const Arguments& arguments) {
  const OrientationPlace place{arguments.index(0), arguments.index(1)};
  const auto& keys = state.flight.keys;
  if (place.key >= keys.size()) {
    return tl::unexpected(Text("refusal.no-such-key", {place.key + 1, keys.size()}));
  }
  const std::size_t count = keys[place.key].orientations.size();
  if (place.orientation >= count) {
    return tl::unexpected(
        Text("refusal.no-such-orientation", {place.orientation + 1, place.key + 1, count}));
  }
  const auto neighbours = markNeighbours(state.evaluation, place);
  if (!neighbours) return tl::unexpected(Text("refusal.mark-fixed"));
  const double by = arguments.number(2);
  if (std::trunc(by) != by || by < static_cast<double>(neighbours->least()) ||
      by > static_cast<double>(neighbours->most())) {
    return tl::unexpected(
        Text("refusal.mark-range", {neighbours->least(), neighbours->most(), by}));
  }
  const auto frames = static_cast<std::int64_t>(by);
  const auto& [before, after] = *neighbours;
  Edit edit{state.flight, Text("step.move-mark", {place.key + 1}), state.marks};
  if (frames != 0) {
    edit.flight = withFrames(edit.flight, before, before.frames + frames);
    // Holds between them first: these decide where the section after begins.
    edit.flight =
        withFramesKept(state.evaluation, std::move(edit.flight), before.index + 1, after.index);
    edit.flight = withFrames(edit.flight, after, after.frames - frames);
    edit.flight = withFramesKept(state.evaluation, std::move(edit.flight), after.index + 1,
                                 state.evaluation.sectionCount());
  }
  edit.note = Text("output.mark-moved", {place.key + 1, state.evaluation.frameOf(place) + frames,
                                         before.frames + frames, after.frames - frames});
  return edit;
}

}  // namespace vides
