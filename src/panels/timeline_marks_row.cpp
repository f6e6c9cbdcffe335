// SPDX-License-Identifier: MIT
// Marks below the bars: looked at, clicked, dragged.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "panels/quantities.hpp"
#include "panels/timeline_rows.hpp"
#include "panels/timeline_runs.hpp"

namespace vides {
namespace {

constexpr const char* kId = "timeline/marks";
constexpr float kReach = 6.0f, kPreferred = 3.0f, kDragFrom = 3.0f;
constexpr float kNumberGap = 6.0f;

struct SeenMark {
  TimelineMark mark;
  float x;
};

// What is seen, from left to right.
std::vector<SeenMark> seenMarks(const TimelineTrack& track, TimelineView& view) {
  std::vector<SeenMark> seen;
  forEachChunk(track, view, [&](const TimelineCache::Chunk& chunk) {
    for (const TimelineMark& mark : chunk.marks) {
      const float x = track.x(static_cast<double>(mark.frame));
      if (track.sees(x)) seen.push_back({mark, x});
    }
  });
  return seen;
}

TimelineMark currentMark(const Session& session) {
  const Evaluation& evaluation = session.evaluation();
  const OrientationPlace current = session.current();
  const std::int64_t frame = evaluation.frameOf(current);
  return {current, frame, evaluation.frameOf({current.key, 0}) == frame};
}

// The nearest one, though the current one where it is hardly farther.
const SeenMark* markAt(const Ui& ui, const std::vector<SeenMark>& marks, float x,
                       std::int64_t currentFrame) {
  const SeenMark* best = nullptr;
  float least = ui.px(kReach);
  for (const SeenMark& seen : marks) {
    const bool current = seen.mark.frame == currentFrame;
    const float away = std::abs(seen.x - x) - (current ? ui.px(kPreferred) : 0.0f);
    if (std::abs(seen.x - x) >= ui.px(kReach) || away >= least) continue;
    least = away;
    best = &seen;
  }
  return best;
}

// Keys' numbers behind their marks, where they touch no other mark.
void numbers(Ui& ui, const Rect& row, const std::vector<SeenMark>& marks, std::size_t current) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const auto& [mark, x] = marks[i];
    if (!mark.key) continue;
    const std::string words = std::to_string(mark.place.key + 1);
    const float width = ui.textWidth(words, Weight::kSmall), gap = ui.px(kNumberGap);
    const float after = i + 1 < marks.size() ? marks[i + 1].x - gap : row.right();
    const float before = i > 0 ? marks[i - 1].x + 2 * gap : row.x;
    float left = x + gap;
    if (left + width > after) left = i + 1 < marks.size() ? after + gap : x - gap - width;
    if (left < before || left + width > std::max(after, x)) continue;
    ui.text({left, row.y, width, row.height}, words,
            {.colour = mark.place.key == current ? ColourRole::kAccent : ColourRole::kTextSecondary,
             .weight = Weight::kSmall});
  }
}

// A small diamond between the bars: here lies a section that takes no time.
void silentSign(Ui& ui, const Rect& bars, float x) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float half = std::round(4.5f * ui.scale());
  const ImVec2 at(std::round(x), std::round(bars.centreY()));
  const ImVec2 corners[] = {
      {at.x, at.y - half}, {at.x + half, at.y}, {at.x, at.y + half}, {at.x - half, at.y}};
  list.AddConvexPolyFilled(corners, 4, ui.colour(ColourRole::kField));
  list.AddPolyline(corners, 4, ui.colour(ColourRole::kText), ImDrawFlags_Closed, 1.4f * ui.scale());
}

void tellMark(Ui& ui, const Rect& row, const Session& session, const TimelineMark& mark) {
  const double fps = session.flight().frameRate;
  const std::string time =
      timeText(ui, static_cast<double>(mark.frame) / fps,
               static_cast<double>(session.evaluation().frameCount()) / fps, 2);
  const bool several = session.flight().keys[mark.place.key].orientations.size() > 1;
  const Text what =
      several ? Text("timeline.orientation", {mark.place.key + 1, mark.place.orientation + 1})
              : Text("timeline.key", {mark.place.key + 1});
  std::string words = ui.tell(Text("timeline.mark", {what, mark.frame, time}));
  if (mark.silent) words += "\n" + ui.words("timeline.silent");
  const bool moves = markNeighbours(session.evaluation(), mark.place).has_value();
  words += "\n" + ui.words(moves ? "timeline.mark-moves" : "timeline.mark-fixed");
  ui.tells("timeline/mark_" + std::to_string(mark.frame), row, words);
}

