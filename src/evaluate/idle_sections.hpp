// SPDX-License-Identifier: MIT
// Sections that were meant to do something and have nothing to do: a roll of whole turns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evaluate/section.hpp"
#include "flight/flight.hpp"

namespace vides {

struct IdleSection {
  OrientationPlace from, to;
  std::int64_t turns = 0;  // whole ones, by which the roll differs; nothing else does
};

// In the film's order, at most so many. Quick in flights without rolls so far apart.
std::vector<IdleSection> idleSections(const Flight& flight, std::size_t most = 20);

}  // namespace vides
