// SPDX-License-Identifier: MIT
// Scenes: importing, and reading those that a flight names, while the window goes on.
#include <algorithm>
#include <filesystem>
#include <string>

#include "edit/folder.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

using Result = SessionActions::Result;

// The sentence for what is wrong with a scene.
Text problemText(const std::string& file, const SceneProblem& problem) {
  const Text what = [&]() -> Text {
    switch (problem.fault) {
      case SceneFault::kUnreadable:
        return Text("scene.unreadable", {problem.found});
      case SceneFault::kNotAFile:
        return "scene.no-file";
      case SceneFault::kTooLarge:
        return Text("scene.too-large", {static_cast<std::int64_t>(kMostSceneBytes)});
      case SceneFault::kUnknownFormat:
        return Text("scene.unknown-format", {problem.found});
      case SceneFault::kNumber:
        return Text("scene.number", {problem.found});
      case SceneFault::kIndex:
        return Text("scene.index", {problem.found});
      case SceneFault::kNoSuchVertex:
        return Text("scene.no-such-vertex", {problem.found});
      case SceneFault::kTooFew:
        return Text("scene.too-few", {problem.found});
      case SceneFault::kTooMany:
        return "scene.too-many";
      case SceneFault::kNothing:
        return "scene.nothing";
      case SceneFault::kCancelled:
        break;
    }
    return "scene.cancelled";
  }();
  if (problem.line == 0) return Text("error.scene", {file, what});
  return Text("error.scene-line", {file, problem.line, what});
}

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
                         : problemText(import.path, scene.error());
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
  for (const SharedReading& reading : scenes_.takeRefused()) {
    const auto place = std::ranges::find(scenePaths_, reading->file()) - scenePaths_.begin();
    const std::string& name = sceneFiles_[static_cast<std::size_t>(place)].file;
    const SceneProblem& problem = reading->result()->error();
    const bool cancelled = problem.fault == SceneFault::kCancelled;
    say(cancelled ? MessageKind::kDone : MessageKind::kError,
        cancelled ? Text("output.reading-cancelled", {fileName(name)})
                  : problemText(name, problem));
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
