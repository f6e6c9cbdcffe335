// SPDX-License-Identifier: MIT
// The timeline: where everything in it stands, and what the pointer does there.
#include "panels/timeline_panel.hpp"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "edit/timeline_marks.hpp"
#include "math/whole.hpp"
#include "panels/left_panels.hpp"
#include "panels/quantities.hpp"
#include "panels/timeline_rows.hpp"
#include "panels/timeline_runs.hpp"

namespace vides {
namespace {

constexpr float kLowTimeline = 148.0f;
constexpr double kLeastFramesPerPixel = 1.0 / 40.0;

void ruler(Ui& ui, const Rect& row, const TimelineTrack& track, double fps) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double step = rulerStep(track.framesPerPixel, fps, static_cast<double>(ui.px(72)));
  const bool inSeconds = step >= fps;
  const double span = static_cast<double>(track.frames) / fps;
  const int parts = inSeconds && std::fmod(step / fps, 5.0) != 0.0 && step / fps != 1.0 ? 2 : 5;
  const double least = step / parts;
  const std::int64_t from = wholeWithin(std::ceil(track.firstFrame / least - 1e-9), 0, kMostFrames);
  const double end = std::min(static_cast<double>(track.frames - 1), track.frame(track.right));
  for (std::int64_t i = std::max<std::int64_t>(0, from);
       static_cast<double>(i) * least <= end + 1e-9; ++i) {
    const double frame = static_cast<double>(i) * least;
    const float x = std::round(track.x(frame)) + 0.5f;
    const bool strong = i % parts == 0;
    list.AddLine({x, row.bottom() - ui.px(strong ? 10 : 5)}, {x, row.bottom()},
                 ui.colour(strong ? ColourRole::kCube : ColourRole::kBorder), 1.0f);
    if (!strong) continue;
    const std::string words = inSeconds
                                  ? timeText(ui, std::round(frame / fps), span, 0)
                                  : grouped(ui, static_cast<std::int64_t>(std::llround(frame)));
    const float width = ui.textWidth(words, Weight::kSmall);
    if (x + ui.px(4) + width > row.right()) continue;
    ui.text({x + ui.px(4), row.y, width, row.height - ui.px(8)}, words,
            {.colour = ColourRole::kTextSecondary, .weight = Weight::kSmall});
  }
}

std::string kindWord(const Ui& ui, SectionKind kind) {
  return ui.words("kind/" + std::string(name(kind)));
}

Command endCommand(const TimelineView::EndDrag& end, std::int64_t frames, double fps) {
  if (end.hold) return Command("set-hold", static_cast<double>(frames) / fps);
  return Command("set-duration-frames", frames);
}

// The value above the end that is dragged.
void tellEnd(Ui& ui, const Rect& row, const TimelineTrack& track, const TimelineView::EndDrag& end,
             double fps) {
  const std::string words = lengthText(ui, end.frames, fps);
  const float x = track.x(static_cast<double>(end.firstFrame + end.frames));
  timelinePlate(ui, row, x, "timeline/duration", words);
}

// A section's end is dragged along: its duration, or the hold's, follows.
void dragEnd(Ui& ui, const Rect& row, const TimelineTrack& track, const Session& session,
             const Ui::AreaState& state, TimelineView& view, Actions& actions) {
  constexpr const char* kId = "timeline/sections";
  const double fps = session.flight().frameRate;
  const float pointer = ImGui::GetIO().MousePos.x;
  const TimelineRange range{track.firstFrame, track.framesPerPixel, static_cast<double>(row.width)};
  if (!view.end && (state.hovered || state.pressed) && !view.panning) {
    const auto section =
        sectionEndAt(session.evaluation(), range, static_cast<double>(pointer - row.x),
                     static_cast<double>(ui.px(4)));
    if (!section) return;
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (!state.pressed) return;
    // An edit of the current section, as all are.
    if (session.current() != section->from) {
      actions.run(Command("make-current", section->from.key, section->from.orientation));
    }
    const double end = static_cast<double>(section->firstFrame + section->frames);
    view.end = TimelineView::EndDrag{section->from == section->to,
                                     section->firstFrame,
                                     section->frames,
                                     section->frames,
                                     end - track.frame(pointer),
                                     false};
    ui.memory().dragging = kId;
  }
  if (!view.end) return;
  TimelineView::EndDrag& end = *view.end;
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  const auto finish = [&](Phase phase) {
    const std::int64_t frames = phase == Phase::kCancel ? end.before : end.frames;
    if (end.previewed) actions.during(endCommand(end, frames, fps), phase);
    view.end.reset();
    if (ui.memory().dragging == kId) ui.memory().dragging.clear();
  };
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    ImGui::ClearActiveID();
    return finish(Phase::kCancel);
  }
  const auto least = static_cast<std::int64_t>(end.hold ? 0 : 1);
  const double wanted = track.frame(pointer) + end.grip - static_cast<double>(end.firstFrame);
  const std::int64_t frames = wholeWithin(std::round(wanted), least, kMostFrames);
  if (frames != end.frames) {
    end.frames = frames;
    end.previewed = true;
    actions.during(endCommand(end, frames, fps), Phase::kPreview);
  }
  tellEnd(ui, row, track, end, fps);
  if (!state.held) finish(Phase::kCommit);
}

