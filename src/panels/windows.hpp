// SPDX-License-Identifier: MIT
// Windows over the editor: the question that must be answered, how many keys, the shortcuts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "edit/session.hpp"
#include "edit/texts.hpp"
#include "panels/actions.hpp"
#include "panels/chooser.hpp"
#include "panels/settings_window.hpp"
#include "panels/shape_window.hpp"
#include "panels/speed_window.hpp"
#include "panels/ui.hpp"
#include "panels/window_frame.hpp"

namespace vides {

// Windows of the session that there are panels for; what opens another one is greyed.
bool hasWindow(std::string_view name);
// Whether a command's line can do something: it exists, it is available, its window exists.
bool canRun(const Session& session, std::string_view commandLine);

// What windows keep between display frames.
struct WindowsMemory {
  ChooserMemory chooser;
  ShapeWindowMemory shape;
  SettingsMemory settings;
  WindowPlace flight, frames, scene;
  SpeedWindowMemory speed;
  std::vector<std::string> open;  // in the display frame before
};

// All that are open.
void windows(Ui& ui, const Session& session, const Texts& texts, WindowsMemory& memory,
             Actions& actions);

}  // namespace vides
