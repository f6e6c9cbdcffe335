// SPDX-License-Identifier: MIT
// What `vides [FLIGHT.vid]` does: the editor.
#pragma once

#include <optional>
#include <string>

namespace vides {

// Opens the window and returns the exit status when it has closed. Without a display it says so and
// names the commands that need none; where there is no flight either, and VIDES_WITHOUT_DISPLAY is
// "sample" (`./dev run`), the frames of a sample flight are written to out/ instead, so that there
// is something to see.
int openEditor(const std::optional<std::string>& flight);

}  // namespace vides
