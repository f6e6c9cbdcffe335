// SPDX-License-Identifier: MIT
// Reading scene files of any format, chosen by the ending of the name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>
#include <tl/expected.hpp>

#include "scene/scene_geometry.hpp"
#include "scene/scene_problem.hpp"

namespace vides {

inline constexpr std::uintmax_t kMostSceneBytes = std::uintmax_t{1} << 30;

// Never a part of a scene: what can't be read whole is a problem, what is left out because it
// changes nothing is told in the report.
using ReadScene = tl::expected<SceneGeometry, SceneProblem>;

// Told the share that is done, 0 to 1; false: stop, which gives kCancelled.
using KeepGoing = std::function<bool(double share)>;

// So far ".obj", in any case.
ReadScene readSceneFile(const std::filesystem::path& file, const KeepGoing& keepGoing = {});

// Where a scene file that a flight names is: `file` (UTF-8, "/" between folders) relative to the
// flight's folder. The flight is the user's own document and may name a scene anywhere; what a
// scene names in its turn is never opened.
std::filesystem::path sceneFilePath(const std::filesystem::path& flightFolder,
                                    std::string_view file);

}  // namespace vides
