// SPDX-License-Identifier: MIT
// What `vides [FLIGHT.vid]` does: the editor.
#pragma once

#include <optional>
#include <string>

namespace vides {

// Returns the exit status. Where there is no display (and in this version, which has no editor):
// without a flight the frames of a sample flight are written to out/, so that there is something to
// see; with one it says so and names the commands that need no display.
int openEditor(const std::optional<std::string>& flight);

}  // namespace vides
