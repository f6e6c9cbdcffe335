// SPDX-License-Identifier: MIT
// Commands for history, current, selection and playhead.
#include <algorithm>

#include "edit/session_actions.hpp"

namespace vides {
namespace {

using Result = SessionActions::Result;

tl::unexpected<Text> noSuchKey(std::size_t key, const Flight& flight) {
  return tl::unexpected(Text("refusal.no-such-key", {key + 1, flight.keys.size()}));
}

// The place that a key and an optional orientation name.
tl::expected<OrientationPlace, Text> placeFrom(const Session& session, const Arguments& arguments) {
  const Flight& flight = session.flight();
  const std::size_t key = arguments.index(0);
  if (key >= flight.keys.size()) return noSuchKey(key, flight);
  const std::size_t orientation = arguments.has(1) ? arguments.index(1) : 0;
  const std::size_t count = flight.keys[key].orientations.size();
  if (orientation >= count) {
    return tl::unexpected(Text("refusal.no-such-orientation", {orientation + 1, key + 1, count}));
  }
  return OrientationPlace{key, orientation};
}

tl::expected<std::vector<std::size_t>, Text> keysFrom(const Session& session,
                                                      const Arguments& arguments) {
  std::vector<std::size_t> keys;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    keys.push_back(arguments.index(i));
    if (keys.back() >= session.flight().keys.size()) {
      return noSuchKey(keys.back(), session.flight());
    }
  }
  return keys;
}

std::size_t wrapped(std::size_t i, int step, std::size_t size) {
  return (i + size + static_cast<std::size_t>(step + static_cast<int>(size))) % size;
}

}  // namespace

bool switched(const Arguments& arguments, std::size_t index, bool now) {
  if (!arguments.has(index) || arguments.text(index) == "toggle") return !now;
  return arguments.text(index) == "on";
}

// --- History ---

Result SessionActions::undo(Session& session, const Arguments&) {
  if (session.inWindow()) session.interruptWindow();  // what it has changed is undone first
  const Step step = session.history_.undoStep();
  session.showStep(step, step.before, step.marksBefore);
  session.history_.undo();
  session.updateModified();
  session.say(MessageKind::kDone, Text("output.undone", {step.name}));
  return {};
}

Result SessionActions::redo(Session& session, const Arguments&) {
  if (session.inWindow()) session.interruptWindow();
  const Step step = session.history_.redoStep();
  session.showStep(step, step.after, step.marksAfter);
  session.history_.redo();
  session.updateModified();
  session.say(MessageKind::kDone, Text("output.redone", {step.name}));
  return {};
}

// --- Current and selection ---

Result SessionActions::selectKey(Session& session, const Arguments& arguments) {
  const auto place = placeFrom(session, arguments);
  if (!place) return tl::unexpected(place.error());
  session.makeCurrent(marksAt(*place));
  return {};
}

Result SessionActions::makeCurrent(Session& session, const Arguments& arguments) {
  auto place = placeFrom(session, arguments);
  if (!place) return tl::unexpected(place.error());
  // A key that is current already keeps its orientation where none is named.
  if (!arguments.has(1) && place->key == session.current().key) *place = session.current();
  Marks marks = session.state_.marks;
  if (!marks.selected.contains(place->key)) marks = marksAt(*place);
  marks.current = *place;
  session.makeCurrent(marks);
  return {};
}

Result SessionActions::toggleSelect(Session& session, const Arguments& arguments) {
  const auto place = placeFrom(session, arguments);
  if (!place) return tl::unexpected(place.error());
  Marks marks = session.state_.marks;
  const std::size_t key = place->key;
  if (!marks.selected.contains(key)) {
    marks.selected = marks.selected.with(key);
    session.setMarks(marks);
    return {};
  }
  if (marks.selected.size() == 1) return {};  // one is always selected
  marks.selected = marks.selected.without(key);
  if (key != marks.current.key) {
    session.setMarks(marks);
    return {};
  }
  // The current key leaves the selection: the nearest one before it that stays becomes current.
  const std::vector<std::size_t>& keys = marks.selected.keys();
  const auto after = std::upper_bound(keys.begin(), keys.end(), key);
  marks.current = {after == keys.begin() ? keys.front() : *(after - 1), 0};
  session.makeCurrent(marks);
  return {};
}

Result SessionActions::selectKeys(Session& session, const Arguments& arguments) {
  auto keys = keysFrom(session, arguments);
  if (!keys) return tl::unexpected(keys.error());
  Marks marks = session.state_.marks;
  const std::size_t first = keys->front();
  marks.selected = KeySelection(std::move(*keys));
  if (marks.selected.contains(marks.current.key)) {
    session.setMarks(marks);
  } else {
    marks.current = {first, 0};
    session.makeCurrent(marks);
  }
  return {};
}

