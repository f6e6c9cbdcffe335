// SPDX-License-Identifier: MIT
// What the commands do, once the command line is understood. Each returns the exit status.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/picture_size.hpp"
#include "io/frame_writer.hpp"

namespace vides {

inline constexpr int kExitDone = 0;
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

struct ScreenshotCommand {
  std::string flight;
  std::string output;
  // Nothing: 1280x800, or, of the camera's view alone, 1280 wide in the flight's format.
  std::optional<TypedSize> size;
  double scale = 1.0;
  std::string view = "iso";           // iso, front, side, top, camera
  std::optional<std::int64_t> frame;  // of the playhead; the first
  bool wholeWindow = false;
  bool allowMissingScenes = false;
  // Whether the picture has the flight's own format unless its size is given whole.
  bool cameraAlone() const { return view == "camera" && !wholeWindow; }
  std::string offscreen = "osmesa";  // or egl
};
int runScreenshot(const ScreenshotCommand& command);

struct DriveCommand {
  std::optional<std::string> flight;  // nothing: New
  std::string script;
  int width = 1280;  // pixels
  int height = 800;
  double scale = 1.0;
  std::optional<std::string> language;  // en or de; nothing: the setup's
  std::optional<std::string> setup;     // nothing: the built-in one
  bool allowMissingScenes = false;
  bool listWidgets = false;             // instead of a script
  std::optional<std::string> operated;  // where to write what the script operated
  std::string offscreen = "osmesa";
};
int runDrive(const DriveCommand& command);

}  // namespace vides
