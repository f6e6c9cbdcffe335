// SPDX-License-Identifier: MIT
// What a reading tells of a scene that it could read: how much is in it, and what it left out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vides {

enum class SceneRemark : std::uint8_t {
  kUnknownLines,   // lines whose first word means nothing here
  kTooFewCorners,  // faces of fewer than 3 corners, lines of fewer than 2, points of none
  kBadVertices,    // vertices that aren't finite; nothing uses them
  kVerticesOnly,   // there is nothing else, so the vertices are drawn as points
};

struct SceneNote {
  SceneRemark remark = SceneRemark::kUnknownLines;
  std::int64_t count = 0;
  std::int64_t line = 0;  // of the first one, from 1; 0: the file as a whole
  std::string found;      // the first one's word, as shownWord() gives it; may be empty
  bool operator==(const SceneNote&) const = default;
};

struct SceneReport {
  // Of what is drawn: vertices that nothing uses aren't counted.
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
  std::int64_t lines = 0;   // polylines
  std::int64_t points = 0;  // single points; where there is nothing else, the vertices
  std::vector<SceneNote> notes;
  bool operator==(const SceneReport&) const = default;
};

}  // namespace vides
