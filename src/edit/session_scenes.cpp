// SPDX-License-Identifier: MIT
// The scenes that a flight names: read while the window goes on, shown, hidden, sought.
#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "edit/folder.hpp"
#include "edit/scene_edits.hpp"
#include "edit/scene_texts.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;
using Result = SessionActions::Result;

SceneRow::State stateOf(const SceneReading& reading) {
  using State = SceneRow::State;
  const SceneReading::Result* const result = reading.result();
  if (result == nullptr) return State::kReading;
  if (*result) return State::kRead;
  if (result->error().fault == SceneFault::kCancelled) return State::kStopped;
  std::error_code error;
  return fs::exists(reading.file(), error) ? State::kRefused : State::kMissing;
}

}  // namespace

// --- Showing ---

void Session::followScenePaths() {
  if (sceneFiles_ == flight().scene && scenesFrom_ == path()) return;
  sceneFiles_ = flight().scene;
  scenesFrom_ = path();
  scenePaths_.clear();
  const fs::path folder = fs::path(path()).parent_path();
  for (const SceneFile& scene : sceneFiles_) {
    scenePaths_.push_back(sceneFilePath(folder, scene.file));
  }
}

std::vector<PlacedScene> Session::scenes() {
  followScenePaths();
  std::vector<fs::path> seen;
  for (std::size_t i = 0; i < sceneFiles_.size(); ++i) {
    if (sceneFiles_[i].visible) seen.push_back(scenePaths_[i]);
  }
  scenes_.scenes(seen, document_);
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
  std::vector<PlacedScene> scenes;
  for (std::size_t i = 0; i < sceneFiles_.size(); ++i) {
    if (!sceneFiles_[i].visible) continue;
    const SharedReading reading = scenes_.readingOf(scenePaths_[i]);
    const SceneReading::Result* const read = reading ? reading->result() : nullptr;
    if (read != nullptr && *read) scenes.emplace_back(**read, sceneFiles_[i].up);
  }
  return scenes;
}

std::vector<SharedReading> Session::sceneReadings() const {
  std::vector<SharedReading> readings;
  for (std::size_t i = 0; i < sceneFiles_.size(); ++i) {
    readings.push_back(sceneFiles_[i].visible ? scenes_.readingOf(scenePaths_[i]) : nullptr);
  }
  return readings;
}

std::vector<SceneRow> Session::sceneRows() const {
  using State = SceneRow::State;
  std::vector<SceneRow> rows;
  const fs::path folder = fs::path(path()).parent_path();
  for (const SceneFile& scene : flight().scene) {
    SceneRow row;
    row.file = scene.file;
    row.path = sceneFilePath(folder, scene.file);
    row.up = scene.up;
    row.visible = scene.visible;
    const SharedReading reading = scenes_.readingOf(row.path);
    if (reading) {
      row.state = stateOf(*reading);
      row.share = reading->share();
      if (row.state == State::kRead) row.drawable = **reading->result();
      if (row.failed()) row.problem = sceneProblemText(row.file, reading->result()->error());
    }
    if (!row.visible) row.state = State::kHidden;
    row.changedOnDisk = std::ranges::find(changedScenes_, row.path) != changedScenes_.end();
    rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<BoundingBox> Session::sceneBox() {
  std::optional<BoundingBox> box;
  for (const PlacedScene& scene : scenes()) {
    const BoundingBox one = scene.box();
    box = box ? BoundingBox{glm::min(box->low, one.low), glm::max(box->high, one.high)} : one;
  }
  return box;
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

Result SessionActions::cancelReading(Session& session, const Arguments&) {
  for (const Session::Import& import : session.imports_) import.reading->cancel();
  session.scenes_.cancel();
  return {};
}

// --- The files on the disk ---

void Session::rewriteHeld(const std::function<void(Flight&)>& change) {
  history_.rewrite(change);
  const auto rewrite = [&](EditState& state) {
    change(state.flight);
    state.evaluation = state.evaluation.updated(state.flight);
  };
  if (gesture_) rewrite(gesture_->start);
  if (windowOpening_) rewrite(*windowOpening_);
}

void Session::checkScenesOnDisk() {
  const std::vector<fs::path> changed = scenes_.changedOnDisk();
  std::vector<fs::path> news;
  for (const fs::path& file : changed) {
    if (std::ranges::find(changedScenes_, file) == changedScenes_.end()) news.push_back(file);
  }
  changedScenes_ = changed;
  if (news.empty()) return;
  std::error_code error;
  const std::string name = news.front().filename().string();
  const char* const one =
      fs::exists(news.front(), error) ? "output.scene-changed" : "output.scene-gone";
  say(MessageKind::kError,
      news.size() == 1 ? Text(one, {name}) : Text("output.scenes-changed", {news.size(), name}));
}

Result SessionActions::reloadScene(Session& session, const Arguments& arguments) {
  const std::size_t index = arguments.index(0);
  if (index >= session.flight().scene.size()) {
    return tl::unexpected(noSuchScene(session.flight(), index));
  }
  session.followScenePaths();
  const fs::path file = session.scenePaths_[index];
  session.scenes_.readAgain(file);
  std::erase(session.changedScenes_, file);
  session.say(MessageKind::kDone, Text("output.reading-again", {file.filename().string()}));
  session.scenes();
  return {};
}

Result SessionActions::replaceScene(Session& session, const Arguments& arguments) {
  const std::size_t index = arguments.index(0);
  if (index >= session.flight().scene.size()) {
    return tl::unexpected(noSuchScene(session.flight(), index));
  }
  session.soughtScene_ = index;
  if (!arguments.has(1)) {
    openWindow(session, "chooser-find");
    return {};
  }
  const std::string& path = arguments.text(1);
  const SharedReading reading = session.scenes_.read(sceneFile(session, path));
  const SceneReading::Result* const read = reading->result();
  if (read != nullptr && !*read) {
    session.say(MessageKind::kError, sceneProblemText(path, read->error()));
    return tl::unexpected(session.output_.text);
  }
  Flight flight = session.flight();
  flight.scene[index].file = sceneName(session, path);
  const Text step("step.replace-scene", {fileName(path)});
  const Text note("output.scene-replaced", {fileName(path)});
  if (auto done = session.apply(Edit{flight, step, session.state_.marks, note}); !done) return done;
  hideWindow(session, "chooser-find");
  offerFound(session, fs::path(path).parent_path());
  return {};
}

// Other missing files that lie in the folder where one was found.
void SessionActions::offerFound(Session& session, const fs::path& folder) {
  FoundScenes found;
  session.followScenePaths();
  std::error_code error;
  for (std::size_t i = 0; i < session.scenePaths_.size(); ++i) {
    const fs::path& missing = session.scenePaths_[i];
    if (fs::exists(missing, error)) continue;
    const fs::path there = folder / missing.filename();
    if (fs::is_regular_file(there, error)) found.emplace_back(i, there.string());
  }
  if (found.empty()) return;
  session.dialogue_ = Dialogue{
      Question{Question::Kind::kScenesFound,
               Text("question.scenes-found", {found.size(), fileName(found.front().second)}),
               {"replace", "cancel"}},
      [found](Session& s, const std::string&) { return replaceFound(s, found); },
      {}};
}

Result SessionActions::replaceFound(Session& session, const FoundScenes& found) {
  Flight flight = session.flight();
  for (const auto& [index, path] : found) {
    if (index < flight.scene.size()) flight.scene[index].file = sceneName(session, path);
  }
  return session.apply(Edit{flight, Text("step.replace-scenes", {found.size()}),
                            session.state_.marks, Text("output.scenes-found", {found.size()})});
}

}  // namespace vides
