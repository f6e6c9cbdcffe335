// SPDX-License-Identifier: MIT
// When the window's display frames are drawn, and what happens where one fails.
#include "app/window_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <thread>
#include <utility>

#include "app/messages.hpp"

namespace vides {
namespace {

// Screens faster than this gain nothing; without vertical synchronisation we limit ourselves.
constexpr double kLeastFrameSeconds = 1.0 / 120.0;
constexpr std::chrono::duration<double> kLongest = std::chrono::hours(1);

CursorShape cursorOf(PointerShape shape) {
  switch (shape) {
    case PointerShape::kText:
      return CursorShape::kText;
    case PointerShape::kHand:
    case PointerShape::kMove:
      return CursorShape::kHand;
    case PointerShape::kHorizontal:
      return CursorShape::kHorizontal;
    case PointerShape::kVertical:
      return CursorShape::kVertical;
    case PointerShape::kArrow:
      break;
  }
  return CursorShape::kArrow;
}

}  // namespace

WindowLoop::WindowLoop(Host& host, Editor& editor, UserFiles& userFiles, RecoveryKeeper& recovery)
    : host_(host), editor_(editor), userFiles_(userFiles), recovery_(recovery) {}

WindowLoop::State WindowLoop::step() {
  try {
    const State state = stepOrThrow();
    return state;
  } catch (const std::exception& error) {
    return failed(error.what());
  }
}

WindowLoop::State WindowLoop::failed(const std::string& why) {
  const bool givesUp = ++failures_ >= kMostFailures;
  try {
    const bool kept = recovery_.keepNow(editor_.session());
    const std::string after = kept && givesUp ? "; what was unsaved is offered at the next start"
                              : kept          ? "; what was unsaved is kept"
                                              : "";
    tell(fmt::format("something went wrong: {}{}", why, after));
    due_ = host_.time();
  } catch (const std::exception&) {
    tell("something went wrong, and keeping what is unsaved failed, too");
    return State::kGivenUp;
  }
  return givesUp ? State::kGivenUp : State::kGoesOn;
}

WindowLoop::State WindowLoop::stepOrThrow() {
  using Seconds = std::chrono::duration<double>;
  FrameInput input;
  input.events = host_.takeEvents();
  if (input.events.empty() && host_.time() < due_) {
    host_.waitForEvents(std::min(Seconds(due_ - host_.time()), kLongest));
    return State::kGoesOn;
  }
  if (const double early = last_ + kLeastFrameSeconds - host_.time(); early > 0.0) {
    std::this_thread::sleep_for(Seconds(early));
    for (InputEvent& event : host_.takeEvents()) input.events.push_back(std::move(event));
  }
  last_ = input.time = host_.time();
  input.size = host_.size();
  input.contentScale = host_.contentScale();
  const bool visible = host_.beginDrawing();
  const FrameOutcome outcome = editor_.frame(input);
  if (visible) host_.swap();
  if (outcome.quit) return State::kQuit;
  dress(outcome);
  due_ = std::numeric_limits<double>::infinity();
  for (const std::optional<double>& wanted :
       {outcome.nextFrameIn, userFiles_.follow(editor_.session(), input.time),
        recovery_.follow(editor_.session(), input.time)}) {
    due_ = std::min(due_, input.time + wanted.value_or(due_));
  }
  failures_ = 0;
  return State::kGoesOn;
}

void WindowLoop::dress(const FrameOutcome& outcome) {
  if (outcome.title != title_) host_.setTitle(title_ = outcome.title);
  const CursorShape cursor = cursorOf(outcome.pointer);
  if (cursor != cursor_) host_.setCursor(cursor_ = cursor);
  if (outcome.fullScreen != host_.fullScreen()) host_.setFullScreen(outcome.fullScreen);
}

}  // namespace vides