// In the tooltip: what it is, from where to where, how long, and why so.
void tellSection(Ui& ui, const Rect& bar, const Session& session, const Section& section) {
  const double fps = session.flight().frameRate;
  const double seconds = static_cast<double>(section.frames) / fps;
  const auto place = [&](const OrientationPlace& at) {
    const bool several = session.flight().keys[at.key].orientations.size() > 1;
    return several ? Text("timeline.orientation", {at.key + 1, at.orientation + 1})
                   : Text("timeline.key", {at.key + 1});
  };
  const bool hold = section.from == section.to;
  const Orientation& o =
      session.flight().keys[section.from.key].orientations[section.from.orientation];
  const Text length("timeline.length", {section.frames, ui.number(seconds, 2)});
  std::string words = kindWord(ui, section.kind) + " \u00b7 ";
  words += ui.tell(hold ? place(section.from)
                        : Text("timeline.from-to", {place(section.from), place(section.to)}));
  words += " \u00b7 " + ui.tell(length);
  if (!hold) words += " \u00b7 " + ui.words(o.duration ? "timeline.timed" : "timeline.by-rate");
  ui.tells("timeline/section_" + std::to_string(section.index), bar, words);
}

// From left to right, never more bars than pixels: what is narrower shares a pixel.
void sections(Ui& ui, const Rect& row, const TimelineTrack& track, const Session& session,
              TimelineView& view, Actions& actions) {
  // A little wider than the bars, so that the last end can be held from outside.
  const float reach = ui.px(4);
  const auto state = ui.area("timeline/sections",
                             {row.x - reach, row.y, row.width + 2 * reach, row.height}, {}, false);
  const bool dragged = view.end.has_value();
  dragEnd(ui, row, track, session, state, view, actions);
  const float pointer = ImGui::GetIO().MousePos.x;
  std::optional<Rect> currentBar;
  BarRuns bars(ui);
  std::int64_t before = -1;
  const auto draw = [&](const Section& section) {
    const double end = static_cast<double>(section.firstFrame + section.frames);
    const float left = std::max(track.left, track.x(static_cast<double>(section.firstFrame)));
    const float whole = std::min(track.right, track.x(end));
    // What is narrower than the next is away stands for what lies between.
    const float right =
        std::min(track.right, std::max(whole, left + static_cast<float>(kLeastApart)));
    if (whole < track.left || left >= track.right) return;
    // They grow together bit by bit where they are narrow.
    const float apart = std::clamp((right - left) / ui.scale() / 4.0f - 0.75f, 0.0f, 1.0f);
    const Rect bar{left, row.y, right - left, row.height};
    const bool hovered = state.hovered && pointer >= left && pointer < right;
    bars.add(bar, section.kind, apart, hovered);
    const bool current = section.from == session.current() && section.kind != SectionKind::kHold;
    if (current) currentBar = bar;
    const std::string words = kindWord(ui, section.kind);
    if (ui.textWidth(words, Weight::kSmall) + ui.px(12) <= bar.width) {
      ui.text({bar.x + ui.px(6), bar.y, bar.width - ui.px(12), bar.height}, words,
              {.weight = Weight::kSmall});
    } else {
      kindGlyph(ui, bar, section.kind);
    }
    if (hovered && !state.held) tellSection(ui, bar, session, section);
    if (hovered && state.released && !dragged) {
      actions.run(Command("make-current", section.from.key, section.from.orientation));
    }
  };
  forEachChunk(track, view, [&](const TimelineCache::Chunk& chunk) {
    for (const Section& section : chunk.sections) {
      if (section.index > before) draw(section);
      before = std::max(before, section.index);
    }
  });
  bars.end();
  if (currentBar) ui.outline(*currentBar, ColourRole::kAccent, 2.0f, 1.6f);
}

