// SPDX-License-Identifier: MIT
// Rows of the timeline that stand in files of their own.
#pragma once

#include <functional>

#include "panels/timeline_panel.hpp"
#include "panels/timeline_track.hpp"

namespace vides {

// Buttons, frame and time, legend.
void timelineTransport(Ui& ui, const Rect& row, const Session& session, const FlightGraphs& graphs,
                       TimelineView& view, Actions& actions);

// What is known of the pieces that are seen, from left to right.
void forEachChunk(const TimelineTrack& track, TimelineView& view,
                  const std::function<void(const TimelineCache::Chunk&)>& tell);

// Marks of keys and orientations, with the keys' numbers where there is room, and in the row of
// `bars` those of sections without frames. A click makes one current, a drag moves it.
void timelineMarksRow(Ui& ui, const Rect& row, const Rect& bars, const TimelineTrack& track,
                      const Session& session, TimelineView& view, Actions& actions);

// Speed and angular speed over time, and the values under the pointer.
void timelineStrip(Ui& ui, const Rect& row, const TimelineTrack& track, const Session& session,
                   FlightGraphs& graphs);

// A plate that tells what is under the pointer or dragged: above `row`, about `x`.
void timelinePlate(Ui& ui, const Rect& row, float x, const std::string& id,
                   const std::string& words);

}  // namespace vides
