// SPDX-License-Identifier: MIT
// The shape window's part of the session: one gesture for as long as the window is open.
//
// What is chosen and moved is seen on the curve at once, at the current key. Another shape for a
// preset is first tried there, as the key's own: only `shape-show` (or -ok) gives it to the preset,
// and with it to every key that has it. Where another edit ends the window's step before, the key
// keeps what is seen, and no other key changes; Cancel then goes back to the opening by a step.
#include <utility>

#include "edit/key_edits.hpp"
#include "edit/key_values.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

using Result = SessionActions::Result;

constexpr const char* kStep = "step.set-shape";

std::size_t keysWithPreset(const Flight& flight, int preset) {
  std::size_t count = 0;
  flight.keys.forEach([&](const Key& key) { count += key.shape.preset == preset ? 1u : 0u; });
  return count;
}

// Each selected key keeps what it looks like.
Flight withOwnShapes(const EditState& state) {
  return changeSelected(state, kStep, kStep,
                        [&](Key& key, std::size_t) -> std::optional<Text> {
                          const Shape shape = shapeOf(state.flight, key);
                          key.shape.preset = KeyShape::kOwn;
                          key.shape.own = shape;
                          return std::nullopt;
                        })
      ->flight;
}

// The refusal that a preview has told is not told again.
Result previewed(bool done, const Session& session) {
  if (done) return {};
  return tl::unexpected(session.output().text);
}

}  // namespace

bool Session::triesPreset() const {
  return inWindow() && gesture_->trial && gesture_->trial->key == current().key &&
         currentKey().shape.preset == KeyShape::kOwn;
}

int Session::chosenPreset() const {
  return triesPreset() ? gesture_->trial->preset : currentKey().shape.preset;
}

void SessionActions::beginShape(Session& session) { session.beginWindow(kStep); }

void SessionActions::endShape(Session& session) {
  if (session.inWindow()) session.cancel();
  session.window_.reset();
  if (!session.windowOpening_) return;
  // Steps were made since: one more goes back to the opening, and can be undone like them.
  const EditState opening = *std::exchange(session.windowOpening_, std::nullopt);
  const Edit back{opening.flight, "step.cancel-shape", opening.marks, "output.shape-cancelled"};
  static_cast<void>(session.apply(back));
}

Result SessionActions::shapeChoose(Session& session, const Arguments& arguments) {
  const std::string& choice = arguments.text(0);
  if (choice == "own") {
    auto done = previewed(session.preview(withOwnShapes(session.state())), session);
    if (done) session.gesture_->trial.reset();
    return done;
  }
  auto done = previewed(session.preview(Command("set-preset", std::stoi(choice))), session);
  if (done) session.gesture_->trial.reset();
  return done;
}

Result SessionActions::shapeSet(Session& session, const Arguments& arguments) {
  const int chosen = session.chosenPreset();
  const Command command("set-" + arguments.text(0), arguments.value(1));
  if (auto done = previewed(session.preview(command), session); !done) return done;
  if (chosen == KeyShape::kOwn) return {};
  // In several keys at once it is their own: a preset is tried at one key.
  if (session.selected().size() > 1) {
    session.gesture_->trial.reset();
    return {};
  }
  // Moved back to where the preset has it, nothing is tried.
  const Flight& flight = session.flight();
  if (session.currentKey().shape.own == flight.presets[static_cast<std::size_t>(chosen)]) {
    auto done = previewed(session.preview(Command("set-preset", chosen)), session);
    if (done) session.gesture_->trial.reset();
    return done;
  }
  session.gesture_->trial = Session::PresetTrial{session.current().key, chosen};
  return {};
}

Result SessionActions::shapeShow(Session& session, const Arguments&) {
  if (!session.triesPreset()) return {};
  const int preset = session.gesture_->trial->preset;
  Flight flight = session.flight();
  Key key = session.currentKey();
  flight.presets[static_cast<std::size_t>(preset)] = key.shape.own;
  key.shape.preset = preset;
  key.shape.own = {};
  flight = withKey(flight, session.current().key, std::move(key));
  if (auto done = previewed(session.preview(flight), session); !done) return done;
  session.gesture_->trial.reset();
  session.say(MessageKind::kDone,
              Text("output.preset-shown", {keysWithPreset(flight, preset), preset}));
  return {};
}

Result SessionActions::shapeOk(Session& session, const Arguments& arguments) {
  if (auto done = shapeShow(session, arguments); !done) return done;
  session.commit();
  session.windowOpening_.reset();
  hideWindow(session, "shape");
  return {};
}

Result SessionActions::shapeCancel(Session& session, const Arguments&) {
  hideWindow(session, "shape");
  return {};
}

}  // namespace vides
