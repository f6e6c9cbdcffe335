// SPDX-License-Identifier: MIT
// Commands for files and the clipboard: nothing is lost or overwritten unasked.
#include <algorithm>
#include <filesystem>

#include "edit/clipboard_text.hpp"
#include "edit/folder.hpp"
#include "edit/frame_job.hpp"
#include "edit/key_edits.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

using Result = SessionActions::Result;

Text problemText(const char* key, const std::string& path, const std::vector<Problem>& problems) {
  if (problems.size() == 1) return Text(key, {fileName(path), problems.front()});
  return Text(std::string(key) + "-more", {fileName(path), problems.front(), problems.size() - 1});
}

void remember(std::vector<std::string>& recent, const std::string& path) {
  std::erase(recent, path);
  recent.insert(recent.begin(), path);
  if (recent.size() > Session::kRecentFiles) recent.resize(Session::kRecentFiles);
}

// Something failed, other than being refused.
Result failed(Session& session, Text why) {
  session.say(MessageKind::kError, why);
  return tl::unexpected(std::move(why));
}

}  // namespace

// --- Files ---

Result SessionActions::open(Session& session, const Arguments& arguments) {
  if (!arguments.has(0)) {
    openWindow(session, "chooser-open");
    return {};
  }
  return askBeforeLoss(session, Command("open", arguments.text(0)));
}

Result SessionActions::openRecent(Session& session, const Arguments& arguments) {
  const std::size_t i = arguments.index(0);
  if (i >= session.recentFiles_.size()) return tl::unexpected(Text("refusal.no-such-recent", {i}));
  return askBeforeLoss(session, Command("open", session.recentFiles_[i]));
}

Result SessionActions::openFile(Session& session, const std::string& path) {
  const std::vector<Problem> problems = readFlight(session, path);
  if (problems.empty()) return {};
  return failed(session, problemText("output.open-failed", path, problems));
}

std::vector<Problem> SessionActions::readFlight(Session& session, const std::string& path) {
  DiskFile file;
  auto flight = file.open(path);
  if (!flight) return std::move(flight.error());
  session.file_ = std::move(file);
  session.reset(std::move(*flight));
  remember(session.recentFiles_, session.path());
  hideWindow(session, "chooser-open");
  session.say(MessageKind::kDone, Text("output.opened", {fileName(path)}));
  return {};
}

Result SessionActions::save(Session& session, const Arguments&) {
  return saveThen(session, takeAfterSaving(session));
}

Result SessionActions::saveAs(Session& session, const Arguments& arguments) {
  if (!arguments.has(0)) {
    openWindow(session, "chooser-save");
    return {};
  }
  return saveFileThen(session, arguments.text(0), takeAfterSaving(session));
}

Result SessionActions::saveFile(Session& session, const std::string& path) {
  namespace fs = std::filesystem;
  const std::string from = session.path();
  const std::vector<SceneFile>& scenes = session.flight().scene;
  // Scenes are named from where the flight lies: anew where it goes elsewhere, or where it was read
  // with a whole path.
  const bool moves =
      from.empty() ||
      std::any_of(scenes.begin(), scenes.end(),
                  [](const SceneFile& scene) { return fs::path(scene.file).is_absolute(); }) ||
      resolvedPath(path).parent_path() != fs::path(from).parent_path();
  Flight flight = session.flight();
  if (moves) moveScenePaths(flight, from, path);
  if (const auto problem = session.file_.save(flight, path)) {
    return failed(session, problemText("output.save-failed", path, {*problem}));
  }
  // The window goes on from what is saved.
  if (session.inWindow()) session.interruptWindow();
  if (moves) {
    session.rewriteHeld([&](Flight& f) { moveScenePaths(f, from, path); });
    session.state_.flight = flight;
    session.state_.evaluation = session.state_.evaluation.updated(flight);
  }
  session.savedFlight_ = std::move(flight);
  session.modified_ = false;
  session.missingOnDisk_ = false;
  session.toldOfDisk_ = false;
  remember(session.recentFiles_, session.path());
  session.say(MessageKind::kDone, Text("output.saved", {fileName(path)}));
  hideWindow(session, "chooser-save");
  return {};
}

