// SPDX-License-Identifier: MIT
// Flights named on the command line.
#pragma once

#include <optional>
#include <string>

#include "io/vid_reader.hpp"

namespace vides {

// A `.vid` file; "-" is standard input.
ReadFlight readFlightArgument(const std::string& name);
// The same; what is wrong goes to standard error.
std::optional<Flight> readFlightOrTell(const std::string& name);

}  // namespace vides
