// SPDX-License-Identifier: MIT
// The timeline: transport, ruler, sections by kind, marks, playhead, speed and angular speed.
#pragma once

#include <optional>

#include "edit/mark_edits.hpp"
#include "edit/session.hpp"
#include "edit/timeline_marks.hpp"
#include "panels/actions.hpp"
#include "panels/flight_graphs.hpp"
#include "panels/ui.hpp"

namespace vides {

// Which part of the flight is seen; kept between display frames.
struct TimelineView {
  bool fit = true;          // all of it; the two below are then set by the panel
  double firstFrame = 0.0;  // at the left edge
  double framesPerPixel = 1.0;
  bool panning = false;
  float panFrom = 0.0f;   // pointer at the press
  double panFirst = 0.0;  // firstFrame at the press
  // A section's end that is dragged; the part that is seen stays meanwhile.
  struct EndDrag {
    bool hold = false;            // the hold before a section, else the section itself
    std::int64_t firstFrame = 0;  // of the section
    std::int64_t before = 0;      // its frames at the press …
    std::int64_t frames = 0;      // … and now
    double grip = 0.0;            // frames from the pointer to the end at the press
    bool previewed = false;
  };
  std::optional<EndDrag> end;
  // A mark that was pressed.
  struct MarkDrag {
    OrientationPlace place;
    std::optional<MarkNeighbours> neighbours;  // nothing for a fixed one
    std::int64_t frame = 0;                    // its own at the press
    std::int64_t by = 0;                       // it is moved by so many frames
    double grip = 0.0;                         // frames from the pointer to it at the press
    float pressed = 0.0f;                      // where
    bool moves = false;                        // else it may still be a click
  };
  std::optional<MarkDrag> mark;
  TimelineCache cache;
};

void timelinePanel(Ui& ui, const Rect& rect, const Session& session, FlightGraphs& graphs,
                   TimelineView& view, Actions& actions);

// Frames between two labelled marks of the ruler: 1, 2, 5 × 10^n frames or 1, 2, 5, 10, 15, 30, 60…
// seconds, at least `least` pixels apart.
double rulerStep(double framesPerPixel, double frameRate, double least);

}  // namespace vides
