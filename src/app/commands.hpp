// SPDX-License-Identifier: MIT
// What the commands do, once the command line is understood. Each returns the exit status.
#pragma once

#include <string>
#include <vector>

#include "io/frame_writer.hpp"

namespace vides {

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;  // the work failed or the input is bad
inline constexpr int kWrongCommandLine = 2;

// "-" stands for standard input (flight) or output.
struct FramesCommand {
  std::string flight;
  std::string output = "-";
  FrameOptions options;
};
int runFrames(const FramesCommand& command);

struct InfoCommand {
  std::string flight;
  bool json = false;
};
int runInfo(const InfoCommand& command);

struct CheckCommand {
  std::vector<std::string> flights;
};
int runCheck(const CheckCommand& command);

}  // namespace vides
