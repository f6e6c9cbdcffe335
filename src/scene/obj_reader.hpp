// SPDX-License-Identifier: MIT
// Reads the geometry of a Wavefront OBJ file: vertices, faces, lines and points.
//
// Everything else (normals, materials, groups, smoothing, free-form curves) is passed over; no
// other file is ever opened, whatever mtllib or call may name. Every statement that counts is
// checked: a damaged file gives the place of its first fault, never a part of a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "scene/scene_geometry.hpp"

namespace vides {

enum class SceneFault : std::uint8_t {
  kUnreadable,     // `found`: the system's reason
  kNotAFile,       // a folder, a pipe, a device
  kTooLarge,       // more than kMostSceneBytes
  kUnknownFormat,  // `found`: the name's ending
  kNumber,         // a coordinate that is missing, no number, or not finite
  kIndex,          // no integer, or 0
  kNoSuchVertex,   // an index beyond the vertices before it
  kTooFew,         // a face of fewer than 3 vertices, a line of fewer than 2, points of none
  kTooMany,        // more vertices than 32 bits count
  kNothing,        // no vertex at all
  kCancelled,      // reading was stopped
};

struct SceneProblem {
  SceneFault fault = SceneFault::kUnreadable;
  std::int64_t line = 0;  // from 1; 0: the file as a whole
  std::string found;      // shortened, control characters replaced
  bool operator==(const SceneProblem&) const = default;
};

inline constexpr std::uintmax_t kMostSceneBytes = std::uintmax_t{1} << 30;

using ReadScene = tl::expected<SceneGeometry, SceneProblem>;

// Told the share that is done, 0 to 1; false: stop, which gives kCancelled.
using KeepGoing = std::function<bool(double share)>;

ReadScene readObj(std::string_view text, const KeepGoing& keepGoing = {});
// By the ending of its name; so far ".obj", in any case.
ReadScene readSceneFile(const std::filesystem::path& file, const KeepGoing& keepGoing = {});

// Where a scene file that a flight names is: `file` (UTF-8, "/" between folders) relative to the
// flight's folder. The flight is the user's own document and may name a scene anywhere; what a
// scene names in its turn is never opened.
std::filesystem::path sceneFilePath(const std::filesystem::path& flightFolder,
                                    std::string_view file);

}  // namespace vides
