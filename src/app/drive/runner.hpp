// SPDX-License-Identifier: MIT
// Runs scripts of `vides drive` on a player (4-command-line, "`vides drive` scripts").
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/drive/player.hpp"
#include "app/drive/script.hpp"

namespace vides {

class ScriptRunner {
 public:
  // What `where` and `print` say goes to `print`, what goes wrong in the session to `tell` (see
  // SessionEcho), a line each, without the line's end.
  ScriptRunner(
      Player& player, std::function<void(const std::string&)> print,
      std::function<void(const std::string&)> tell = [](const std::string&) {})
      : player_(player), print_(std::move(print)), tell_(std::move(tell)) {}

  // Runs the script. Error: `NAME:LINE: what was expected and found` of the first line that fails.
  tl::expected<void, std::string> run(std::string_view name, std::string_view script);

  // Names of all commands, for help and tests.
  static std::vector<std::string_view> commandNames();

 private:
  using Result = tl::expected<void, std::string>;
  using Words = std::span<const ScriptWord>;
  using Handler = Result (ScriptRunner::*)(Words, const ScriptLine&);
  struct Command {
    std::string_view name;
    std::size_t least;
    std::size_t most;
    std::string_view usage;
    Handler run;
  };
  static std::span<const Command> commands();

  Result frame(Words, const ScriptLine&);
  Result move(Words, const ScriptLine&);
  Result press(Words, const ScriptLine&);
  Result release(Words, const ScriptLine&);
  Result wheel(Words, const ScriptLine&);
  Result drag(Words, const ScriptLine&);
  Result key(Words, const ScriptLine&);
  Result down(Words, const ScriptLine&);
  Result up(Words, const ScriptLine&);
  Result text(Words, const ScriptLine&);
  Result click(Words, const ScriptLine&);
  Result set(Words, const ScriptLine&);
  Result perform(Words, const ScriptLine&);
  Result drop(Words, const ScriptLine&);
  Result where(Words, const ScriptLine&);
  Result point(Words, const ScriptLine&);
  Result view(Words, const ScriptLine&);
  Result perspective(Words, const ScriptLine&);
  Result frameAt(Words, const ScriptLine&);
  Result print(Words, const ScriptLine&);
  Result expect(Words, const ScriptLine&);
  Result expectSetup(Words, const ScriptLine&);
  Result expectOutput(Words, const ScriptLine&);
  Result expectWidget(Words, const ScriptLine&);
  Result expectTitle(Words, const ScriptLine&);
  Result save(Words, const ScriptLine&);
  Result open(Words, const ScriptLine&);
  Result undo(Words, const ScriptLine&);
  Result redo(Words, const ScriptLine&);
  Result screenshot(Words, const ScriptLine&);

  Result line(const ScriptLine& line);
  Result lineOrFailure(const ScriptLine& line);
  // A session's command that must succeed, then a display frame.
  Result must(const vides::Command& command, std::string_view what);
  tl::expected<std::vector<double>, std::string> numbers(Words words) const;
  Result expectIn(const std::string& document, Words words) const;
  tl::expected<std::size_t, std::string> index(const ScriptWord& word) const;
  tl::expected<Vec2, std::string> place(Words words) const;
  tl::expected<Vec2, std::string> placeInWidget(Words words) const;

  Player& player_;
  std::function<void(const std::string&)> print_, tell_;
  ScriptPoints points_;
};

}  // namespace vides
