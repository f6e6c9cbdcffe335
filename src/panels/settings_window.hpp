// SPDX-License-Identifier: MIT
// Settings: colours per element, shown elements, theme, language, units, scale; all of it at once.
#pragma once

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"
#include "panels/window_frame.hpp"

namespace vides {

// What stays between display frames.
struct SettingsMemory {
  WindowPlace place;
  ColourRole element = ColourRole::kCurve;  // whose colour the sliders show
};

void settingsWindow(Ui& ui, const Session& session, SettingsMemory& memory, Actions& actions);

// The content scales that the window offers; 0 is the screen's.
inline constexpr double kOfferedScales[] = {0.0, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0};

}  // namespace vides
