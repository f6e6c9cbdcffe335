// SPDX-License-Identifier: MIT
// The sentences for what came of reading a scene file.
#pragma once

#include <string>
#include <vector>

#include "edit/text.hpp"
#include "scene/scene_problem.hpp"
#include "scene/scene_report.hpp"

namespace vides {

// FILE: WHY, or FILE: line N: WHY.
Text sceneProblemText(const std::string& file, const SceneProblem& problem);
// What was left out, how often, and where first; without the file.
Text sceneNoteText(const SceneNote& note);
// All of them in one line; empty where there are none.
Text sceneNotesText(const std::vector<SceneNote>& notes);

}  // namespace vides
