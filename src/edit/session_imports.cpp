// SPDX-License-Identifier: MIT
// Importing scenes, and what can be done with one that has just come in.
#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

#include "edit/folder.hpp"
#include "edit/number_words.hpp"
#include "edit/scene_edits.hpp"
#include "edit/scene_texts.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;
using Result = SessionActions::Result;

// "obj", of the name's ending in any case.
std::string formatOf(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return ending.substr(std::min<std::size_t>(1, ending.size()));
}

Text joined(const Text& a, const Text& b) { return a.empty() ? b : Text("scene.joined", {a, b}); }

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) || a.lexically_normal() == b.lexically_normal();
}

}  // namespace

Text contentText(const DrawableScene& scene) {
  const SceneReport& report = scene.report();
  const struct {
    const char* key;
    std::int64_t count;
  } parts[] = {{"scene.vertices", report.vertices},
               {"scene.faces", report.faces},
               {"scene.lines", report.lines},
               {"scene.points", report.points}};
  Text text;
  for (const auto& part : parts) {
    if (part.count > 0) text = joined(text, Text(part.key, {part.count}));
  }
  return text;
}

Text extentText(const BoundingBox& box) {
  const Vec3 extent = box.high - box.low;
  return Text("scene.extent",
              {numberWords(extent.x), numberWords(extent.y), numberWords(extent.z)});
}

std::string SessionActions::sceneName(const Session& session, const std::string& path) {
  Flight place;
  place.scene.emplace_back().file = path;
  moveScenePaths(place, "", session.path());
  return place.scene.front().file;
}

fs::path SessionActions::sceneFile(const Session& session, const std::string& path) {
  return sceneFilePath(fs::path(session.path()).parent_path(), sceneName(session, path));
}

bool Session::namesScene(const fs::path& given) {
  followScenePaths();
  std::error_code error;
  const fs::path file = fs::absolute(given, error);
  return std::ranges::any_of(scenePaths_, [&](const fs::path& own) { return sameFile(own, file); });
}

Result SessionActions::importScene(Session& session, const Arguments& arguments) {
  if (!arguments.has(0)) {
    openWindow(session, "chooser-import");
    return {};
  }
  const std::string& path = arguments.text(0);
  if (arguments.has(1) && session.namesScene(path)) {
    const Command again("import-scene", path);
    session.dialogue_ = Dialogue{
        Question{Question::Kind::kSceneAgain,
                 Text("question.scene-again", {fileName(path)}),
                 {"again", "cancel"}},
        [again](Session& s, const std::string&) { return importScene(s, Arguments(again)); },
        {}};
    return {};
  }
  Session::Import import{session.scenes_.read(sceneFile(session, path)), path};
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
  const auto usual = session.importUp_.find(formatOf(import.path));
  const PlacedScene placed(*scene, usual == session.importUp_.end() ? UpAxis::kY : usual->second);
  const bool again = session.namesScene(import.path);
  const bool fits = takesFirstScene(session.flight());
  Command command("add-scene", sceneName(session, import.path));
  command.add(placed.box().low);
  command.add(placed.box().high);
  command.add(std::string(name(placed.up)));
  hideWindow(session, "chooser-import");
  if (auto done = session.run(command); !done) return done;
  session.importNote_ = ImportNote{session.flight().scene.size() - 1,
                                   fileName(import.path),
                                   contentText(**scene),
                                   extentText(placed.box()),
                                   sceneNotesText((*scene)->report().notes),
                                   fits};
  const ImportNote& note = *session.importNote_;
  Text told(again ? "output.imported-again" : "output.imported",
            {note.name, note.content, note.size, std::string(name(placed.up))});
  // What was left out comes first where there is little room.
  if (!note.notes.empty()) told = Text("output.imported-notes", {note.name, note.notes, told});
  session.say(MessageKind::kDone, std::move(told));
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

// --- Afterwards ---

Result SessionActions::setSceneUp(Session& session, const Arguments& arguments) {
  const std::size_t index = arguments.index(0);
  if (index >= session.flight().scene.size()) {
    return tl::unexpected(noSuchScene(session.flight(), index));
  }
  const UpAxis axis = *upAxis(arguments.text(1));  // checked before
  Flight flight = session.flight();
  SceneFile& scene = flight.scene[index];
  scene.up = axis;
  session.followScenePaths();
  const fs::path file = session.scenePaths_[index];
  const SharedReading reading = session.scenes_.readingOf(file);
  std::optional<ImportNote> note = session.importNote_;
  const bool offered =
      note && note->scene == index && reading && reading->result() != nullptr && *reading->result();
  if (offered) {
    const BoundingBox box = PlacedScene(**reading->result(), axis).box();
    if (note->fitted) flight.space = fittedSpace(flight.space, box, kImportShare);
    note->size = extentText(box);
  }
  const std::string axisName(name(axis));
  const Text step("step.set-scene-up", {fileName(scene.file), axisName});
  const Text told("output.scene-up", {fileName(scene.file), axisName});
  auto done = session.apply(Edit{std::move(flight), step, session.state_.marks, told});
  if (!done || !offered) return done;
  // Chosen for this file before anything else was done: that is how such files are.
  session.importNote_ = std::move(note);
  if (axis == UpAxis::kY) {
    session.importUp_.erase(formatOf(file));
  } else {
    session.importUp_[formatOf(file)] = axis;
  }
  return {};
}

Result SessionActions::fitSpace(Session& session, const Arguments& arguments) {
  const auto box = session.sceneBox();
  if (session.reading()) return tl::unexpected(Text("refusal.scene-being-read"));
  if (!box) return tl::unexpected(Text("refusal.nothing-drawn"));
  return session.apply(fitSpaceEdit(session.state_, *box, arguments.number(0)));
}

Result SessionActions::dismissImport(Session& session, const Arguments&) {
  session.importNote_.reset();
  return {};
}

}  // namespace vides
