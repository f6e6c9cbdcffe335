// SPDX-License-Identifier: MIT
// Tells what goes wrong in the editor while a script runs.
#include "app/drive/session_echo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "edit/scene_texts.hpp"

namespace vides {

SessionEcho::SessionEcho(Player& player, std::string_view script,
                         std::function<void(const std::string&)> tell)
    : player_(player), script_(script), tell_(std::move(tell)) {
  player_.takeErrors();
  known_ = player_.editor().session().sceneReadings();
}

void SessionEcho::afterLine(std::size_t line, std::string_view failure) {
  const std::string place = fmt::format("{}:{}: ", script_, line);
  std::vector<std::string> told;
  for (const Text& text : player_.takeErrors()) {
    const std::string words = player_.editor().words(text);
    const bool known = failure.find(words) != std::string_view::npos ||
                       std::ranges::find(told, words) != told.end();
    if (words.empty() || known) continue;
    tell_(place + words);
    told.push_back(words);
  }
  tellRemarks(place);
}

namespace {

// Files of a flight that has none itself are named by their whole paths.
std::string shortPath(const std::string& file) {
  std::error_code error;
  const std::string here = std::filesystem::current_path(error).string() + "/";
  return !error && file.starts_with(here) ? file.substr(here.size()) : file;
}

}  // namespace

void SessionEcho::tellRemarks(const std::string& place) {
  const Session& session = player_.editor().session();
  const std::vector<SharedReading> readings = session.sceneReadings();
  for (std::size_t i = 0; i < std::min(readings.size(), session.flight().scene.size()); ++i) {
    const SharedReading& reading = readings[i];
    const bool isNew = std::ranges::find(known_, reading) == known_.end();
    const auto* const result = reading && isNew ? reading->result() : nullptr;
    if (result == nullptr || !*result) continue;
    for (const SceneNote& note : (**result)->report().notes) {
      tell_(fmt::format("{}{}: remark: {}", place, shortPath(session.flight().scene[i].file),
                        player_.editor().words(sceneNoteText(note))));
    }
  }
  known_ = readings;
}

}  // namespace vides
