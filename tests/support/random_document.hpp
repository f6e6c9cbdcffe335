// SPDX-License-Identifier: MIT
// Random valid flights that use every member of the file, with values anywhere in their ranges:
// for reading and writing. (random_flight.hpp has those for the evaluation.)
#pragma once

#include <string>

#include "flight/flight.hpp"
#include "math/random.hpp"

namespace vides::test {

// 2 to mostKeys keys; x_ members in every object that may have some.
Flight randomDocument(Random& random, int mostKeys);

// Any code points but NUL: control characters, quotes, backslashes, beyond the basic plane.
std::string randomText(Random& random, int mostCharacters);
// The text of a JSON value with any white space, at most `depth` deep.
std::string randomJson(Random& random, int depth);

// Puts one value of a valid flight out of its range (or two, where they are neighbours).
void spoil(Random& random, Flight& flight);

}  // namespace vides::test
