// SPDX-License-Identifier: MIT
// The editor's state without a screen: document, evaluation, current, playhead, view, output line.
//
// Only execute() and the gestures change the flight. Each change is checked against the format's
// ranges first; what is refused changes nothing and is told in the output line. The evaluation
// follows within the same call. Belongs to one thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "edit/command.hpp"
#include "edit/dialogue.hpp"
#include "edit/disk_file.hpp"
#include "edit/display.hpp"
#include "edit/edit_state.hpp"
#include "edit/frame_output.hpp"
#include "edit/history.hpp"
#include "edit/layout.hpp"
#include "edit/marks.hpp"
#include "edit/playback.hpp"
#include "edit/setup.hpp"
#include "edit/text.hpp"
#include "edit/view_state.hpp"
#include "evaluate/evaluation.hpp"
#include "flight/flight.hpp"
#include "scene/scene_store.hpp"

namespace vides {

class FrameJob;

enum class MessageKind {
  kNumbers,  // where the current key is, and the like
  kDone,     // what was done ("Saved …")
  kRefusal,  // what the user asked for can't be done
  kError,    // something failed
};
struct OutputLine {
  MessageKind kind = MessageKind::kNumbers;
  Text text;  // where there is less room: of the same key with #short, #shorter, #shortest
  bool operator==(const OutputLine&) const = default;
};

// What is to become of work that an editor left unsaved.
enum class RecoveryAnswer { kRecover, kForget, kLater };

// What the session needs from outside. Everything may be left out: the clipboard is then the
// session's own.
struct SessionSeams {
  std::function<std::string()> clipboard;
  std::function<void(const std::string&)> setClipboard;
  // Told of every command that did what it says, also of those that preview.
  std::function<void(const Command&)> ran;
  // Told of everything that comes into the output line, also where the next message hides it.
  std::function<void(MessageKind, const Text&)> said;
  std::size_t historyBytes = History::kMostBytes;
  // Whether a large scene may be read while it goes on; else whatever reads one waits for it.
  bool readsInBackground = false;
};

class Session {
 public:
  static constexpr std::size_t kRecentFiles = 10;

