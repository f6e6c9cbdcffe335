// SPDX-License-Identifier: MIT
// The formats that frames are written in: what the command line, Output → Frames… and the writer
// know of each.
//
// A format is one file of src/io/ and its line in vides_source_array(… frameFormats …) of the
// CMakeLists.txt there; its words are frames/format_NAME and frames/about_NAME.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "flight/flight.hpp"

namespace vides {

class FrameText;

// What positions are written in. Directions are the same in both.
enum class FrameSpace { kCube, kWorld };

// Of which flight, and how.
struct FrameTextInput {
  const Flight& flight;
  Space space;               // maps positions: the flight's, or the identity for the cube
  std::int64_t firstNumber;  // what frame 0 is numbered as, where the format is `numbered`
};

struct FrameFormat {
  std::string_view name;                 // "csv": as commands, lists and the command line name it
  std::string_view purpose;              // a line of the command line's help
  std::string_view ending;               // of its files, with the dot
  FrameSpace space = FrameSpace::kCube;  // unless another is asked for
  bool numbered = false;                 // its frames have numbers, from any first one
  std::unique_ptr<FrameText> (*make)(const FrameTextInput&) = nullptr;
};

// All of them, in the order in which they are listed; the first one is the default. Written by the
// build.
std::span<const FrameFormat* const> frameFormats();
// The format of that name; null where there is none.
const FrameFormat* frameFormat(std::string_view name);

}  // namespace vides
