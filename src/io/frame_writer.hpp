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

#include "evaluate/evaluation.hpp"
#include "io/frame_format.hpp"
#include "io/vid_writer.hpp"

namespace vides {

// Frames first <= n < last.
struct FrameRange {
  std::int64_t first = 0;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};

struct FrameOptions {
  const FrameFormat* format = frameFormats().front();  // never null
  std::optional<FrameSpace> space;                     // absent: the format's own
  std::int64_t first = 0;  // frames first <= n < last, clipped to the flight
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
  std::int64_t firstNumber = 1;  // what frame 0 of the flight gets, where frames are numbered
};

// What positions are written in, chosen or the format's own.
FrameSpace spaceOf(const FrameOptions& options);
// Those of a flight's so many frames that the options take.
FrameRange clipped(const FrameOptions& options, std::int64_t frames);

// Told now and then how many of how many frames are done; false stops it.
using FrameProgress = std::function<bool(std::int64_t done, std::int64_t all)>;

// False if the sink or the progress stopped it.
bool writeFrames(const Evaluation& evaluation, const FrameOptions& options, const TextSink& sink,
                 const FrameProgress& progress = {});

}  // namespace vides
