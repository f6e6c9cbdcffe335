// SPDX-License-Identifier: MIT
// `vides frames`: a flight's frames, to a file or to standard output.
#include <unistd.h>

#include "app/commands.hpp"
#include "app/flight_input.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"
#include "app/progress.hpp"

namespace vides {

int runFrames(const FramesCommand& command) {
  const bool toScreen = command.output == "-" && isatty(STDOUT_FILENO) != 0;
  // A slip of the hand must not cost the flight.
  if (command.output != "-" && command.flight != "-" && sameFile(command.flight, command.output)) {
    tell(command.output + ": is the flight itself, and would be overwritten by its frames");
    return kWrongCommandLine;
  }
  const auto flight = readFlightOrTell(command.flight);
  if (!flight) return kFailed;
  const Evaluation evaluation(*flight);
  Output output(command.output);
  {
    Progress progress("Writing frames", toScreen);
    writeFrames(
        evaluation, command.options, [&](std::string_view piece) { return output.write(piece); },
        [&](std::int64_t done, std::int64_t all) {
          progress.report(done, all);
          return true;
        });
  }
  return output.finish() ? kExitDone : kFailed;
}

}  // namespace vides