// What is played: a band in the ruler between in and out point; the bars beside it are dim.
void playRange(Ui& ui, const Rect& ruler, const Rect& bars, const TimelineTrack& track,
               const Session& session) {
  const Playback& playback = session.playback();
  if (!playback.in() && !playback.out()) return;
  const Playback::Span span = playback.span(track.frames);
  const auto limited = [&](double frame) {
    return std::clamp(std::round(track.x(frame)), track.left, track.right);
  };
  const float from = limited(static_cast<double>(span.first));
  const float to = std::max(from + 1.0f, limited(static_cast<double>(span.last)));
  for (const auto& [left, right] : {std::pair(track.left, from), std::pair(to, track.right)}) {
    if (right > left)
      ui.fill({left, bars.y, right - left, bars.height}, ColourRole::kColumn, 0.0f, 0.6);
  }
  const float thick = ui.px(3), high = ui.px(10);
  ui.fill({from, ruler.bottom() - thick, to - from, thick}, ColourRole::kSlider);
  const float post = std::max(2.0f, ui.px(2));
  ui.fill({from, ruler.bottom() - high, post, high}, ColourRole::kSlider);
  ui.fill({to - post, ruler.bottom() - high, post, high}, ColourRole::kSlider);
  ui.shows("timeline/range", {from, ruler.y, to - from, ruler.height},
           std::to_string(span.first) + " " + std::to_string(span.last));
}

void playhead(Ui& ui, const Rect& ruler, float bottom, const TimelineTrack& track,
              const Session& session, const TimelineView& view, Actions& actions) {
  const auto state = ui.area("timeline/playhead", ruler, std::to_string(session.frame()));
  // With Ctrl held the ruler is dragged along instead.
  if (state.held && !view.panning) {
    const std::int64_t frame = track.nearest(ImGui::GetIO().MousePos.x);
    if (frame != session.frame()) actions.run(Command("go-to-frame", frame));
  }
  const float x = std::round(track.x(static_cast<double>(session.frame())));
  if (!track.sees(x)) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ui.colour(ColourRole::kPlayhead);
  // Below the ruler's numbers, which stay readable beside it.
  const float top = ruler.bottom() - ui.px(9);
  const float half = ui.px(state.hovered || state.held ? 7 : 6);
  list.AddTriangleFilled({x - half, top}, {x + half, top}, {x, top + ui.px(8)}, ink);
  const float width = std::max(1.0f, std::round(1.4f * ui.scale()));
  list.AddRectFilled({x - width / 2, top + ui.px(6)}, {x + width / 2, bottom}, ink);
}

// Wheel: finer or coarser about the pointer; middle button: along.
void navigate(Ui& ui, const Rect& rect, TimelineTrack& track, TimelineView& view) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool over = ImGui::IsWindowHovered() && rect.contains(io.MousePos.x, io.MousePos.y);
  const double all = static_cast<double>(std::max<std::int64_t>(1, track.frames - 1));
  const double width = static_cast<double>(track.right - track.left);
  const double coarsest = all / width;
  if (over && io.MouseWheel != 0.0f) {
    const double under = track.frame(io.MousePos.x);
    const double next =
        std::clamp(view.framesPerPixel * std::pow(1.25, -static_cast<double>(io.MouseWheel)),
                   std::min(kLeastFramesPerPixel, coarsest), coarsest);
    view.firstFrame = under - static_cast<double>(io.MousePos.x - track.left) * next;
    view.framesPerPixel = next;
    view.fit = next >= coarsest;
  }
  if (over && (ImGui::IsMouseClicked(2) || (io.KeyCtrl && ImGui::IsMouseClicked(0)))) {
    view.panning = true;
    view.panFrom = io.MousePos.x;
    view.panFirst = view.firstFrame;
  }
  if (!ImGui::IsMouseDown(2) && !ImGui::IsMouseDown(0)) view.panning = false;
  if (view.panning) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (view.panning && !view.fit) {
    view.firstFrame =
        view.panFirst - static_cast<double>(io.MousePos.x - view.panFrom) * view.framesPerPixel;
  }
  if (view.end) {
    // What is seen stays under the pointer while the flight becomes longer or shorter.
    track.firstFrame = view.firstFrame;
    track.framesPerPixel = view.framesPerPixel;
    return;
  }
  if (view.fit) {
    view.firstFrame = 0.0;
    view.framesPerPixel = coarsest;
  }
  view.framesPerPixel = std::min(view.framesPerPixel, coarsest);
  view.firstFrame =
      std::clamp(view.firstFrame, 0.0, std::max(0.0, all - width * view.framesPerPixel));
  track.firstFrame = view.firstFrame;
  track.framesPerPixel = view.framesPerPixel;
  static_cast<void>(ui);
}

}  // namespace

