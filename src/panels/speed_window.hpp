// SPDX-License-Identifier: MIT
// The large speed window: ten handles, ease presets, duration; the way and the acceleration below.
#pragma once

#include <optional>

#include "edit/session.hpp"
#include "edit/speed_graph.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"
#include "panels/window_frame.hpp"

namespace vides {

// What stays between display frames.
struct SpeedWindowMemory {
  WindowPlace place;
  // The graph that is shown, and of what.
  std::optional<Evaluation> evaluation;
  OrientationPlace of;
  std::optional<SpeedGraph> graph;
  // What the pointer does in it.
  enum class Doing { kNothing, kHandle, kSweep } doing = Doing::kNothing;
  std::size_t handle = 0;
  float grip = 0.0f;  // pixels from the pointer to the handle at the press
  SpeedValues start{}, values{};
  bool previewed = false;
  double lastTau = 0.0, lastSpeed = 0.0;
};

void speedWindow(Ui& ui, const Session& session, SpeedWindowMemory& memory, Actions& actions);

// The part with the curve and its handles: twelve columns, the neighbours' ends in the outer ones.
// Where `per` is not 0, the speeds themselves stand at its right, in `per` of the graph's unit.
void speedCurveArea(Ui& ui, const Rect& rect, double per, const Session& session,
                    SpeedWindowMemory& memory, Actions& actions);
// The middle of a column, 0 to 11, within the width of such an area.
float speedColumn(const Rect& rect, int column);

}  // namespace vides