void press(Ui& ui, const TimelineTrack& track, const Session& session, const TimelineMark& mark,
           TimelineView& view, Actions& actions) {
  // What is pressed becomes current, as crosses do.
  actions.run(Command("make-current", mark.place.key, mark.place.orientation));
  const float pointer = ImGui::GetIO().MousePos.x;
  TimelineView::MarkDrag drag;
  drag.place = mark.place;
  drag.neighbours = markNeighbours(session.evaluation(), mark.place);
  drag.frame = mark.frame;
  drag.grip = static_cast<double>(mark.frame) - track.frame(pointer);
  drag.pressed = pointer;
  view.mark = drag;
  ui.memory().dragging = kId;
}

void drag(Ui& ui, const Rect& bars, const TimelineTrack& track, const Session& session, bool held,
          TimelineView& view, Actions& actions) {
  TimelineView::MarkDrag& drag = *view.mark;
  const auto command = [&] {
    return Command("move-mark", drag.place.key, drag.place.orientation, drag.by);
  };
  const auto finish = [&](Phase phase) {
    if (drag.moves && drag.neighbours) actions.sincePress(command(), phase);
    view.mark.reset();
    if (ui.memory().dragging == kId) ui.memory().dragging.clear();
  };
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    ImGui::ClearActiveID();
    return finish(Phase::kCancel);
  }
  const float pointer = ImGui::GetIO().MousePos.x;
  if (!drag.moves && std::abs(pointer - drag.pressed) >= ui.px(kDragFrom)) {
    drag.moves = true;
    if (!drag.neighbours) actions.refusal = Text("refusal.mark-fixed");
  }
  if (drag.moves && drag.neighbours) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const double wanted =
        std::round(track.frame(pointer) + drag.grip) - static_cast<double>(drag.frame);
    const std::int64_t by = wholeWithin(wanted, drag.neighbours->least(), drag.neighbours->most());
    if (by != drag.by) {
      drag.by = by;
      actions.sincePress(command(), Phase::kPreview);
    }
    const std::int64_t frame = drag.frame + drag.by;
    const double fps = session.flight().frameRate;
    const std::string words =
        ui.words("frame_title") + " " + grouped(ui, frame) + " \u00b7 " +
        timeText(ui, static_cast<double>(frame) / fps, static_cast<double>(track.frames) / fps, 2);
    timelinePlate(ui, bars, track.x(static_cast<double>(frame)), "timeline/mark", words);
  }
  if (!held) finish(drag.by == 0 ? Phase::kCancel : Phase::kCommit);
}

}  // namespace

void timelineMarksRow(Ui& ui, const Rect& row, const Rect& bars, const TimelineTrack& track,
                      const Session& session, TimelineView& view, Actions& actions) {
  const auto state = ui.area(kId, row, {}, false);
  const std::vector<SeenMark> marks = seenMarks(track, view);
  const TimelineMark current = currentMark(session);
  MarkRuns dots(ui, row.centreY());
  const auto dot = [&](const TimelineMark& mark, float x, ColourRole role) {
    const bool ringed =
        mark.key && session.selected().size() > 1 && session.selected().contains(mark.place.key);
    dots.add(x, mark.key, ringed, role);
  };
  for (const auto& [mark, x] : marks) dot(mark, x, ColourRole::kKey);
  dots.end();
  // The current one is seen among however many.
  const float at = track.x(static_cast<double>(current.frame));
  if (track.sees(at)) dot(current, at, ColourRole::kAccent);
  dots.end();
  numbers(ui, row, marks, session.current().key);
  for (const auto& [mark, x] : marks) {
    if (mark.silent) silentSign(ui, bars, x);
  }

  const SeenMark* under = state.hovered || state.pressed
                              ? markAt(ui, marks, ImGui::GetIO().MousePos.x, current.frame)
                              : nullptr;
  if (under != nullptr && !view.mark && !view.panning) {
    // Of several orientations on the frame the current one stays current.
    TimelineMark mark = under->mark;
    if (mark.frame == current.frame) mark.place = current.place;
    if (state.pressed) {
      press(ui, track, session, mark, view, actions);
    } else {
      ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
      tellMark(ui, row, session, mark);
    }
  }
  if (view.mark) drag(ui, bars, track, session, state.held, view, actions);
}

}  // namespace vides
