// SPDX-License-Identifier: MIT
// What the user is asked, and what goes on after the answer: one value, so that neither can be left
// behind without the other.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "edit/command.hpp"
#include "edit/text.hpp"

namespace vides {

class Session;

// What must be answered before it goes on: `answer CHOICE`. The last choice is the one that changes
// nothing, and what Escape answers.
struct Question {
  enum class Kind {
    kUnsaved,        // choices save, discard, cancel
    kChangedOnDisk,  // choices overwrite, save-as, cancel
    kOutsideCube,    // choices enlarge, cancel
    kRecover,        // choices recover, forget, later
    kFramesExist,    // choices overwrite, cancel
    kWritingFrames,  // choices stop, cancel; goes on by itself when they are written
    kSceneAgain,     // choices again, cancel
    kScenesFound,    // choices replace, cancel
  };
  Kind kind = Kind::kUnsaved;
  Text text;
  std::vector<std::string> choices;
};

// There is at most one. It ends with its answer, and with whatever fails on the way from there:
// nothing goes on later that nobody thinks of any more.
struct Dialogue {
  using Continuation =
      std::function<tl::expected<void, Text>(Session& session, const std::string& choice)>;

  // Nothing while the chooser for saving is open, which `afterSaving` waits for.
  std::optional<Question> question;
  // For every choice but "cancel". The dialogue has ended by then; it may begin another one.
  Continuation answered;
  std::optional<Command> afterSaving;
};

}  // namespace vides