Result SessionActions::addToSelection(Session& session, const Arguments& arguments) {
  auto keys = keysFrom(session, arguments);
  if (!keys) return tl::unexpected(keys.error());
  Marks marks = session.state_.marks;
  const std::vector<std::size_t>& old = marks.selected.keys();
  keys->insert(keys->end(), old.begin(), old.end());
  marks.selected = KeySelection(std::move(*keys));
  session.setMarks(marks);
  return {};
}

Result SessionActions::selectAll(Session& session, const Arguments&) {
  Marks marks = session.state_.marks;
  marks.selected = KeySelection::range(0, session.flight().keys.size());
  session.setMarks(marks);
  return {};
}

Result SessionActions::nextKey(Session& session, const Arguments&) {
  session.makeCurrent(
      marksAt({wrapped(session.current().key, 1, session.flight().keys.size()), 0}));
  return {};
}

Result SessionActions::previousKey(Session& session, const Arguments&) {
  session.makeCurrent(
      marksAt({wrapped(session.current().key, -1, session.flight().keys.size()), 0}));
  return {};
}

Result SessionActions::nextOrientation(Session& session, const Arguments&) {
  Marks marks = session.state_.marks;
  std::size_t& orientation = marks.current.orientation;
  orientation = wrapped(orientation, 1, session.currentKey().orientations.size());
  session.makeCurrent(marks);
  return {};
}

Result SessionActions::previousOrientation(Session& session, const Arguments&) {
  Marks marks = session.state_.marks;
  std::size_t& orientation = marks.current.orientation;
  orientation = wrapped(orientation, -1, session.currentKey().orientations.size());
  session.makeCurrent(marks);
  return {};
}

// --- The playhead ---

Result SessionActions::play(Session& session, const Arguments& arguments) {
  Playback& playback = session.playback_;
  if (switched(arguments, 0, playback.playing())) {
    // The camera view shows what is played.
    session.freeCamera_.reset();
    if (!playback.playing()) playback.play(session.evaluation().frameCount());
  } else {
    playback.stop();
  }
  return {};
}

Result SessionActions::goToFrame(Session& session, const Arguments& arguments) {
  const double last = static_cast<double>(session.evaluation().frameCount() - 1);
  session.playback_.goTo(static_cast<std::int64_t>(std::min(arguments.number(0), last)));
  return {};
}

Result SessionActions::nextFrame(Session& session, const Arguments&) {
  session.playback_.stop();
  session.playback_.goTo(std::min(session.frame() + 1, session.evaluation().frameCount() - 1));
  return {};
}

Result SessionActions::previousFrame(Session& session, const Arguments&) {
  session.playback_.stop();
  session.playback_.goTo(std::max<std::int64_t>(session.frame() - 1, 0));
  return {};
}

Result SessionActions::goToNextOrientation(Session& session, const Arguments&) {
  session.playback_.stop();
  const Evaluation& evaluation = session.evaluation();
  const auto here = evaluation.sectionAtFrame(session.frame());
  if (!here) return {};
  std::int64_t frame = evaluation.frameOf(here->to);
  for (std::int64_t i = here->index + 1; frame <= session.frame() && i < evaluation.sectionCount();
       ++i) {
    frame = evaluation.frameOf(evaluation.section(i).to);
  }
  // A closed flight's last section leads back to frame 0: there is nothing after it.
  if (frame > session.frame()) session.playback_.goTo(frame);
  return {};
}

Result SessionActions::goToPreviousOrientation(Session& session, const Arguments&) {
  session.playback_.stop();
  const Evaluation& evaluation = session.evaluation();
  const auto here = evaluation.sectionAtFrame(session.frame());
  if (!here) return {};
  std::int64_t frame = evaluation.frameOf(here->from);
  for (std::int64_t i = here->index - 1; frame >= session.frame() && i >= 0; --i) {
    frame = evaluation.frameOf(evaluation.section(i).from);
  }
  if (frame < session.frame()) session.playback_.goTo(frame);
  return {};
}

Result SessionActions::firstFrame(Session& session, const Arguments&) {
  session.playback_.goTo(0);
  return {};
}

Result SessionActions::lastFrame(Session& session, const Arguments&) {
  session.playback_.goTo(session.evaluation().frameCount() - 1);
  return {};
}

Result SessionActions::loop(Session& session, const Arguments& arguments) {
  session.playback_.setLoop(switched(arguments, 0, session.playback().loop()));
  return {};
}

}  // namespace vides
