// SPDX-License-Identifier: MIT
// Reads a `.vid` file (3-vid-format): a flight, or everything that is wrong with the file.
//
// Time and memory are proportional to the size of the file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "flight/flight.hpp"
#include "flight/problem.hpp"

namespace vides {

// Up to kMostProblems problems in the order of the file: a missing member where its object ends, a
// wrong count where its array begins. A newer version is the only problem told. After a syntax
// error nothing more is told.
using ReadFlight = tl::expected<Flight, std::vector<Problem>>;

ReadFlight readVid(std::string_view text);
ReadFlight readVidFile(const std::string& path);
// From an open file, standard input for example; it stays open.
ReadFlight readVidDescriptor(int descriptor);

}  // namespace vides
