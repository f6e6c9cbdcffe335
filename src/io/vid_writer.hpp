// SPDX-License-Identifier: MIT
// Writes a flight as a `.vid` file (3-vid-format): the same bytes for the same flight on every
// run, in every locale.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "flight/flight.hpp"
#include "flight/problem.hpp"

namespace vides {

// Takes the text piece by piece; false stops the writing.
using TextSink = std::function<bool(std::string_view)>;

// The flight must be valid (flight/validation.hpp). False if the sink stopped it.
bool writeVid(const Flight& flight, const TextSink& sink);
std::string writeVid(const Flight& flight);

// Saves whole or not at all (io/atomic_file.hpp). A flight that isn't valid is refused with its
// first problem; what the system refuses is kUnwritable. `seen` is told the text, piece by piece.
std::optional<Problem> saveVid(const Flight& flight, const std::string& path,
                               const std::function<void(std::string_view)>& seen = {});

// Text as a JSON string with its quotes: UTF-8 as it is, control characters escaped.
void appendJsonString(std::string& out, std::string_view text);
// A number as in files: the shortest that reads back to the same double; -0 as 0. Finite.
void appendJsonNumber(std::string& out, double value);

}  // namespace vides
