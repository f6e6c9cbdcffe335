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
#include "panels/timeline_readout.hpp"
#include "panels/timeline_runs.hpp"

namespace vides {
namespace {

constexpr float kLowTimeline = 148.0f;
constexpr float kShortRow = 560.0f;  // a shorter first row has the legend rather than long labels
constexpr double kLeastFramesPerPixel = 1.0 / 40.0;
constexpr std::int64_t kMostMarks = std::int64_t{1} << 40;  // more than any flight has frames

// Frames to pixels and back.
struct Track {
  float left = 0.0f, right = 0.0f;
  double firstFrame = 0.0;
  double framesPerPixel = 1.0;
  std::int64_t frames = 1;
  float x(double frame) const {
    return left + static_cast<float>((frame - firstFrame) / framesPerPixel);
  }
  double frame(float px) const {
    return firstFrame + static_cast<double>(px - left) * framesPerPixel;
  }
  std::int64_t nearest(float px) const { return wholeWithin(std::round(frame(px)), 0, frames - 1); }
  bool sees(float px) const { return px >= left - 1.0f && px <= right + 1.0f; }
};

void transport(Ui& ui, const Rect& row, const Session& session, const FlightGraphs& graphs,
               TimelineView& view, Actions& actions) {
  float x = row.x;
  const auto place = [&](float width) {
    const Rect result{x, row.y, ui.px(width), row.height};
    x += ui.px(width + 4);
    return result;
  };
  const auto buttonWidth = [&](const std::string& label) {
    return std::ceil(ui.textWidth(label, Weight::kSemibold) / ui.scale()) + 18.0f;
  };
  const auto run = [&](const char* command) { actions.run(Command(command)); };
  if (ui.iconButton("timeline/first", place(32), Icon::kFirst, {.command = "first-frame"}))
    run("first-frame");
  const bool playing = session.playback().playing();
  if (ui.iconButton("timeline/play", place(32), playing ? Icon::kPause : Icon::kPlay,
                    {.on = playing, .toggle = true, .command = "play"})) {
    run("play");
  }
  if (ui.iconButton("timeline/last", place(32), Icon::kLast, {.command = "last-frame"}))
    run("last-frame");
  if (ui.button("timeline/loop", place(buttonWidth(ui.words("timeline/loop"))),
                {.on = session.playback().loop(), .toggle = true, .command = "loop"})) {
    run("loop");
  }
  if (ui.iconButton("timeline/insert", place(32), Icon::kInsert,
                    {.command = "insert-at-playhead"})) {
    run("insert-at-playhead");
  }
  const std::string fit =
      ui.words(row.width < ui.px(kShortRow) ? "timeline/fit#short" : "timeline/fit");
  if (ui.button("timeline/fit", place(buttonWidth(fit)), fit, {.enabled = !view.fit}))
    view.fit = true;
  x += ui.px(6);

  timelineReadout(ui, {x, row.y, row.right() - x, row.height}, session, graphs);
}

void ruler(Ui& ui, const Rect& row, const Track& track, double fps) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double step = rulerStep(track.framesPerPixel, fps, static_cast<double>(ui.px(72)));
  const bool inSeconds = step >= fps;
  const double span = static_cast<double>(track.frames) / fps;
  const int parts = inSeconds && std::fmod(step / fps, 5.0) != 0.0 && step / fps != 1.0 ? 2 : 5;
  const double least = step / parts;
  const std::int64_t from = wholeWithin(std::ceil(track.firstFrame / least - 1e-9), 0, kMostMarks);
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
void tellEnd(Ui& ui, const Rect& row, const Track& track, const TimelineView::EndDrag& end,
             double fps) {
  const std::string words = lengthText(ui, end.frames, fps);
  const float width = ui.textWidth(words, Weight::kSemibold) + ui.px(16);
  const float x = track.x(static_cast<double>(end.firstFrame + end.frames));
  const Rect box{std::clamp(std::round(x - width / 2), row.x, std::max(row.x, row.right() - width)),
                 row.y - ui.px(28), width, ui.px(22)};
  ui.fill(box, ColourRole::kPanel, 4.0f);
  ui.outline(box, ColourRole::kBorder, 4.0f);
  ui.text(box, words, {.weight = Weight::kSemibold, .align = Align::kCentre});
  ui.shows("timeline/duration", box, words);
}

// A section's end is dragged along: its duration, or the hold's, follows.
void dragEnd(Ui& ui, const Rect& row, const Track& track, const Session& session,
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
  const std::int64_t frames = wholeWithin(std::round(wanted), least, kMostMarks);
  if (frames != end.frames) {
    end.frames = frames;
    end.previewed = true;
    actions.during(endCommand(end, frames, fps), Phase::kPreview);
  }
  tellEnd(ui, row, track, end, fps);
  if (!state.held) finish(Phase::kCommit);
}

// What is known of the pieces that are seen, from left to right.
void forEachChunk(const Track& track, TimelineView& view,
                  const std::function<void(const TimelineCache::Chunk&)>& tell) {
  const double frames = TimelineCache::kChunkPixels * track.framesPerPixel;
  const auto number = [&](float x) {
    return wholeWithin(std::floor(track.frame(x) / frames), 0, kMostMarks);
  };
  for (std::int64_t n = number(track.left - 1.0f); n <= number(track.right + 1.0f); ++n) {
    tell(view.cache.chunk(n));
  }
}

// From left to right, never more bars than pixels: what is narrower shares a pixel.
void sections(Ui& ui, const Rect& row, const Track& track, const Session& session,
              TimelineView& view, Actions& actions) {
  // A little wider than the bars, so that the last end can be held from outside.
  const float reach = ui.px(4);
  const auto state =
      ui.area("timeline/sections", {row.x - reach, row.y, row.width + 2 * reach, row.height});
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

void marks(Ui& ui, const Rect& row, const Track& track, const Session& session, TimelineView& view,
           Actions& actions) {
  const Evaluation& evaluation = session.evaluation();
  const auto state = ui.area("timeline/marks", row);
  const float pointer = ImGui::GetIO().MousePos.x;
  std::optional<OrientationPlace> clicked;
  MarkRuns dots(ui, row.centreY());
  float best = ui.px(6);
  const auto mark = [&](const OrientationPlace& place, std::int64_t frame, bool isKey,
                        ColourRole role) {
    const float x = track.x(static_cast<double>(frame));
    if (!track.sees(x)) return;
    if (state.released && std::abs(pointer - x) < best) {
      best = std::abs(pointer - x);
      clicked = place;
    }
    const bool ringed =
        isKey && session.selected().size() > 1 && session.selected().contains(place.key);
    dots.add(x, isKey, ringed, role);
  };
  forEachChunk(track, view, [&](const TimelineCache::Chunk& chunk) {
    for (const TimelineMark& m : chunk.marks) mark(m.place, m.frame, m.key, ColourRole::kKey);
  });
  dots.end();
  // The current one is seen among however many.
  const OrientationPlace current = session.current();
  const std::int64_t frame = evaluation.frameOf(current);
  mark(current, frame, evaluation.frameOf({current.key, 0}) == frame, ColourRole::kAccent);
  dots.end();
  if (clicked) actions.run(Command("make-current", clicked->key, clicked->orientation));
}

void strip(Ui& ui, const Rect& row, const Track& track, FlightGraphs& graphs) {
  if (row.height < ui.px(8)) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double end = std::min(static_cast<double>(track.frames - 1), track.frame(track.right));
  // A sample a pixel, the mean over it, each always of the same frames while the flight is
  // scrolled; every other one where several frames share a pixel anyway.
  const float apart = track.framesPerPixel > 4.0 ? 2.0f : 1.0f;
  const double step = static_cast<double>(apart) * track.framesPerPixel;
  const std::int64_t first = wholeWithin(std::floor(track.firstFrame / step), 0, kMostMarks);
  const std::int64_t past = wholeWithin(std::ceil(end / step - 1e-6), 0, kMostMarks);
  if (past - first < 2) return;
  const SpeedStrip& speeds = graphs.strip(first, step, static_cast<int>(past - first));
  const float left = track.x(static_cast<double>(first) * step) + 0.5f * apart;
  std::vector<ImVec2> points(speeds.speed.size());
  const auto draw = [&](const std::vector<float>& values, float most, ColourRole role) {
    if (most <= 0.0f) most = 1.0f;
    for (std::size_t i = 0; i < values.size(); ++i) {
      points[i] = {left + apart * static_cast<float>(i),
                   row.bottom() - ui.px(2) - (row.height - ui.px(4)) * values[i] / most};
    }
    list.AddPolyline(points.data(), static_cast<int>(points.size()), ui.colour(role), 0,
                     1.4f * ui.scale());
  };
  draw(speeds.angularSpeed, speeds.mostAngularSpeed, ColourRole::kAim);
  draw(speeds.speed, speeds.mostSpeed, ColourRole::kCurve);
}

void playhead(Ui& ui, const Rect& ruler, float bottom, const Track& track, const Session& session,
              const TimelineView& view, Actions& actions) {
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
void navigate(Ui& ui, const Rect& rect, Track& track, TimelineView& view) {
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
  transport(ui, row, session, graphs, view, actions);
  Track track;
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
  marks(ui, markRow, track, session, view, actions);
  const Rect stripRow{track.left, markRow.bottom() + ui.px(2), width,
                      rect.bottom() - ui.px(low ? 6 : 8) - markRow.bottom() - ui.px(2)};
  strip(ui, stripRow, track, graphs);
  playhead(ui, {rulerRow.x - ui.px(8), rulerRow.y, rulerRow.width + ui.px(16), rulerRow.height},
           std::max(markRow.bottom(), stripRow.bottom()), track, session, view, actions);
}

}  // namespace vides
