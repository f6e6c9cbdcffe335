// SPDX-License-Identifier: MIT
// The session's heart: how a command or a gesture changes the flight, and what follows from it.
#include "edit/session.hpp"

#include <algorithm>

#include "edit/command_table.hpp"
#include "edit/folder.hpp"
#include "edit/frame_job.hpp"
#include "edit/place_text.hpp"
#include "flight/validation.hpp"
#include "io/vid_reader.hpp"

namespace vides {
namespace {

// Everything but the keys, with two keys that are valid.
std::vector<Problem> checkAllButKeys(const Flight& flight) {
  Flight rest = flight;
  rest.keys = newFlight().keys;
  return validate(rest);
}

bool sameButKeys(const Flight& a, const Flight& b) {
  return a.name == b.name && a.frameRate == b.frameRate && a.picture == b.picture &&
         a.lens == b.lens && a.space == b.space && a.rates == b.rates && a.presets == b.presets &&
         a.scene == b.scene;
}

}  // namespace

Session::Session(SessionSeams seams)
    : seams_(std::move(seams)), history_(seams_.historyBytes), scenes_(!seams_.readsInBackground) {
  reset(newFlight());
}
Session::~Session() = default;

void Session::reset(Flight flight) {
  state_.evaluation = Evaluation(flight);
  state_.flight = flight;
  state_.marks = Marks{};
  savedFlight_ = std::move(flight);
  modified_ = false;
  missingOnDisk_ = false;
  toldOfDisk_ = false;
  history_.clear();
  gesture_.reset();
  window_.reset();
  windowOpening_.reset();
  std::erase(windows_, "shape");  // what it would go back to is gone
  playback_.stop();
  playback_.goTo(0);
  freeCamera_.reset();
  output_ = {};
  // Another flight: all of its frames, into a file of its own; format and space are kept.
  frameOutput_.options = {.format = frameOutput_.options.format,
                          .space = frameOutput_.options.space};
  frameOutput_.file.clear();
  framesWritten_.clear();
  dialogue_.reset();  // it was about the flight before
  for (const Import& import : imports_) import.reading->cancel();
  imports_.clear();
  ++document_;
}

bool Session::beginWithSample(const std::string& path) {
  auto sample = readVidFile(path);
  if (!sample) return false;
  moveScenePaths(*sample, path, "");
  file_ = DiskFile();
  reset(std::move(*sample));
  return true;
}

void Session::recover(Flight flight, std::string path) {
  Flight saved = newFlight();
  // Where its file is gone it has none: saving asks, and doesn't write over another one.
  file_ = DiskFile();
  if (!path.empty()) {
    if (auto onDisk = file_.open(path)) {
      saved = std::move(*onDisk);
    } else {
      moveScenePaths(flight, path, "");
    }
  }
  reset(std::move(flight));
  savedFlight_ = std::move(saved);
  modified_ = true;
}

// --- Commands ---

bool Session::execute(std::string_view line) {
  const auto command = parseCommand(line);
  return command ? execute(*command) : refuse(command.error());
}

bool Session::execute(const Command& command) {
  if (auto checked = checkArguments(command); !checked) return refuse(checked.error());
  if (auto why = obstacle(command)) return refuse(std::move(*why));
  const auto done = run(command);
  if (!gesture_) endGesture();
  if (done) {
    if (seams_.ran) seams_.ran(command);
    return true;
  }
  // A failure (of the disk, say) is told as such already.
  if (output_ == OutputLine{MessageKind::kError, done.error()}) return false;
  return refuse(done.error());
}

bool Session::available(std::string_view name) const {
  const CommandSpecification* command = findCommand(name);
  return command != nullptr && (command->available == nullptr || command->available(*this));
}

std::optional<Text> Session::obstacle(const Command& command) const {
  const CommandSpecification& specification = *findCommand(command.name);
  if (specification.exclusive && gesture_ && !gesture_->window) return "refusal.in-gesture";
  if (specification.exclusive && question()) return "refusal.answer-first";
  if (specification.available != nullptr && !specification.available(*this)) {
    if (specification.why != nullptr) return specification.why;
    return Text("refusal.not-available", {Text(specification.titleKey())});
  }
  return std::nullopt;
}

tl::expected<void, Text> Session::run(const Command& command) {
  const CommandSpecification& specification = *findCommand(command.name);
  const Arguments arguments(command);
  if (const auto* edit = std::get_if<EditFunction>(&specification.run)) {
    return apply((*edit)(state_, arguments));
  }
  return std::get<ActFunction>(specification.run)(*this, arguments);
}

bool Session::refuse(Text why) {
  say(MessageKind::kRefusal, std::move(why));
  return false;
}

void Session::say(MessageKind kind, Text text) {
  output_ = {kind, std::move(text)};
  if (seams_.said) seams_.said(kind, output_.text);
}

// --- Changing the flight ---

std::optional<Text> Session::problemWith(const Flight& flight) const {
  if (!sameButKeys(flight, state_.flight)) {
    if (const auto problems = checkAllButKeys(flight); !problems.empty()) {
      return refusalOf(problems.front());
    }
  }
  if (!limits::kKeys.contains(flight.keys.size())) return Text("refusal.too-many-keys");
  for (const auto& change :
       KeyList::Sequence::changes(state_.flight.keys.sequence(), flight.keys.sequence())) {
    for (std::size_t k = change.first; k < change.newLast; ++k) {
      if (const auto problem = checkKey(flight, k)) return refusalOf(*problem);
    }
  }
  return std::nullopt;
}

tl::expected<Evaluation, Text> Session::evaluated(const Flight& flight) const {
  if (auto problem = problemWith(flight)) return tl::unexpected(std::move(*problem));
  Evaluation evaluation = state_.evaluation.updated(flight);
  if (evaluation.frameCount() > static_cast<std::int64_t>(limits::kFrames)) {
    return tl::unexpected(Text("refusal.too-many-frames", {evaluation.frameCount()}));
  }
  return evaluation;
}

void Session::show(const Flight& flight, const Evaluation& evaluation, const Marks& marks) {
  const bool onCurrent = frame() == state_.evaluation.frameOf(current());
  const bool moved = marks.current != current();
  if (freeCamera_ && !(flight.space == state_.flight.space)) {
    Vec3& place = freeCamera_->viewReferencePoint;
    place = flight.space.toCube(state_.flight.space.toWorld(place));
  }
  state_ = {flight, evaluation, marks};
  // The playhead stays with the current orientation, however many frames now come before it.
  if (moved || (onCurrent && !playback_.playing())) {
    playback_.goTo(state_.evaluation.frameOf(current()));
  }
  const std::int64_t last = state_.evaluation.frameCount() - 1;
  if (frame() > last) playback_.goTo(last);
}

tl::expected<void, Text> Session::apply(const EditResult& edit) {
  if (!edit) return tl::unexpected(edit.error());
  const bool changes = !(edit->flight == state_.flight);
  const EditState before = state_;
  if (changes) {
    const auto evaluation = evaluated(edit->flight);
    if (!evaluation) return tl::unexpected(evaluation.error());
    // Only what is done ends a window's step.
    if (inWindow()) interruptWindow();
    show(edit->flight, *evaluation, clamped(edit->marks, edit->flight));
    pushStep(edit->step, before, edit->keepsPlayhead);
  } else if (!(edit->marks == state_.marks)) {
    show(state_.flight, state_.evaluation, edit->marks);
  }
  output_ = edit->note.empty() ? OutputLine{} : OutputLine{MessageKind::kDone, edit->note};
  return {};
}

void Session::pushStep(Text name, const EditState& before, bool keepsPlayhead) {
  history_.push({std::move(name), before.flight, state_.flight, before.marks, state_.marks,
                 keepsPlayhead});
  updateModified();
}

void Session::showStep(const Step& step, const Flight& flight, const Marks& marks) {
  const std::int64_t frame = playback_.frame();
  show(flight, state_.evaluation.updated(flight), marks);
  if (step.keepsPlayhead) playback_.goTo(std::min(frame, state_.evaluation.frameCount() - 1));
}

void Session::updateModified() { modified_ = !(state_.flight == savedFlight_); }

// --- Gestures ---

void Session::begin(Text step) {
  if (inDrag()) cancel();
  if (inWindow()) interruptWindow();
  gesture_ = Gesture{std::move(step), state_, playback_, false};
}

void Session::beginWindow(std::string stepKey) {
  if (gesture_) cancel();
  gesture_ = Gesture{Text(std::move(stepKey)), state_, playback_, true};
}

void Session::interruptWindow() {
  const std::string window = gesture_->step.key;
  if (windowChanged() && !windowOpening_) windowOpening_ = gesture_->start;
  commit();
  window_ = window;
}

bool Session::windowChanged() const {
  return inWindow() && !(state_.flight == gesture_->start.flight);
}

Text Session::gestureStep() const {
  if (!gesture_->window) return gesture_->step;
  const Flight& before = gesture_->start.flight;
  std::size_t count = 0, key = current().key;
  for (const auto& change :
       KeyList::Sequence::changes(before.keys.sequence(), state_.flight.keys.sequence())) {
    count += change.newLast - change.first;
    key = change.first;
  }
  if (count > 1) return "step.edit-keys";
  for (std::size_t i = 0; count == 0 && i < kPresets; ++i) {
    if (before.presets[i] != state_.flight.presets[i]) return Text("step.set-preset-shape", {i});
  }
  return Text(gesture_->step.key, {key + 1});
}

bool Session::preview(Flight flight) {
  if (!gesture_) return false;
  const auto evaluation = evaluated(flight);
  if (!evaluation) return refuse(evaluation.error());
  show(flight, *evaluation, clamped(state_.marks, flight));
  output_ = {};
  return true;
}

bool Session::preview(const Command& command) {
  if (!gesture_) return false;
  if (auto checked = checkArguments(command); !checked) return refuse(checked.error());
  const auto* edit = std::get_if<EditFunction>(&findCommand(command.name)->run);
  if (edit == nullptr) return refuse("refusal.in-gesture");
  const EditResult result = (*edit)(state_, Arguments(command));
  if (!result) return refuse(result.error());
  if (!preview(result->flight)) return false;
  if (!gesture_->window) gesture_->step = result->step;
  if (seams_.ran) seams_.ran(command);
  return true;
}

void Session::commit() {
  if (!gesture_) return;
  if (!(state_.flight == gesture_->start.flight)) pushStep(gestureStep(), gesture_->start);
  endGesture();
}

void Session::cancel() {
  if (!gesture_) return;
  const bool changed = !(state_.flight == gesture_->start.flight);
  const Gesture gesture = std::move(*gesture_);
  gesture_.reset();
  // While a window was open the user may have gone elsewhere: that stays where nothing changed.
  if (changed || !gesture.window) {
    show(gesture.start.flight, gesture.start.evaluation, gesture.start.marks);
  }
  if (!gesture.window) playback_ = gesture.playback;
  output_ = {};
  endGesture();
}

void Session::endGesture() {
  gesture_.reset();
  if (!window_) return;
  const std::string window = *window_;
  window_.reset();
  beginWindow(window);
}

// --- Current, playhead ---

void Session::setMarks(const Marks& marks) {
  state_.marks = clamped(marks, state_.flight);
  output_ = {};
}

void Session::makeCurrent(const Marks& marks) {
  setMarks(marks);
  playback_.goTo(state_.evaluation.frameOf(current()));
}

void Session::advance(double now) {
  playback_.advance(now, state_.evaluation.frameCount(), state_.flight.frameRate);
  collectFrames();
  collectScenes();
}

Camera Session::camera() const {
  return freeCamera_ ? *freeCamera_ : state_.evaluation.frame(frame()).camera;
}

// --- What is told ---

Text Session::pointText(const Vec3& place) const {
  const Vec3 p = display_.units == Units::kScene ? state_.flight.space.toWorld(place) : place;
  return Text("output.point", {p.x, p.y, p.z});
}

OutputLine Session::output() const {
  if (!output_.text.empty()) return output_;
  const Key& key = currentKey();
  const Orientation& o = currentOrientation();
  return {MessageKind::kNumbers,
          Text("output.numbers",
               {current().key + 1, state_.flight.keys.size(), current().orientation + 1,
                key.orientations.size(), pointText(key.position), pointText(aimPoint(key, o)),
                o.roll, o.zoom})};
}

std::optional<Text> Session::undoName() const {
  if (windowChanged()) return Text("menu.undo", {gestureStep()});
  if (!history_.canUndo()) return std::nullopt;
  return Text("menu.undo", {history_.undoStep().name});
}

std::optional<Text> Session::redoName() const {
  // What a window has changed ends what could be redone.
  if (windowChanged() || !history_.canRedo()) return std::nullopt;
  return Text("menu.redo", {history_.redoStep().name});
}

Text Session::title() const {
  const char* key = modified() ? "title.modified" : "title.saved";
  if (path().empty()) return Text(key, {Text("title.untitled")});
  return Text(key, {fileName(path())});
}

Setup Session::setup() const {
  const EditorView& view = view_.view;
  Setup setup{display_, layout_, view.turn, view.tilt, view.size, false};
  setup.layout.bare = false;
  setup.perspective = view.type == ProjectionType::Perspective;
  return setup;
}

void Session::setSetup(const Setup& setup) {
  display_ = setup.display;
  const bool bare = layout_.bare;
  layout_ = setup.layout;
  layout_.bare = bare;
  EditorView& view = view_.view;
  view.turn = setup.turn;
  view.tilt = setup.tilt;
  view.size = setup.size;
  view.type = setup.perspective ? ProjectionType::Perspective : ProjectionType::Parallel;
}

void Session::setRecentFiles(std::vector<std::string> files) {
  recentFiles_ = std::move(files);
  if (recentFiles_.size() > kRecentFiles) recentFiles_.resize(kRecentFiles);
}

bool Session::windowOpen(std::string_view name) const {
  return std::find(windows_.begin(), windows_.end(), name) != windows_.end();
}

}  // namespace vides
