// SPDX-License-Identifier: MIT
// Speed and angular speed under the bars.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "panels/quantities.hpp"
#include "panels/timeline_rows.hpp"

namespace vides {
namespace {

void curves(Ui& ui, const Rect& row, const TimelineTrack& track, FlightGraphs& graphs) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double end = std::min(static_cast<double>(track.frames - 1), track.frame(track.right));
  // A sample a pixel, the mean over it, each always of the same frames while the flight is
  // scrolled; every other one where several frames share a pixel anyway.
  const float apart = track.framesPerPixel > 4.0 ? 2.0f : 1.0f;
  const double step = static_cast<double>(apart) * track.framesPerPixel;
  const std::int64_t first = wholeWithin(std::floor(track.firstFrame / step), 0, kMostFrames);
  const std::int64_t past = wholeWithin(std::ceil(end / step - 1e-6), 0, kMostFrames);
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

// A line at the frame under the pointer and, on a plate above the strip, what the camera does
// there.
void underPointer(Ui& ui, const Rect& row, const TimelineTrack& track, const Session& session,
                  const FlightGraphs& graphs) {
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const bool dragging = ImGui::IsMouseDown(0) || ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2);
  if (dragging || !ImGui::IsWindowHovered() || !row.contains(pointer.x, pointer.y)) return;
  const std::int64_t frame = track.nearest(pointer.x);
  const FlightGraphs::Rates rates = graphs.ratesAt(frame);
  const LengthUnit unit = lengthUnit(ui, session);
  const float x = std::round(track.x(static_cast<double>(frame)));
  ui.fill({x, row.y, std::max(1.0f, ui.px(1)), row.height}, ColourRole::kTextSecondary);
  const std::string words =
      fmt::format("{} {} \u00b7 {} \u00b7 {}", ui.words("frame_title"), grouped(ui, frame),
                  withUnit(measured(ui, rates.speed * unit.perCube), unit.brief + "/s"),
                  withUnit(ui.number(rates.turn, 1), "\u00b0/s"));
  timelinePlate(ui, row, x, "timeline/under_pointer", words);
}

}  // namespace

void timelineStrip(Ui& ui, const Rect& row, const TimelineTrack& track, const Session& session,
                   FlightGraphs& graphs) {
  if (row.height < ui.px(8)) return;
  curves(ui, row, track, graphs);
  underPointer(ui, row, track, session, graphs);
}

}  // namespace vides
