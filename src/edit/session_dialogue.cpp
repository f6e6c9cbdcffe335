// SPDX-License-Identifier: MIT
// Questions, their answers, and what goes on after them.
#include <algorithm>
#include <utility>

#include "edit/folder.hpp"
#include "edit/frame_job.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

using Result = SessionActions::Result;
using Kind = Question::Kind;

TextPart nameOf(const std::string& path) {
  return path.empty() ? TextPart(Text("title.untitled")) : TextPart(fileName(path));
}

}  // namespace

const std::optional<Question>& Session::question() const {
  static const std::optional<Question> kNone;
  return dialogue_ ? dialogue_->question : kNone;
}

Result SessionActions::answer(Session& session, const Arguments& arguments) {
  const std::string& choice = arguments.text(0);
  const std::vector<std::string>& choices = session.question()->choices;
  if (std::find(choices.begin(), choices.end(), choice) == choices.end()) {
    return tl::unexpected(Text("refusal.answer", {choice}));
  }
  const Dialogue dialogue = *std::exchange(session.dialogue_, std::nullopt);
  if (choice != "cancel") return dialogue.answered(session, choice);
  session.output_ = {};
  return {};
}

// --- Before the flight goes ---

Result SessionActions::askBeforeLoss(Session& session, const Command& command) {
  if (!session.modified() && !session.windowChanged()) return proceed(session, command);
  const auto answered = [command](Session& s, const std::string& choice) -> Result {
    return choice == "save" ? saveThen(s, command) : proceed(s, command);
  };
  session.dialogue_ = Dialogue{Question{Kind::kUnsaved,
                                        Text("question.unsaved", {nameOf(session.path())}),
                                        {"save", "discard", "cancel"}},
                               answered,
                               {}};
  return {};
}

Result SessionActions::proceed(Session& session, const Command& command) {
  session.dialogue_.reset();
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

Result SessionActions::newFlight(Session& session, const Arguments&) {
  return askBeforeLoss(session, Command("new"));
}

Result SessionActions::quit(Session& session, const Arguments&) {
  if (!session.frameJob_) return askBeforeLoss(session, Command("quit"));
  const auto stop = [](Session& s, const std::string&) -> Result {
    if (s.frameJob_) s.frameJob_->cancel();
    s.finishFrames();
    return askBeforeLoss(s, Command("quit"));
  };
  session.dialogue_ =
      Dialogue{Question{Kind::kWritingFrames, Text("question.writing-frames"), {"stop", "cancel"}},
               stop,
               {}};
  return {};
}

// --- Saving, and what follows it ---

Result SessionActions::saveThen(Session& session, const std::optional<Command>& then) {
  if (session.path().empty()) {
    chooseNameThen(session, then);
    return {};
  }
  if (session.file_.compare() != DiskState::kChanged) {
    return saveFileThen(session, session.path(), then);
  }
  const auto answered = [then](Session& s, const std::string& choice) -> Result {
    if (choice == "overwrite") return saveFileThen(s, s.path(), then);
    chooseNameThen(s, then);
    return {};
  };
  session.dialogue_ =
      Dialogue{Question{Kind::kChangedOnDisk,
                        Text("question.changed-on-disk", {fileName(session.path())}),
                        {"overwrite", "save-as", "cancel"}},
               answered,
               {}};
  return tl::unexpected(Text("refusal.changed-on-disk", {fileName(session.path())}));
}

// What fails after the saving is told, but the saving is done.
Result SessionActions::saveFileThen(Session& session, const std::string& path,
                                    const std::optional<Command>& then) {
  if (auto saved = saveFile(session, path); !saved) return saved;
  if (then) static_cast<void>(proceed(session, *then));
  return {};
}

void SessionActions::chooseNameThen(Session& session, const std::optional<Command>& then) {
  openWindow(session, "chooser-save");
  if (then) session.dialogue_ = Dialogue{{}, {}, then};
}

// Ends the wait: where the saving fails, nothing follows a later one.
std::optional<Command> SessionActions::takeAfterSaving(Session& session) {
  if (!session.dialogue_) return std::nullopt;
  return std::exchange(session.dialogue_, std::nullopt)->afterSaving;
}

// --- Failures ---

void Session::abandon(Text why) {
  if (inDrag()) cancel();
  dialogue_.reset();
  say(MessageKind::kError, std::move(why));
}

// --- Recovery ---

void Session::offerRecovery(Flight flight, std::string path, const std::string& time) {
  Question question{Kind::kRecover,
                    Text("question.recover", {nameOf(path), time}),
                    {"recover", "forget", "later"}};
  const auto answered = [flight = std::move(flight), path = std::move(path)](
                            Session& s, const std::string& choice) -> Result {
    if (choice != "recover") {
      s.recoveryAnswer_ = choice == "forget" ? RecoveryAnswer::kForget : RecoveryAnswer::kLater;
      return {};
    }
    s.recover(flight, path);
    s.recoveryAnswer_ = RecoveryAnswer::kRecover;
    s.say(MessageKind::kDone, Text("output.recovered"));
    return {};
  };
  dialogue_ = Dialogue{std::move(question), answered, {}};
}

}  // namespace vides
