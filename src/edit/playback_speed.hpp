// SPDX-License-Identifier: MIT
// How fast the flight can be played, slowest first.
#pragma once

#include <iterator>

namespace vides {

struct PlaybackSpeed {
  const char* name;   // in `playback-speed NAME`
  const char* shown;  // "\u00bd\u00d7"
  double times;       // the flight's frame rate
};
inline constexpr PlaybackSpeed kPlaybackSpeeds[] = {{"0.25", "\u00bc\u00d7", 0.25},
                                                    {"0.5", "\u00bd\u00d7", 0.5},
                                                    {"1", "1\u00d7", 1.0},
                                                    {"2", "2\u00d7", 2.0},
                                                    {"4", "4\u00d7", 4.0}};

// The place in the list, or the end of it.
inline std::size_t indexOfSpeed(double times) {
  std::size_t i = 0;
  while (i < std::size(kPlaybackSpeeds) && kPlaybackSpeeds[i].times != times) ++i;
  return i;
}

}  // namespace vides
