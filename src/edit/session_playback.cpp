// SPDX-License-Identifier: MIT
// Commands for what is played, and how fast: the session's, in no file.
#include <algorithm>

#include "edit/playback_speed.hpp"
#include "edit/session_actions.hpp"
#include "math/whole.hpp"

namespace vides {
namespace {

using Result = SessionActions::Result;

// The frame that is named, at most the last one; without one the playhead's.
std::int64_t frameFrom(const Session& session, const Arguments& arguments) {
  if (!arguments.has(0)) return session.frame();
  const std::int64_t last = session.evaluation().frameCount() - 1;
  return wholeWithin(arguments.number(0), 0, last);
}

Text rangeText(const Session& session) {
  const Playback::Span span = session.playback().span(session.evaluation().frameCount());
  return Text("output.range", {span.first, span.last});
}

}  // namespace

Result SessionActions::setIn(Session& session, const Arguments& arguments) {
  session.playback_.setIn(frameFrom(session, arguments));
  session.say(MessageKind::kDone, rangeText(session));
  return {};
}

Result SessionActions::setOut(Session& session, const Arguments& arguments) {
  session.playback_.setOut(frameFrom(session, arguments));
  session.say(MessageKind::kDone, rangeText(session));
  return {};
}

Result SessionActions::clearRange(Session& session, const Arguments&) {
  session.playback_.clearRange();
  session.say(MessageKind::kDone, "output.range-cleared");
  return {};
}

Result SessionActions::playbackSpeed(Session& session, const Arguments& arguments) {
  const auto* const speed =
      std::ranges::find(kPlaybackSpeeds, arguments.text(0), &PlaybackSpeed::name);
  session.playback_.setSpeed(speed->times);
  session.say(MessageKind::kDone, Text("output.playback-speed", {speed->shown}));
  return {};
}

}  // namespace vides
