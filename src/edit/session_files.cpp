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

// --- Questions ---

Result SessionActions::askBeforeLoss(Session& session, const Command& command) {
  if (!session.modified()) return proceed(session, command);
  const Text name = session.path().empty() ? Text("title.untitled") : Text();
  session.question_ = Question{Question::Kind::kUnsaved,
                               name.empty() ? Text("question.unsaved", {fileName(session.path())})
                                            : Text("question.unsaved", {name}),
                               {"save", "discard", "cancel"}};
  session.afterAnswer_ = command;
  return {};
}

Result SessionActions::proceed(Session& session, const Command& command) {
  if (command.name == "quit") {
    session.quit_ = true;
    return {};
  }
  if (command.name == "open") {
    return openFile(session, std::get<std::string>(command.arguments.front()));
  }
  session.file_ = DiskFile();
  session.reset(vides::newFlight());
  return {};
}

Result SessionActions::answer(Session& session, const Arguments& arguments) {
  const std::string& choice = arguments.text(0);
  const Question question = *session.question_;
  if (std::find(question.choices.begin(), question.choices.end(), choice) ==
      question.choices.end()) {
    return tl::unexpected(Text("refusal.answer", {choice}));
  }
  const std::optional<Command> command = session.afterAnswer_;
  session.question_.reset();
  if (choice == "cancel") {
    session.afterAnswer_.reset();
    session.output_ = {};
    return {};
  }
  if (question.kind == Question::Kind::kRecover) return answerRecovery(session, choice);
  if (question.kind == Question::Kind::kFramesExist) {
    session.afterAnswer_.reset();
    session.framesAgreed_ = session.framesFile();
    return writeFrames(session, arguments);
  }
  if (choice == "stop") {
    session.afterAnswer_.reset();
    if (session.frameJob_) session.frameJob_->cancel();
    session.finishFrames();
    return quit(session, arguments);
  }
  if (choice == "overwrite") return saveFile(session, session.path());
  if (choice == "save-as") {
    openWindow(session, "chooser-save");
    return {};
  }
  if (choice == "save") return save(session, arguments);
  session.afterAnswer_.reset();
  if (choice == "enlarge") return withCamera(session, command->name.c_str(), true);
  return proceed(session, *command);
}

void Session::offerRecovery(Flight flight, std::string path, const std::string& time) {
  const Text name = path.empty() ? Text("title.untitled") : Text();
  question_ = Question{Question::Kind::kRecover,
                       name.empty() ? Text("question.recover", {fileName(path), time})
                                    : Text("question.recover", {name, time}),
                       {"recover", "forget", "later"}};
  recoverable_ = Recoverable{std::move(flight), std::move(path)};
}

Result SessionActions::answerRecovery(Session& session, const std::string& choice) {
  const auto work = std::exchange(session.recoverable_, std::nullopt);
  session.recoveryAnswer_ = choice == "forget" ? RecoveryAnswer::kForget : RecoveryAnswer::kLater;
  if (choice != "recover" || !work) return {};
  session.recoveryAnswer_ = RecoveryAnswer::kRecover;
  session.recover(work->flight, work->path);
  session.say(MessageKind::kDone, Text("output.recovered"));
  return {};
}

Result SessionActions::afterSaving(Session& session) {
  if (!session.afterAnswer_) return {};
  const Command command = *session.afterAnswer_;
  session.afterAnswer_.reset();
  return proceed(session, command);
}

// --- Files ---

Result SessionActions::newFlight(Session& session, const Arguments&) {
  return askBeforeLoss(session, Command("new"));
}

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
  DiskFile file;
  auto flight = file.open(path);
  if (!flight) return failed(session, problemText("output.open-failed", path, flight.error()));
  session.file_ = std::move(file);
  session.reset(std::move(*flight));
  remember(session.recentFiles_, session.path());
  hideWindow(session, "chooser-open");
  session.say(MessageKind::kDone, Text("output.opened", {fileName(path)}));
  return {};
}

Result SessionActions::save(Session& session, const Arguments&) {
  if (session.path().empty()) {
    openWindow(session, "chooser-save");
    return {};
  }
  if (session.file_.compare() == DiskState::kChanged) {
    session.question_ = Question{Question::Kind::kChangedOnDisk,
                                 Text("question.changed-on-disk", {fileName(session.path())}),
                                 {"overwrite", "save-as", "cancel"}};
    return tl::unexpected(Text("refusal.changed-on-disk", {fileName(session.path())}));
  }
  return saveFile(session, session.path());
}

Result SessionActions::saveAs(Session& session, const Arguments& arguments) {
  if (!arguments.has(0)) {
    openWindow(session, "chooser-save");
    return {};
  }
  return saveFile(session, arguments.text(0));
}

Result SessionActions::saveFile(Session& session, const std::string& path) {
  namespace fs = std::filesystem;
  const std::string from = session.path();
  std::error_code error;
  const std::vector<SceneFile>& scenes = session.flight().scene;
  // Scenes are named from where the flight lies: anew where it goes elsewhere, or where it was read
  // with a whole path.
  const bool moves =
      from.empty() ||
      std::any_of(scenes.begin(), scenes.end(),
                  [](const SceneFile& scene) { return fs::path(scene.file).is_absolute(); }) ||
      fs::weakly_canonical(fs::absolute(path), error).parent_path() != fs::path(from).parent_path();
  Flight flight = session.flight();
  if (moves) moveScenePaths(flight, from, path);
  if (const auto problem = session.file_.save(flight, path)) {
    return failed(session, problemText("output.save-failed", path, {*problem}));
  }
  if (moves) {
    session.history_.rewrite([&](Flight& f) { moveScenePaths(f, from, path); });
    session.state_.flight = flight;
    session.state_.evaluation = session.state_.evaluation.updated(flight);
  }
  session.savedFlight_ = std::move(flight);
  session.modified_ = false;
  session.missingOnDisk_ = false;
  session.toldOfDisk_ = false;
  remember(session.recentFiles_, session.path());
  session.say(MessageKind::kDone, Text("output.saved", {fileName(path)}));
  const Result done = afterSaving(session);
  hideWindow(session, "chooser-save");
  return done;
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

Result SessionActions::quit(Session& session, const Arguments&) {
  if (session.frameJob_) {
    session.question_ = Question{
        Question::Kind::kWritingFrames, Text("question.writing-frames"), {"stop", "cancel"}};
    session.afterAnswer_ = Command("quit");
    return {};
  }
  return askBeforeLoss(session, Command("quit"));
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
