// SPDX-License-Identifier: MIT
// `vides check`: everything that is wrong with flights, a line each; and remarks on what is right
// but does nothing.
#include <fmt/format.h>
#include <unistd.h>

#include "app/commands.hpp"
#include "app/flight_input.hpp"
#include "app/output.hpp"
#include "app/progress.hpp"
#include "evaluate/idle_sections.hpp"
#include "io/problem_text.hpp"

namespace vides {
namespace {

// FILE: POINTER: remark: MESSAGE. Remarks change no status.
std::string remarkLine(const std::string& file, const Flight& flight, const IdleSection& idle) {
  const auto rollAt = [&](const OrientationPlace& place) {
    return flight.keys[place.key].orientations[place.orientation].roll;
  };
  const Orientation& from = flight.keys[idle.from.key].orientations[idle.from.orientation];
  const std::string turns =
      idle.turns == 1 ? std::string("a whole turn") : fmt::format("{} whole turns", idle.turns);
  return fmt::format(
      "{}: /keys/{}/orientations/{}/roll: remark: {} is {} from {} at /keys/{}/orientations/{}, "
      "and nothing else differs: the section between {}\n",
      file, idle.to.key, idle.to.orientation, rollAt(idle.to), turns, rollAt(idle.from),
      idle.from.key, idle.from.orientation,
      from.duration ? "has nothing to do and is a hold" : "has nothing to do and no frames");
}

}  // namespace

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
      if (flight) {
        for (const IdleSection& idle : idleSections(*flight)) {
          output.write(remarkLine(name, *flight, idle));
        }
        continue;
      }
      good = false;
      for (const Problem& problem : flight.error()) {
        output.write(problemLine(name, problem) + "\n");
      }
    }
  }
  return output.finish() && good ? kExitDone : kFailed;
}

}  // namespace vides
