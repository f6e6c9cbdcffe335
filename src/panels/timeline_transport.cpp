// SPDX-License-Identifier: MIT
// The timeline's first row: buttons, then frame, time and legend.
#include <cmath>

#include "edit/playback_speed.hpp"
#include "panels/left_panels.hpp"
#include "panels/timeline_readout.hpp"
#include "panels/timeline_rows.hpp"

namespace vides {
namespace {

constexpr float kShortRow = 700.0f;  // a shorter row has the legend rather than long labels
constexpr float kIcon = 28.0f, kGap = 4.0f, kGroupGap = 8.0f;

// Buttons from left to right.
class ButtonRow {
 public:
  ButtonRow(Ui& ui, const Rect& row, const Session& session, Actions& actions)
      : ui_(ui), row_(row), session_(session), actions_(actions), x_(row.x) {}
  float x() const { return x_; }
  void gap(float atScale1) { x_ += ui_.px(atScale1); }
  Rect place(float atScale1) {
    const Rect result{x_, row_.y, ui_.px(atScale1), row_.height};
    x_ += result.width + ui_.px(kGap);
    return result;
  }
  Rect placeFor(const std::string& label) {
    return place(std::ceil(ui_.textWidth(label, Weight::kSemibold) / ui_.scale()) + 16.0f);
  }
  void icon(const char* id, Icon icon, const char* command, ButtonStyle style = {}) {
    style.command = command;
    style.enabled = style.enabled && session_.available(command);
    if (ui_.iconButton(id, place(kIcon), icon, style)) actions_.run(*parseCommand(command));
  }
  void button(const char* id, const char* command, ButtonStyle style = {}) {
    commandButton(ui_, id, placeFor(ui_.words(id)), command, session_, actions_, std::move(style));
  }

 private:
  Ui& ui_;
  Rect row_;
  const Session& session_;
  Actions& actions_;
  float x_;
};

// Slower, how fast it is, faster.
void speedButtons(Ui& ui, ButtonRow& buttons, const Session& session, Actions& actions) {
  const std::size_t now = indexOfSpeed(session.playback().speed());
  const auto step = [&](const char* id, Icon icon, std::size_t to) {
    const bool there = to < std::size(kPlaybackSpeeds);
    if (ui.iconButton(id, buttons.place(20), icon, {.enabled = there}))
      actions.run(Command("playback-speed", kPlaybackSpeeds[to].name));
  };
  step("timeline/slower", Icon::kChevronLeft, now - 1);
  buttons.gap(-kGap);
  const Rect value = buttons.place(28);
  const std::string words = kPlaybackSpeeds[now].shown;
  ui.text(value, words, {.align = Align::kCentre});
  ui.shows("timeline/playback_speed", value, words);
  buttons.gap(-kGap);
  step("timeline/faster", Icon::kChevronRight, now + 1);
}

}  // namespace

void timelineTransport(Ui& ui, const Rect& row, const Session& session, const FlightGraphs& graphs,
                       TimelineView& view, Actions& actions) {
  ButtonRow buttons(ui, row, session, actions);
  const Playback& playback = session.playback();
  const bool playing = playback.playing();
  buttons.icon("timeline/first", Icon::kFirst, "first-frame");
  buttons.icon("timeline/play", playing ? Icon::kPause : Icon::kPlay, "play",
               {.on = playing, .toggle = true});
  buttons.icon("timeline/last", Icon::kLast, "last-frame");
  buttons.button("timeline/loop", "loop", {.on = playback.loop(), .toggle = true});
  speedButtons(ui, buttons, session, actions);
  buttons.gap(kGroupGap - kGap);
  buttons.button("timeline/in", "set-in", {.on = playback.in().has_value()});
  buttons.button("timeline/out", "set-out", {.on = playback.out().has_value()});
  if (playback.in() || playback.out())
    buttons.icon("timeline/clear_range", Icon::kClose, "clear-range");
  buttons.gap(kGroupGap - kGap);
  const std::string fit =
      ui.words(row.width < ui.px(kShortRow) ? "timeline/fit#short" : "timeline/fit");
  if (ui.button("timeline/fit", buttons.placeFor(fit), fit, {.enabled = !view.fit}))
    view.fit = true;
  buttons.gap(kGroupGap);
  timelineReadout(ui, {buttons.x(), row.y, row.right() - buttons.x(), row.height}, session, graphs,
                  actions);
}

}  // namespace vides
