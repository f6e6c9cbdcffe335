// SPDX-License-Identifier: MIT
// Reading from a file or from standard input.
#include "app/flight_input.hpp"

#include <unistd.h>

#include <cstdio>

#include "app/messages.hpp"
#include "io/problem_text.hpp"

namespace vides {

ReadFlight readFlightArgument(const std::string& name) {
  return name == "-" ? readVidDescriptor(STDIN_FILENO) : readVidFile(name);
}

std::optional<Flight> readFlightOrTell(const std::string& name) {
  ReadFlight flight = readFlightArgument(name);
  if (flight) return std::move(*flight);
  for (const Problem& problem : flight.error()) tell(problemLine(name, problem));
  return std::nullopt;
}

}  // namespace vides
