// SPDX-License-Identifier: MIT
// `vides check`: everything that is wrong with flights, a line each.
#include <unistd.h>

#include "app/commands.hpp"
#include "app/flight_input.hpp"
#include "app/output.hpp"
#include "app/progress.hpp"
#include "io/problem_text.hpp"

namespace vides {

int runCheck(const CheckCommand& command) {
  Output output;
  bool good = true;
  {
    Progress progress("Checking flights", isatty(STDOUT_FILENO) != 0);
    const auto all = static_cast<std::int64_t>(command.flights.size());
    std::int64_t done = 0;
    for (const std::string& name : command.flights) {
      progress.report(done++, all);
      const ReadFlight flight = readFlightArgument(name);
      if (flight) continue;
      good = false;
      for (const Problem& problem : flight.error()) {
        output.write(problemLine(name, problem) + "\n");
      }
    }
  }
  return output.finish() && good ? kExitDone : kFailed;
}

}  // namespace vides
