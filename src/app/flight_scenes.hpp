// SPDX-License-Identifier: MIT
// The scenes of a flight that was named on the command line.
#pragma once

#include <string>

#include "app/editor.hpp"

namespace vides {

// Reads the scenes of the flight that the editor shows, whose name on the command line is `flight`,
// and says on standard error what came of them: `FLIGHT: /scene/N/file: WHY` for each that is
// missing or refused, `FLIGHT: /scene/N/file: remark: TEXT` for what was left out of one. In
// English. False where one is missing or refused.
bool tellScenes(Editor& editor, const std::string& flight);

}  // namespace vides
