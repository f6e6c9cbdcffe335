// SPDX-License-Identifier: MIT
// What commands do besides editing the flight: the functions behind the table of commands.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit/session.hpp"

namespace vides {

struct SessionActions {
  using Result = tl::expected<void, Text>;

  // History.
  static Result undo(Session& session, const Arguments& arguments);
  static Result redo(Session& session, const Arguments& arguments);

  // Current and selection.
  static Result selectKey(Session& session, const Arguments& arguments);
  static Result makeCurrent(Session& session, const Arguments& arguments);
  static Result toggleSelect(Session& session, const Arguments& arguments);
  static Result selectKeys(Session& session, const Arguments& arguments);
  static Result addToSelection(Session& session, const Arguments& arguments);
  static Result selectAll(Session& session, const Arguments& arguments);
  static Result nextKey(Session& session, const Arguments& arguments);
  static Result previousKey(Session& session, const Arguments& arguments);
  static Result nextOrientation(Session& session, const Arguments& arguments);
  static Result previousOrientation(Session& session, const Arguments& arguments);

  // Clipboard.
  static Result copy(Session& session, const Arguments& arguments);
  static Result cut(Session& session, const Arguments& arguments);
  static Result paste(Session& session, const Arguments& arguments);

  // Files.
  static Result newFlight(Session& session, const Arguments& arguments);
  static Result open(Session& session, const Arguments& arguments);
  static Result openRecent(Session& session, const Arguments& arguments);
  static Result save(Session& session, const Arguments& arguments);
  static Result saveAs(Session& session, const Arguments& arguments);
  static Result revert(Session& session, const Arguments& arguments);
  static Result quit(Session& session, const Arguments& arguments);
  static Result answer(Session& session, const Arguments& arguments);

  // Scenes.
  static Result importScene(Session& session, const Arguments& arguments);
  static Result finishImport(Session& session, const Session::Import& import);
  static Result cancelReading(Session& session, const Arguments& arguments);

  // The playhead.
  static Result play(Session& session, const Arguments& arguments);
  static Result goToFrame(Session& session, const Arguments& arguments);
  static Result nextFrame(Session& session, const Arguments& arguments);
  static Result previousFrame(Session& session, const Arguments& arguments);
  static Result goToNextOrientation(Session& session, const Arguments& arguments);
  static Result goToPreviousOrientation(Session& session, const Arguments& arguments);
  static Result firstFrame(Session& session, const Arguments& arguments);
  static Result lastFrame(Session& session, const Arguments& arguments);
  static Result loop(Session& session, const Arguments& arguments);

  // The view.
  static Result view(Session& session, const Arguments& arguments);
  static Result setView(Session& session, const Arguments& arguments);
  static Result setTurn(Session& session, const Arguments& arguments);
  static Result setTilt(Session& session, const Arguments& arguments);
  static Result setSize(Session& session, const Arguments& arguments);
  static Result viewOpposite(Session& session, const Arguments& arguments);
  static Result viewCamera(Session& session, const Arguments& arguments);
  static Result perspective(Session& session, const Arguments& arguments);
  static Result frameSelection(Session& session, const Arguments& arguments);
  static Result frameAll(Session& session, const Arguments& arguments);
  static Result swapViews(Session& session, const Arguments& arguments);

  // The free camera.
  static Result setFreeView(Session& session, const Arguments& arguments);
  static Result flyTurn(Session& session, const Arguments& arguments);
  static Result flyMove(Session& session, const Arguments& arguments);
  static Result flyRoll(Session& session, const Arguments& arguments);
  static Result flyZoom(Session& session, const Arguments& arguments);
  static Result leaveView(Session& session, const Arguments& arguments);
  static Result useView(Session& session, const Arguments& arguments);
  static Result newKeyFromView(Session& session, const Arguments& arguments);

  // At a moment of the film.
  static Result insertAtPlayhead(Session& session, const Arguments& arguments);
  static Result insertKeyAt(Session& session, const Arguments& arguments);

  // Display and windows.
  static Result showElement(Session& session, const Arguments& arguments);
  static Result setColour(Session& session, const Arguments& arguments);
  static Result resetColour(Session& session, const Arguments& arguments);
  static Result setTheme(Session& session, const Arguments& arguments);
  static Result contentScale(Session& session, const Arguments& arguments);
  static Result elementSize(Session& session, const Arguments& arguments);
  static Result resetSizes(Session& session, const Arguments& arguments);
  static Result gridStep(Session& session, const Arguments& arguments);
  static Result ghostEvery(Session& session, const Arguments& arguments);
  static Result units(Session& session, const Arguments& arguments);
  static Result language(Session& session, const Arguments& arguments);
  static Result loadSetup(Session& session, const Arguments& arguments);
  static Result saveSetup(Session& session, const Arguments& arguments);
  static Result resetSetup(Session& session, const Arguments& arguments);
  static Result showWindow(Session& session, const Arguments& arguments);
  static Result closeWindow(Session& session, const Arguments& arguments);
  static Result fullScreen(Session& session, const Arguments& arguments);
  static Result escape(Session& session, const Arguments& arguments);

  // The shape window.
  static Result shapeChoose(Session& session, const Arguments& arguments);
  static Result shapeSet(Session& session, const Arguments& arguments);
  static Result shapeShow(Session& session, const Arguments& arguments);
  static Result shapeOk(Session& session, const Arguments& arguments);
  static Result shapeCancel(Session& session, const Arguments& arguments);
  static void beginShape(Session& session);
  static void endShape(Session& session);

  // Output → Frames….
  static Result framesFormat(Session& session, const Arguments& arguments);
  static Result framesSpace(Session& session, const Arguments& arguments);
  static Result framesRange(Session& session, const Arguments& arguments);
  static Result framesFirstNumber(Session& session, const Arguments& arguments);
  static Result framesFile(Session& session, const Arguments& arguments);
  static Result writeFrames(Session& session, const Arguments& arguments);
  static Result cancelFrames(Session& session, const Arguments& arguments);

  // Parts of the above, without questions.
  static Result openFile(Session& session, const std::string& path);
  // What is wrong with it, all of it, where it can't be read: nothing has changed then.
  static std::vector<Problem> readFlight(Session& session, const std::string& path);
  static Result saveFile(Session& session, const std::string& path);
  static Result proceed(Session& session, const Command& command);
  static Result beginFrames(Session& session, const std::string& mayOverwrite);

  // Dialogues (session_dialogue.cpp). `then`: what goes on after the saving.
  static Result askBeforeLoss(Session& session, const Command& command);
  static Result saveThen(Session& session, const std::optional<Command>& then);
  static Result saveFileThen(Session& session, const std::string& path,
                             const std::optional<Command>& then);
  static void chooseNameThen(Session& session, const std::optional<Command>& then);
  static std::optional<Command> takeAfterSaving(Session& session);
  static void openWindow(Session& session, const std::string& name);
  static void hideWindow(Session& session, const std::string& name);
  static Result withCamera(Session& session, const char* command, bool enlarging);
  static Result divide(Session& session, const Command& command, bool enlarging);
  // Camera and state in the smallest space that holds the camera.
  static Result enlarge(Session& session, Camera& camera, EditState& state);
  static Result askToEnlarge(Session& session, const Text& why,
                             const std::function<Result(Session&)>& then);
  static Result fly(Session& session, const Camera& camera);
};

// "on", "off", "toggle", nothing (toggle).
bool switched(const Arguments& arguments, std::size_t index, bool now);

}  // namespace vides
