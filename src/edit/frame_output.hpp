// SPDX-License-Identifier: MIT
// What Output → Frames… is set to: which frames, how, and into which file.
#pragma once

#include <cstdint>
#include <string>

#include "io/frame_writer.hpp"

namespace vides {

struct FrameOutput {
  FrameOptions options;
  std::string file;  // as chosen or typed; empty: beside the flight, with its name
};

// How many of a flight's frames these options take.
std::int64_t frameCountOf(const FrameOptions& options, std::int64_t frames);
// Whether they take all of them.
bool takesAll(const FrameOptions& options, std::int64_t frames);

// The file for a flight's frames: the one that was chosen, its name in the flight's folder; else
// the flight's own name (or `untitled`). Without an ending, and where no such file exists, it gets
// the format's.
std::string frameFile(const FrameOutput& output, const std::string& flightPath,
                      const std::string& untitled);
// The same name for another format: its ending, where it is one of a format, changes.
std::string withEndingOf(const std::string& file, const FrameFormat& format);

}  // namespace vides
