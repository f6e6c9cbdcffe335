// SPDX-License-Identifier: MIT
// Settings, in pages: colours per element, shown elements, sizes, theme, language, units, scale.
// What is chosen takes effect at once.
#pragma once

#include <cstdint>

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"
#include "panels/window_frame.hpp"

namespace vides {

enum class SettingsPage : std::uint8_t { kColours, kShown, kSizes, kGeneral };

// What stays between display frames.
struct SettingsMemory {
  WindowPlace place;
  SettingsPage page = SettingsPage::kColours;
  ColourRole element = ColourRole::kCurve;  // whose colour the sliders show
};

void settingsWindow(Ui& ui, const Session& session, SettingsMemory& memory, Actions& actions);

// The content scales that the window offers; 0 is the screen's.
inline constexpr double kOfferedScales[] = {0.0, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0};

}  // namespace vides
