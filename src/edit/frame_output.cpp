// SPDX-License-Identifier: MIT
// Names, endings and counts of written frames.
#include "edit/frame_output.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "edit/folder.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

std::string_view endingOf(FrameFormat format) {
  switch (format) {
    case FrameFormat::kVides:
      break;
    case FrameFormat::kCsv:
      return ".csv";
    case FrameFormat::kJson:
      return ".json";
    case FrameFormat::kChan:
      return ".chan";
  }
  return ".txt";
}

}  // namespace

std::string_view name(FrameFormat format) {
  switch (format) {
    case FrameFormat::kVides:
      break;
    case FrameFormat::kCsv:
      return "csv";
    case FrameFormat::kJson:
      return "json";
    case FrameFormat::kChan:
      return "chan";
  }
  return "vides";
}

FrameFormat frameFormat(std::string_view wanted) {
  const auto found = std::find_if(kFrameFormats.begin(), kFrameFormats.end(),
                                  [&](FrameFormat format) { return name(format) == wanted; });
  return found == kFrameFormats.end() ? FrameFormat::kVides : *found;
}

FrameSpace spaceOf(const FrameOptions& options) {
  const bool chan = options.format == FrameFormat::kChan;
  return options.space.value_or(chan ? FrameSpace::kWorld : FrameSpace::kCube);
}

std::int64_t frameCountOf(const FrameOptions& options, std::int64_t frames) {
  const std::int64_t last = std::clamp<std::int64_t>(options.last, 0, frames);
  return last - std::clamp<std::int64_t>(options.first, 0, last);
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
    return file.string() + std::string(ended ? "" : endingOf(output.options.format));
  }
  const std::string stem = flight.empty() ? untitled : flight.stem().string();
  return (folder / (stem + std::string(endingOf(output.options.format)))).string();
}

std::string withEndingOf(const std::string& file, FrameFormat format) {
  for (const FrameFormat other : kFrameFormats) {
    const std::string_view ending = endingOf(other);
    if (file.size() > ending.size() && file.ends_with(ending)) {
      return file.substr(0, file.size() - ending.size()) + std::string(endingOf(format));
    }
  }
  return file;
}

}  // namespace vides
