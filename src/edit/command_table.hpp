// SPDX-License-Identifier: MIT
// The one table of commands: menus, shortcuts, scripts and tests are made from it.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "edit/command.hpp"
#include "edit/edit_state.hpp"
#include "edit/text.hpp"

namespace vides {

class Session;

enum class ArgumentKind {
  kNumber,  // finite, at most 1e15 in size
  kIndex,   // whole, 0 or more
  kValue,   // finite, a sum or a text that starts from the number that is there (edit/sum.hpp)
  kText,    // any
  kChoice,  // one of `choices`
};

struct ArgumentSpecification {
  std::string name;
  ArgumentKind kind = ArgumentKind::kNumber;
  std::vector<std::string> choices;
  bool optional = false;  // this one and all that follow may be left out together
  bool repeated = false;  // the last one, as often as wanted
};

// Changes the flight: undoable, applied by the session.
using EditFunction = EditResult (*)(const EditState&, const Arguments&);
// Changes the session besides its flight, or asks it for an edit.
using ActFunction = tl::expected<void, Text> (*)(Session&, const Arguments&);
using AvailableFunction = bool (*)(const Session&);

struct CommandSpecification {
  std::string name;
  std::vector<ArgumentSpecification> arguments;
  std::variant<EditFunction, ActFunction> run;
  // An act that must not run within a gesture or before a question is answered; edits never do.
  bool exclusive = false;
  AvailableFunction available = nullptr;  // null: always; else menus grey it, and it is refused
  const char* why = nullptr;              // with this text where not with "not possible now"

  // Key into the translation table: "command.insert-key".
  std::string titleKey() const { return "command." + name; }
  bool edits() const { return std::holds_alternative<EditFunction>(run); }
};

// In the order of the menus.
const std::vector<CommandSpecification>& commandTable();
// Null where there is no such command.
const CommandSpecification* findCommand(std::string_view name);
// "move-key KEY X Y Z", for help and messages.
std::string usage(const CommandSpecification& command);

}  // namespace vides
