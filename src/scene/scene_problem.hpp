// SPDX-License-Identifier: MIT
// What is wrong with a scene file, whatever its format.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace vides {

enum class SceneFault : std::uint8_t {
  kUnreadable,     // `found`: the system's reason
  kNotAFile,       // a folder, a pipe, a device
  kTooLarge,       // more than kMostSceneBytes
  kUnknownFormat,  // `found`: the name's ending
  kEncoding,       // a text that isn't UTF-8 or whole UTF-16; `found`: what it is instead
  kNul,            // a NUL where a text was expected
  kCoordinates,    // another count of numbers than a vertex has; `found`: the count
  kNumber,         // a coordinate that is no number
  kBadVertex,      // one that isn't finite, and is used; `found`: the coordinate
  kIndex,          // no integer, or 0
  kNoSuchVertex,   // an index beyond the vertices
  kTooMany,        // more vertices than 32 bits count
  kNothing,        // no vertex at all; `found`, `line`: the first word that isn't known, if any
  kNothingDrawn,   // vertices, but none that could be drawn; `line`: the first one
  kCancelled,      // reading was stopped
};

struct SceneProblem {
  SceneFault fault = SceneFault::kUnreadable;
  std::int64_t line = 0;  // from 1; 0: the file as a whole
  std::string found;      // as shownWord() gives it, or the system's words
  bool operator==(const SceneProblem&) const = default;
};

// A word of a file for a message: shortened, and whatever a terminal or a screen can't hold as
// \xHH.
std::string shownWord(std::string_view word);

}  // namespace vides
