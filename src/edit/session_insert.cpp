// SPDX-License-Identifier: MIT
// Commands that insert at the playhead, at a place of the curve or from a view.
#include "edit/camera_edits.hpp"
#include "edit/division_edits.hpp"
#include "edit/session_actions.hpp"
#include "evaluate/division.hpp"

namespace vides {
namespace {

using Result = SessionActions::Result;

// The orientation that begins the section in which the playhead stands; at the end of an open
// flight the last one.
OrientationPlace placeAt(const Session& session) {
  const auto section = session.evaluation().sectionAtFrame(session.frame());
  if (!section) return session.current();
  const bool past = session.frame() >= section->firstFrame + section->frames;
  return past ? section->to : section->from;
}

}  // namespace

Result SessionActions::enlarge(Session& session, Camera& camera, EditState& state) {
  auto flight = enlargedFor(state.flight, camera);
  if (!flight) return tl::unexpected(flight.error());
  auto evaluation = session.evaluated(*flight);
  if (!evaluation) return tl::unexpected(evaluation.error());
  state.flight = *flight;
  state.evaluation = *evaluation;
  return {};
}

Result SessionActions::askToEnlarge(Session& session, const Text& why,
                                    const std::function<Result(Session&)>& then) {
  session.dialogue_ = Dialogue{
      Question{Question::Kind::kOutsideCube, Text("question.outside-cube"), {"enlarge", "cancel"}},
      [then](Session& s, const std::string&) { return then(s); },
      {}};
  return tl::unexpected(why);
}

// `command` tells where: at the playhead or, with key and fraction, on the curve.
Result SessionActions::divide(Session& session, const Command& command, bool enlarging) {
  const bool atPlayhead = command.arguments.empty();
  const Arguments arguments(command);
  EditState state = session.state_;
  if (enlarging) {
    Camera camera = atPlayhead
                        ? state.evaluation.frame(session.frame()).camera
                        : cameraAtPlace(state.evaluation, arguments.index(0), arguments.number(1));
    if (auto done = enlarge(session, camera, state); !done) return done;
  }
  const EditResult edit = atPlayhead
                              ? insertAtFrame(state, session.frame())
                              : insertAtPlace(state, arguments.index(0), arguments.number(1));
  if (!edit && !enlarging && edit.error().key == kCurveOutsideCube) {
    return askToEnlarge(session, edit.error(),
                        [command](Session& s) { return divide(s, command, true); });
  }
  return session.apply(edit);
}

Result SessionActions::insertAtPlayhead(Session& session, const Arguments&) {
  return divide(session, Command("insert-at-playhead"), false);
}

Result SessionActions::insertKeyAt(Session& session, const Arguments& arguments) {
  return divide(session, Command("insert-key-at", arguments.number(0), arguments.number(1)), false);
}

Result SessionActions::withCamera(Session& session, const char* command, bool enlarging) {
  const bool newKey = std::string_view(command) == "new-key-from-view";
  Camera camera = session.camera();
  EditState state = session.state_;
  if (!insideCube(camera)) {
    if (!enlarging) {
      return askToEnlarge(session, "refusal.outside-cube",
                          [command](Session& s) { return withCamera(s, command, true); });
    }
    if (auto done = enlarge(session, camera, state); !done) return done;
  }
  if (newKey) state.marks = marksAt(placeAt(session));
  auto done =
      session.apply(newKey ? vides::newKeyFromView(state, camera) : vides::useView(state, camera));
  if (done) session.freeCamera_.reset();
  return done;
}

Result SessionActions::useView(Session& session, const Arguments&) {
  return withCamera(session, "use-view", false);
}

Result SessionActions::newKeyFromView(Session& session, const Arguments& arguments) {
  if (!session.freeCamera()) return insertAtPlayhead(session, arguments);
  return withCamera(session, "new-key-from-view", false);
}

}  // namespace vides