Result SessionActions::revert(Session& session, const Arguments&) {
  auto flight = session.file_.reopen();
  if (!flight) {
    return failed(session, problemText("output.open-failed", session.path(), flight.error()));
  }
  const Marks marks = clamped(session.state_.marks, *flight);
  auto done = session.apply(Edit{*flight, Text("step.revert"), marks,
                                 Text("output.reverted", {fileName(session.path())})});
  if (!done) return done;
  session.savedFlight_ = session.state_.flight;
  session.modified_ = false;
  session.missingOnDisk_ = false;
  session.toldOfDisk_ = false;
  return {};
}

// --- The setup ---

Result SessionActions::loadSetup(Session& session, const Arguments& arguments) {
  if (!arguments.has(0)) {
    openWindow(session, "chooser-setup");
    return {};
  }
  const std::string& path = arguments.text(0);
  const ReadSetup setup = readSetupFile(path);
  if (!setup) return failed(session, problemText("output.setup-failed", path, setup.error()));
  session.setSetup(*setup);
  hideWindow(session, "chooser-setup");
  session.say(MessageKind::kDone, Text("output.setup-loaded", {fileName(path)}));
  return {};
}

Result SessionActions::saveSetup(Session& session, const Arguments& arguments) {
  if (!arguments.has(0)) {
    openWindow(session, "chooser-save-setup");
    return {};
  }
  const std::string& path = arguments.text(0);
  if (const auto problem = vides::saveSetup(session.setup(), path)) {
    return failed(session, problemText("output.save-failed", path, {*problem}));
  }
  hideWindow(session, "chooser-save-setup");
  session.say(MessageKind::kDone, Text("output.saved", {fileName(path)}));
  return {};
}

Result SessionActions::resetSetup(Session& session, const Arguments&) {
  Setup setup;
  // Nobody is thrown into a language that he can't read.
  setup.display.language = session.display_.language;
  session.setSetup(setup);
  session.say(MessageKind::kDone, Text("output.setup-reset"));
  return {};
}

void Session::checkDisk() {
  checkScenesOnDisk();
  const DiskState disk = file_.compare();
  missingOnDisk_ = disk == DiskState::kDeleted;
  if (disk == DiskState::kSame) {
    toldOfDisk_ = false;
  } else if (!toldOfDisk_) {
    toldOfDisk_ = true;
    say(MessageKind::kError,
        Text(missingOnDisk_ ? "output.deleted-on-disk" : "output.changed-on-disk",
             {fileName(path())}));
  }
}

// --- Clipboard ---

Result SessionActions::copy(Session& session, const Arguments&) {
  std::string text = clipboardText(session.flight(), session.selected());
  if (session.seams_.setClipboard) {
    session.seams_.setClipboard(text);
  } else {
    session.ownClipboard_ = std::move(text);
  }
  session.say(MessageKind::kDone, Text("output.copied", {session.selected().size()}));
  return {};
}

Result SessionActions::cut(Session& session, const Arguments& arguments) {
  EditResult edit = deleteKeysEdit(session.state_, arguments);
  if (!edit) return tl::unexpected(edit.error());
  edit->step = Text("step.cut-keys", {session.selected().size()});
  const Result copied = copy(session, arguments);
  return copied ? session.apply(edit) : copied;
}

Result SessionActions::paste(Session& session, const Arguments&) {
  const std::string text =
      session.seams_.clipboard ? session.seams_.clipboard() : session.ownClipboard_;
  const auto keys = keysFromClipboard(text, session.flight());
  if (!keys) return tl::unexpected(keys.error());
  return session.apply(pastedKeys(session.state_, *keys, Text("step.paste-keys", {keys->size()})));
}

}  // namespace vides
