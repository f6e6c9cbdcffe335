// SPDX-License-Identifier: MIT
// The shape window: presets and own, tension, continuity and bias, place, aim and roll as numbers.
#pragma once

#include <array>
#include <optional>

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"
#include "panels/window_frame.hpp"

namespace vides {

// What stays between display frames.
struct ShapeWindowMemory {
  WindowPlace place;
  std::optional<Evaluation> counted;          // of which the next are
  std::array<std::size_t, kPresets> users{};  // keys that have each preset
};

// While it is open; what changes is previewed in the session's window gesture.
void shapeWindow(Ui& ui, const Session& session, ShapeWindowMemory& memory, Actions& actions);

}  // namespace vides
