// SPDX-License-Identifier: MIT
// Puts what came of reading a scene file into sentences.
#include "edit/scene_texts.hpp"

#include <utility>

#include "scene/scene_reader.hpp"

namespace vides {
namespace {

Text faultText(const SceneProblem& problem) {
  switch (problem.fault) {
    case SceneFault::kUnreadable:
      return Text("scene.unreadable", {problem.found});
    case SceneFault::kNotAFile:
      return "scene.no-file";
    case SceneFault::kTooLarge:
      return Text("scene.too-large", {static_cast<std::int64_t>(kMostSceneBytes)});
    case SceneFault::kUnknownFormat:
      return Text("scene.unknown-format", {problem.found});
    case SceneFault::kEncoding:
      return Text("scene.encoding", {problem.found});
    case SceneFault::kNul:
      return "scene.nul";
    case SceneFault::kCoordinates:
      return Text("scene.coordinates", {problem.found});
    case SceneFault::kNumber:
      return Text("scene.number", {problem.found});
    case SceneFault::kBadVertex:
      return Text("scene.bad-vertex", {problem.found});
    case SceneFault::kIndex:
      return Text("scene.index", {problem.found});
    case SceneFault::kNoSuchVertex:
      return Text("scene.no-such-vertex", {problem.found});
    case SceneFault::kTooMany:
      return "scene.too-many";
    case SceneFault::kNothing:
      return problem.line > 0 ? Text("scene.nothing-known", {problem.found}) : "scene.nothing";
    case SceneFault::kNothingDrawn:
      return Text("scene.nothing-drawn", {problem.found});
    case SceneFault::kCancelled:
      break;
  }
  return "scene.cancelled";
}

const char* key(SceneRemark remark) {
  switch (remark) {
    case SceneRemark::kUnknownLines:
      return "scene-note.unknown-lines";
    case SceneRemark::kTooFewCorners:
      return "scene-note.too-few";
    case SceneRemark::kBadVertices:
      return "scene-note.bad-vertices";
    case SceneRemark::kVerticesOnly:
      break;
  }
  return "scene-note.vertices-only";
}

}  // namespace

Text sceneProblemText(const std::string& file, const SceneProblem& problem) {
  Text what = faultText(problem);
  if (problem.line == 0) return Text("error.scene", {file, std::move(what)});
  return Text("error.scene-line", {file, problem.line, std::move(what)});
}

Text sceneNoteText(const SceneNote& note) {
  return Text(key(note.remark), {note.count, note.line, note.found});
}

Text sceneNotesText(const std::vector<SceneNote>& notes) {
  Text all;
  for (const SceneNote& note : notes) {
    all = all.empty() ? sceneNoteText(note) : Text("scene-notes", {all, sceneNoteText(note)});
  }
  return all;
}

}  // namespace vides
