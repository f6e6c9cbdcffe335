// SPDX-License-Identifier: MIT
// Commands by their text names: what menus, shortcuts, scripts and tests have in common.
//
// `move-key 2 0.1 0.2 0.3` is a name and its arguments, separated by blanks; text with blanks
// stands in double quotes, in which \" and \\ are the characters themselves. Keys, orientations,
// presets and frames count from 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "edit/text.hpp"

namespace vides {

using Argument = std::variant<double, std::string>;

struct Command {
  std::string name;
  std::vector<Argument> arguments;

  Command() = default;
  template <class... Values>
  explicit Command(std::string commandName, const Values&... values)
      : name(std::move(commandName)) {
    (add(values), ...);
  }
  void add(double number) { arguments.emplace_back(number); }
  void add(int number) { arguments.emplace_back(static_cast<double>(number)); }
  void add(std::size_t number) { arguments.emplace_back(static_cast<double>(number)); }
  void add(std::int64_t number) { arguments.emplace_back(static_cast<double>(number)); }
  void add(std::string text) { arguments.emplace_back(std::move(text)); }
  void add(Argument argument) { arguments.push_back(std::move(argument)); }
  void add(const char* text) { arguments.emplace_back(std::string(text)); }
  void add(const Vec3& point) {
    for (int i = 0; i < 3; ++i) add(point[i]);
  }
  bool operator==(const Command&) const = default;
};

// The command that a line stands for, its arguments typed by the table of commands. An unknown
// name, a wrong number of arguments or an argument of the wrong type is refused with a text that
// tells what was expected.
tl::expected<Command, Text> parseCommand(std::string_view line);

// The line that parseCommand() reads as this command; numbers in their shortest exact form.
std::string format(const Command& command);

// Checks number and types of the arguments against the table.
tl::expected<void, Text> checkArguments(const Command& command);

// A finite number, with a decimal point or a decimal comma, with or without a sign; nothing for
// other text. In every locale.
std::optional<double> parseNumber(std::string_view text);

}  // namespace vides
