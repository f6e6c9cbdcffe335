// SPDX-License-Identifier: MIT
// Scenes: importing, and reading those that a flight names, while the window goes on.
#include <algorithm>
#include <filesystem>
#include <string>

#include "edit/folder.hpp"
#include "edit/scene_texts.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

using Result = SessionActions::Result;

}  // namespace

// --- Importing ---

Result SessionActions::importScene(Session& session, const Arguments& arguments) {
  if (!arguments.has(0)) {
    openWindow(session, "chooser-import");
    return {};
  }
  const std::string& path = arguments.text(0);
  Session::Import import{session.scenes_.read(path), path};
  // One after the other: the first one into an empty flight decides its space.
  if (import.reading->ended() && session.imports_.empty()) return finishImport(session, import);
  session.imports_.push_back(std::move(import));
  hideWindow(session, "chooser-import");
  session.say(MessageKind::kDone, Text("output.reading-scene", {fileName(path)}));
  return {};
}

Result SessionActions::finishImport(Session& session, const Session::Import& import) {
  const SceneReading::Result& scene = *import.reading->result();
  if (!scene) {
    const bool cancelled = scene.error().fault == SceneFault::kCancelled;
    Text why = cancelled ? Text("output.import-cancelled", {fileName(import.path)})
                         : sceneProblemText(import.path, scene.error());
    session.say(cancelled ? MessageKind::kDone : MessageKind::kError, why);
    return tl::unexpected(std::move(why));
  }
  Flight place;
  place.scene.push_back(SceneFile{import.path, {}});
  moveScenePaths(place, "", session.path());
  Command command("add-scene", place.scene.front().file);
  command.add((*scene)->box().low);
  command.add((*scene)->box().high);
  hideWindow(session, "chooser-import");
  return session.run(command);
}

Result SessionActions::cancelReading(Session& session, const Arguments&) {
  for (const Session::Import& import : session.imports_) import.reading->cancel();
  session.scenes_.cancel();
  return {};
}

// What has been read since comes into the flight, but never during a drag or a question, which
// began with the flight as it was.
void Session::collectScenes() {
  while (!imports_.empty() && imports_.front().reading->ended() && !inDrag() && !question()) {
    const Import import = std::move(imports_.front());
    imports_.erase(imports_.begin());
    const auto done = SessionActions::finishImport(*this, import);
    if (!gesture_) endGesture();
    if (!done && output_.text != done.error()) refuse(done.error());
  }
}

// --- Showing ---

std::vector<SharedDrawable> Session::scenes() {
  if (!(sceneFiles_ == flight().scene) || scenesFrom_ != path()) {
    sceneFiles_ = flight().scene;
    scenesFrom_ = path();
    scenePaths_.clear();
    const auto folder = std::filesystem::path(path()).parent_path();
    for (const SceneFile& scene : sceneFiles_) {
      scenePaths_.push_back(sceneFilePath(folder, scene.file));
    }
  }
  std::vector<SharedDrawable> scenes = scenes_.scenes(scenePaths_, document_);
  const auto nameOf = [&](const SharedReading& reading) -> const std::string& {
    const auto place = std::ranges::find(scenePaths_, reading->file()) - scenePaths_.begin();
    return sceneFiles_[static_cast<std::size_t>(place)].file;
  };
  for (const SharedReading& reading : scenes_.takeNoted()) {
    const SceneReport& report = (**reading->result())->report();
    say(MessageKind::kDone, Text("error.scene", {nameOf(reading), sceneNotesText(report.notes)}));
  }
  for (const SharedReading& reading : scenes_.takeRefused()) {
    const std::string& name = nameOf(reading);
    const SceneProblem& problem = reading->result()->error();
    const bool cancelled = problem.fault == SceneFault::kCancelled;
    say(cancelled ? MessageKind::kDone : MessageKind::kError,
        cancelled ? Text("output.reading-cancelled", {fileName(name)})
                  : sceneProblemText(name, problem));
  }
  return scenes;
}

std::optional<Session::Reading> Session::reading() const {
  const std::vector<SharedReading> readings = scenes_.reading();
  if (readings.empty()) return std::nullopt;
  Reading result{readings.front()->file().filename().string(), readings.size(), 0.0};
  for (const SharedReading& reading : readings) {
    result.share += reading->share() / static_cast<double>(readings.size());
  }
  return result;
}

}  // namespace vides
