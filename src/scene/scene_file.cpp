// SPDX-License-Identifier: MIT
// Finds and reads scene files.
#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "scene/obj_reader.hpp"
#include "scene/scene_reader.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

// Of all the work, what fetching the bytes is taken for.
constexpr double kReadingShare = 0.1;

tl::unexpected<SceneProblem> failure(SceneFault fault, std::string found = {}) {
  return tl::unexpected(SceneProblem{fault, 0, std::move(found)});
}

tl::expected<std::string, SceneProblem> readWhole(const fs::path& file,
                                                  const KeepGoing& keepGoing) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) {
    if (!error) error = std::make_error_code(std::errc::no_such_file_or_directory);
    return failure(SceneFault::kUnreadable, error.message());
  }
  // Opening a pipe would wait for its other end, and a device has no end.
  if (!fs::is_regular_file(status)) return failure(SceneFault::kNotAFile);
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return failure(SceneFault::kUnreadable, error.message());
  if (size > kMostSceneBytes) return failure(SceneFault::kTooLarge);

  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  constexpr std::size_t kPortion = std::size_t{16} << 20;
  for (std::size_t done = 0; done < text.size(); done += kPortion) {
    const std::size_t portion = std::min(kPortion, text.size() - done);
    stream.read(text.data() + done, static_cast<std::streamsize>(portion));
    if (keepGoing && !keepGoing(kReadingShare * static_cast<double>(done + portion) /
                                static_cast<double>(text.size()))) {
      return failure(SceneFault::kCancelled);
    }
  }
  if (!stream) {
    const int reason = errno != 0 ? errno : EIO;
    return failure(SceneFault::kUnreadable, std::generic_category().message(reason));
  }
  return text;
}

std::string lowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

}  // namespace

ReadScene readSceneFile(const fs::path& file, const KeepGoing& keepGoing) {
  const std::string ending = file.extension().string();
  if (lowerCase(ending) != ".obj") return failure(SceneFault::kUnknownFormat, ending);
  KeepGoing rest;
  if (keepGoing) {
    rest = [&](double share) { return keepGoing(kReadingShare + (1.0 - kReadingShare) * share); };
  }
  return readWhole(file, keepGoing).and_then([&](const std::string& text) {
    return readObj(text, rest);
  });
}

fs::path sceneFilePath(const fs::path& flightFolder, std::string_view file) {
  return (flightFolder / fs::path(std::u8string(file.begin(), file.end()))).lexically_normal();
}

}  // namespace vides
