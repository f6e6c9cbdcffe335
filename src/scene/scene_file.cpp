// SPDX-License-Identifier: MIT
// Finds and reads scene files, and says in words what is wrong with one.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "scene/obj_reader.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

tl::unexpected<SceneProblem> failure(SceneFault fault, std::string found = {}) {
  return tl::unexpected(SceneProblem{fault, 0, std::move(found)});
}

tl::expected<std::string, SceneProblem> readWhole(const fs::path& file) {
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
  stream.read(text.data(), static_cast<std::streamsize>(size));
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

std::string problemText(const SceneProblem& problem) {
  switch (problem.fault) {
    case SceneFault::kUnreadable:
      return problem.found;
    case SceneFault::kNotAFile:
      return "not a regular file";
    case SceneFault::kTooLarge:
      return fmt::format("larger than {} bytes", kMostSceneBytes);
    case SceneFault::kUnknownFormat:
      return fmt::format("scenes are read from .obj files, not from \"{}\"", problem.found);
    case SceneFault::kNumber:
      return fmt::format("expected three finite numbers after v, found \"{}\"", problem.found);
    case SceneFault::kIndex:
      return fmt::format("expected a vertex's number, from 1 or negative, found \"{}\"",
                         problem.found);
    case SceneFault::kNoSuchVertex:
      return fmt::format("there is no vertex \"{}\" before this line", problem.found);
    case SceneFault::kTooFew:
      return fmt::format("expected more vertices, found {}", problem.found);
    case SceneFault::kTooMany:
      return "too many vertices";
    case SceneFault::kNothing:
      return "no vertices in it";
  }
  return {};
}

}  // namespace

std::string problemLine(std::string_view file, const SceneProblem& problem) {
  if (problem.line == 0) return fmt::format("{}: {}", file, problemText(problem));
  return fmt::format("{}:{}: {}", file, problem.line, problemText(problem));
}

ReadScene readSceneFile(const fs::path& file) {
  const std::string ending = file.extension().string();
  if (lowerCase(ending) != ".obj") return failure(SceneFault::kUnknownFormat, ending);
  return readWhole(file).and_then([](const std::string& text) { return readObj(text); });
}

fs::path sceneFilePath(const fs::path& flightFolder, std::string_view file) {
  return (flightFolder / fs::path(std::u8string(file.begin(), file.end()))).lexically_normal();
}

}  // namespace vides
