// SPDX-License-Identifier: MIT
// Writes a flight's frames as text (4-command-line, "vides frames").
//
// The frames are evaluated and written one after the other, never all held. The same flight gives
// the same bytes on every run and in every locale, and a part of the frames (`first`, `last`) the
// lines that it has in the whole.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>

#include "evaluate/evaluation.hpp"
#include "io/vid_writer.hpp"

namespace vides {

enum class FrameFormat {
  kVides,  // ten numbers a line, four decimals
  kCsv,
  kJson,
  kChan,  // Nuke's .chan
};

// What positions are written in. Directions are the same in both.
enum class FrameSpace { kCube, kWorld };

struct FrameOptions {
  FrameFormat format = FrameFormat::kVides;
  std::optional<FrameSpace> space;  // absent: world for chan, cube for the others
  std::int64_t first = 0;           // frames first <= n < last, clipped to the flight
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
  std::int64_t firstNumber = 1;  // chan: the number that frame 0 of the flight gets
};

// Told now and then how many of how many frames are done; false stops it.
using FrameProgress = std::function<bool(std::int64_t done, std::int64_t all)>;

// False if the sink or the progress stopped it.
bool writeFrames(const Evaluation& evaluation, const FrameOptions& options, const TextSink& sink,
                 const FrameProgress& progress = {});

}  // namespace vides
