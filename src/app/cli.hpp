// SPDX-License-Identifier: MIT
// The command line: which command, with which options (4-command-line). English in every locale.
#pragma once

namespace vides {

// Runs the program and returns its exit status: 0 done, 1 the work failed or the input is bad, 2
// the command line is wrong.
int runCommandLine(int argc, const char* const* argv);

}  // namespace vides