  // Begins with New.
  explicit Session(SessionSeams seams = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // False where it was refused or failed: the output line tells why. Between begin() and commit()
  // commands that edit are refused; in a window's gesture they end its step first.
  bool execute(const Command& command);
  bool execute(std::string_view line);  // as after `do` in a script
  // Whether it could do something; not whether a drag or a question must end before it.
  bool available(std::string_view command) const;

  // One gesture, one step: begin() at the press, preview() as often as wanted, each computed from
  // start(), and commit(), which makes a step if the flight has changed. cancel() puts everything
  // back.
  void begin(Text step);
  // The same for a window that previews for as long as it is open. Another edit in the meantime
  // ends the window's step first; the window then goes on from what that edit made. The step is
  // named after the key that has changed, if it is one.
  void beginWindow(std::string stepKey);
  bool inGesture() const { return gesture_.has_value(); }
  bool inDrag() const { return gesture_ && !gesture_->window; }
  bool inWindow() const { return gesture_ && gesture_->window; }
  const EditState& start() const { return gesture_->start; }
  // False where the flight isn't valid: the last valid preview stays, and the output line tells.
  bool preview(Flight flight);
  // A command that edits, on top of what is shown: for sliders and windows that preview. It names
  // a drag's step.
  bool preview(const Command& command);
  void commit();
  void cancel();

  // The document.
  const Flight& flight() const { return state_.flight; }
  const Evaluation& evaluation() const { return state_.evaluation; }
  const EditState& state() const { return state_; }
  const History& history() const { return history_; }
  std::optional<Text> undoName() const;  // "Undo Move key 3"; nothing where nothing can be undone
  std::optional<Text> redoName() const;
  // Empty until it is saved or opened.
  const std::string& path() const { return file_.path(); }
  // Whether closing would lose something.
  bool modified() const { return modified_ || missingOnDisk_; }
  // Whether the file is another than what was read or saved last, or has been edited since.
  bool differsFromFile() const { return modified() || toldOfDisk_; }
  // Name of the file (or "untitled") and a mark where it is modified.
  Text title() const;
  const std::vector<std::string>& recentFiles() const { return recentFiles_; }
  void setRecentFiles(std::vector<std::string> files);
  // A sample to begin with: untitled, so that it is never written over, its scenes by whole paths.
  // False where it can't be read; nothing changes then.
  bool beginWithSample(const std::string& path);
  // A flight from a recovery file: unsaved, as if it had been edited.
  void recover(Flight flight, std::string path);
  // Asks whether to do so; `time` is when it was kept, in words.
  void offerRecovery(Flight flight, std::string path, const std::string& time);
  // What was answered, once.
  std::optional<RecoveryAnswer> takeRecoveryAnswer() {
    return std::exchange(recoveryAnswer_, std::nullopt);
  }
  // The flight's scenes as far as they have been read: large ones come later. What can't be read is
  // left out, and told once in the output line.
  std::vector<SharedDrawable> scenes();
  // Of each of them in the flight's order, as scenes() found them last: what came of reading it;
  // null where that hasn't begun.
  std::vector<SharedReading> sceneReadings() const { return scenes_.readings(); }
  // What is being read, for scenes() or an import.
  struct Reading {
    std::string file;   // the name of the first one
    std::size_t files;  // at work
    double share;       // of them all, 0 to 1
  };
  std::optional<Reading> reading() const;
  // Looks whether another program has changed or deleted the file, and tells so once.
  void checkDisk();

  // Current and selection.
  const OrientationPlace& current() const { return state_.marks.current; }
  const KeySelection& selected() const { return state_.marks.selected; }
  const Key& currentKey() const { return state_.key(); }
  const Orientation& currentOrientation() const { return state_.orientation(); }

  // The playhead and its camera.
  std::int64_t frame() const { return playback_.frame(); }
  const Playback& playback() const { return playback_; }
  void advance(double now);
  // What the camera view shows: the free camera, else the playhead's.
  Camera camera() const;
  const std::optional<Camera>& freeCamera() const { return freeCamera_; }

  const ViewState& view() const { return view_; }
  const Display& display() const { return display_; }
  void setDisplay(const Display& display) { display_ = display; }
  const Layout& layout() const { return layout_; }
  void setLayout(const Layout& layout) { layout_ = layout; }
  // Display, layout and how the viewport is looked at, as a setup file keeps them.
  Setup setup() const;
  void setSetup(const Setup& setup);
  void setView(const ViewState& view) { view_ = view; }

  // Output → Frames…: its settings, the whole path of its file, and the writing, null where nothing
  // is written. What came of it is told by the next advance() after it.
  const FrameOutput& frameOutput() const { return frameOutput_; }
  std::string framesFile() const;
  const FrameJob* frameJob() const { return frameJob_.get(); }
  // Waits for the frames that are being written.
  void finishFrames();

  // The output line: the last message, else the current numbers.
  OutputLine output() const;
  // A place in the cube, in the units that are chosen.
  Text pointText(const Vec3& place) const;
  void say(MessageKind kind, Text text);
  // After an exception in the middle of something: a drag ends as it would by Escape, nothing that
  // was to follow an answer goes on, and the output line tells.
  void abandon(Text why);

  const std::optional<Question>& question() const;
  // Windows that are open, the top one last: "shape", "flight", "chooser-open", "shortcuts", …
  const std::vector<std::string>& windows() const { return windows_; }
  bool windowOpen(std::string_view name) const;
  // What the open shape window shows as chosen: a preset, or KeyShape::kOwn.
  int chosenPreset() const;
  // Whether the current key tries another shape for its preset, which `shape-show` would apply.
  bool triesPreset() const;
  bool quitRequested() const { return quit_; }
  bool fullScreen() const { return fullScreen_; }

 private:
  friend struct SessionActions;
  // A preset's new shape is tried at one key, which has it as its own until it is applied.
  struct PresetTrial {
    std::size_t key = 0;
    int preset = 0;
  };
  struct Gesture {
    Text step;
    EditState start;
    Playback playback;
    bool window = false;
    std::optional<PresetTrial> trial = {};
  };

  bool refuse(Text why);
  // Runs a command that was checked.
  tl::expected<void, Text> run(const Command& command);
  // Why a command can't run now; nothing where it can.
  std::optional<Text> obstacle(const Command& command) const;
  // What is wrong with a flight, by what differs from the one that is shown.
  std::optional<Text> problemWith(const Flight& flight) const;
  // Checked, then evaluated, reusing what is shown.
  tl::expected<Evaluation, Text> evaluated(const Flight& flight) const;
  tl::expected<void, Text> apply(const EditResult& edit);
  void show(const Flight& flight, const Evaluation& evaluation, const Marks& marks);
  void setMarks(const Marks& marks);
  void makeCurrent(const Marks& marks);
  void pushStep(Text name, const EditState& before, bool keepsPlayhead = false);
  // Shows what undo or redo leads to.
  void showStep(const Step& step, const Flight& flight, const Marks& marks);
  // Whether a window previews something that is no step yet.
  bool windowChanged() const;
  Text gestureStep() const;
  void updateModified();
  // Ends a window's gesture, which endGesture() begins again.
  void interruptWindow();
  // Ends a gesture; a window's gesture that it interrupted begins again.
  void endGesture();
  void reset(Flight flight);
  void collectFrames();
  void collectScenes();

  SessionSeams seams_;
  EditState state_;
  History history_;
  DiskFile file_;
  Flight savedFlight_;
  bool modified_ = false;
  bool missingOnDisk_ = false;
  bool toldOfDisk_ = false;
  std::optional<Gesture> gesture_;
  std::optional<std::string> window_;  // the step of the window's gesture that is interrupted
  // At the window's opening, where another edit has made a step of what it had changed.
  std::optional<EditState> windowOpening_;
  Playback playback_;
  std::optional<Camera> freeCamera_;
  ViewState view_;
  Display display_;
  Layout layout_;
  OutputLine output_;
  std::optional<Dialogue> dialogue_;
  std::optional<RecoveryAnswer> recoveryAnswer_;
  std::vector<std::string> windows_;
  std::vector<std::string> recentFiles_;
  std::string ownClipboard_;
  FrameOutput frameOutput_;
  std::string framesWritten_;  // the file that was written last, overwritten again unasked
  std::unique_ptr<FrameJob> frameJob_;
  SceneStore scenes_;
  struct Import {
    SharedReading reading;
    std::string path;
  };
  std::vector<Import> imports_;  // the next one first
  // Of the scenes that are shown: as the flight named them, from where, and the whole paths.
  std::vector<SceneFile> sceneFiles_;
  std::string scenesFrom_;
  std::vector<std::filesystem::path> scenePaths_;
  std::int64_t document_ = 0;  // another number with each New and Open
  bool quit_ = false;
  bool fullScreen_ = false;
};

}  // namespace vides