void forEachChunk(const TimelineTrack& track, TimelineView& view,
                  const std::function<void(const TimelineCache::Chunk&)>& tell) {
  const double frames = TimelineCache::kChunkPixels * track.framesPerPixel;
  const auto number = [&](float x) {
    return wholeWithin(std::floor(track.frame(x) / frames), 0, kMostFrames);
  };
  for (std::int64_t n = number(track.left - 1.0f); n <= number(track.right + 1.0f); ++n) {
    tell(view.cache.chunk(n));
  }
}

void timelinePlate(Ui& ui, const Rect& row, float x, const std::string& id,
                   const std::string& words) {
  const float width = ui.textWidth(words, Weight::kSemibold) + ui.px(16);
  const Rect box{std::clamp(std::round(x - width / 2), row.x, std::max(row.x, row.right() - width)),
                 row.y - ui.px(28), width, ui.px(22)};
  ui.fill(box, ColourRole::kPanel, 4.0f);
  ui.outline(box, ColourRole::kBorder, 4.0f);
  ui.text(box, words, {.weight = Weight::kSemibold, .align = Align::kCentre});
  ui.shows(id, box, words);
}

double rulerStep(double framesPerPixel, double frameRate, double least) {
  const double wanted = framesPerPixel * least;
  for (const double step : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    if (step < frameRate && step >= wanted) return step;
  }
  for (const double seconds :
       {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0}) {
    if (seconds * frameRate >= wanted) return seconds * frameRate;
  }
  double hours = 3600.0 * frameRate;
  while (hours < wanted) hours *= 2.0;
  return hours;
}

void timelinePanel(Ui& ui, const Rect& rect, const Session& session, FlightGraphs& graphs,
                   TimelineView& view, Actions& actions) {
  // Where it is low, the rows give what they can to the strip.
  const bool low = rect.height < ui.px(kLowTimeline);
  const Rect row{rect.x + ui.px(8), rect.y + ui.px(6), rect.width - ui.px(16), ui.px(22)};
  timelineTransport(ui, row, session, graphs, view, actions);
  TimelineTrack track;
  track.left = rect.x + ui.px(18);
  track.right = std::max(track.left + 1.0f, rect.right() - ui.px(18));
  track.frames = session.evaluation().frameCount();
  track.firstFrame = view.firstFrame;
  track.framesPerPixel = view.framesPerPixel;
  const Rect below{rect.x, row.bottom(), rect.width, rect.bottom() - row.bottom()};
  navigate(ui, below, track, view);

  const float width = track.right - track.left;
  const Rect rulerRow{track.left, row.bottom() + ui.px(low ? 2 : 4), width, ui.px(low ? 24 : 30)};
  ruler(ui, rulerRow, track, session.flight().frameRate);
  const Rect bars{track.left, rulerRow.bottom() + ui.px(2), width, ui.px(low ? 18 : 20)};
  view.cache.follow(session.evaluation(), track.framesPerPixel);
  sections(ui, bars, track, session, view, actions);
  const Rect markRow{track.left - ui.px(8), bars.bottom() + ui.px(1), width + ui.px(16), ui.px(12)};
  timelineMarksRow(ui, markRow, bars, track, session, view, actions);
  const Rect stripRow{track.left, markRow.bottom() + ui.px(2), width,
                      rect.bottom() - ui.px(low ? 6 : 8) - markRow.bottom() - ui.px(2)};
  timelineStrip(ui, stripRow, track, session, graphs);
  playRange(ui, rulerRow, bars, track, session);
  playhead(ui, {rulerRow.x - ui.px(8), rulerRow.y, rulerRow.width + ui.px(16), rulerRow.height},
           std::max(markRow.bottom(), stripRow.bottom()), track, session, view, actions);
}

}  // namespace vides
