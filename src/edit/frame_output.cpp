// SPDX-License-Identifier: MIT
// Names, endings and counts of written frames.
#include "edit/frame_output.hpp"

#include <filesystem>
#include <system_error>

#include "edit/folder.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::int64_t frameCountOf(const FrameOptions& options, std::int64_t frames) {
  const FrameRange range = clipped(options, frames);
  return range.last - range.first;
}

bool takesAll(const FrameOptions& options, std::int64_t frames) {
  return options.first <= 0 && options.last >= frames;
}

std::string frameFile(const FrameOutput& output, const std::string& flightPath,
                      const std::string& untitled) {
  std::error_code error;
  const fs::path flight = flightPath.empty() ? fs::path() : fs::absolute(flightPath, error);
  const fs::path folder = flight.empty() ? fs::current_path(error) : flight.parent_path();
  if (!output.file.empty()) {
    const fs::path file = typedPath(folder, output.file);
    const bool ended = file.has_extension() || fs::exists(fs::symlink_status(file, error));
    return file.string().append(ended ? "" : output.options.format->ending);
  }
  const std::string stem = flight.empty() ? untitled : flight.stem().string();
  return (folder / stem).string().append(output.options.format->ending);
}

std::string withEndingOf(const std::string& file, const FrameFormat& format) {
  for (const FrameFormat* other : frameFormats()) {
    const std::string_view ending = other->ending;
    if (file.size() > ending.size() && file.ends_with(ending)) {
      return file.substr(0, file.size() - ending.size()).append(format.ending);
    }
  }
  return file;
}

}  // namespace vides
