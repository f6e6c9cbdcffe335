// SPDX-License-Identifier: MIT
// Runs scripts of `vides drive`: the pointer, the keyboard, widgets and commands.
#include "app/drive/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <optional>

#include "app/drive/session_echo.hpp"
#include "edit/command.hpp"

namespace vides {
namespace {

std::optional<PointerButton> buttonOf(std::string_view name) {
  if (name == "left") return PointerButton::kLeft;
  if (name == "middle") return PointerButton::kMiddle;
  if (name == "right") return PointerButton::kRight;
  return std::nullopt;
}

tl::expected<PointerButton, std::string> button(const ScriptWord& word) {
  if (const auto found = buttonOf(word.text)) return *found;
  return Failure(fmt::format("expected left, middle or right, found '{}'", word.text));
}

struct Chord {
  KeyboardKey key = KeyboardKey::kUnknown;
  Modifiers modifiers;
};

// "ctrl+shift+z": the last part is the key; "+" itself is called plus.
tl::expected<Chord, std::string> chord(std::string_view word) {
  Chord result;
  const auto unknown = [](std::string_view name) {
    return Failure(fmt::format("expected a key's name, found '{}'", name));
  };
  for (;;) {
    const std::size_t plus = word.find('+');
    const std::string_view name = word.substr(0, plus);
    const auto key = keyFromName(name);
    if (!key) return unknown(name);
    if (plus == std::string_view::npos) {
      result.key = *key;
      return result;
    }
    const Modifiers one = modifierOf(*key);
    if (one == Modifiers{}) return unknown(word);
    result.modifiers.shift |= one.shift;
    result.modifiers.control |= one.control;
    result.modifiers.alt |= one.alt;
    result.modifiers.super |= one.super;
    word.remove_prefix(plus + 1);
  }
}

}  // namespace

std::span<const ScriptRunner::Command> ScriptRunner::commands() {
  using R = ScriptRunner;
  static const std::array kCommands = {
      Command{"frame", 0, 1, "frame [N]", &R::frame},
      Command{"move", 2, 2, "move X Y", &R::move},
      Command{"press", 1, 1, "press BUTTON", &R::press},
      Command{"release", 1, 1, "release BUTTON", &R::release},
      Command{"wheel", 1, 1, "wheel DY", &R::wheel},
      Command{"drag", 5, 6, "drag BUTTON X1 Y1 X2 Y2 [STEPS]", &R::drag},
      Command{"key", 1, 1, "key NAME", &R::key},
      Command{"down", 1, 1, "down NAME", &R::down},
      Command{"up", 1, 1, "up NAME", &R::up},
      Command{"text", 1, 1, "text \"...\"", &R::text},
      Command{"click", 1, 1, "click ID", &R::click},
      Command{"set", 2, 2, "set ID VALUE", &R::set},
      Command{"do", 1, 1000, "do COMMAND [ARGS]", &R::perform},
      Command{"drop", 1, 1, "drop FILE", &R::drop},
      Command{"where", 2, 4, "where key I | aim I J | up I J | curve I U | widget ID [U V]",
              &R::where},
      Command{"point", 4, 6, "point $NAME where ...", &R::point},
      Command{"view", 1, 3, "view VIEW | view TURN TILT SIZE", &R::view},
      Command{"perspective", 1, 1, "perspective on|off", &R::perspective},
      Command{"frame_at", 1, 1, "frame_at N", &R::frameAt},
      Command{"print", 1, 1, "print POINTER", &R::print},
      Command{"expect", 2, 3, "expect POINTER VALUE [TOL]", &R::expect},
      Command{"expect_setup", 2, 3, "expect_setup POINTER VALUE [TOL]", &R::expectSetup},
      Command{"expect_output", 1, 1, "expect_output \"TEXT\"", &R::expectOutput},
      Command{"expect_widget", 2, 2, "expect_widget ID \"VALUE\"", &R::expectWidget},
      Command{"expect_title", 1, 1, "expect_title \"TEXT\"", &R::expectTitle},
      Command{"save", 1, 1, "save FILE", &R::save},
      Command{"open", 1, 1, "open FILE", &R::open},
      Command{"undo", 0, 0, "undo", &R::undo},
      Command{"redo", 0, 0, "redo", &R::redo},
      Command{"screenshot", 1, 1, "screenshot FILE", &R::screenshot},
  };
  return kCommands;
}

std::vector<std::string_view> ScriptRunner::commandNames() {
  std::vector<std::string_view> names;
  for (const Command& command : commands()) names.push_back(command.name);
  return names;
}

tl::expected<void, std::string> ScriptRunner::run(std::string_view name, std::string_view script) {
  const auto lines = readScript(script);
  if (!lines) return Failure(fmt::format("{}:{}", name, lines.error()));
  SessionEcho echo(player_, name, tell_);
  player_.frame();
  for (const ScriptLine& each : *lines) {
    auto done = lineOrFailure(each);
    echo.afterLine(each.number, done ? std::string_view() : done.error());
    if (!done) {
      return Failure(fmt::format("{}:{}: {}", name, each.number, done.error()));
    }
  }
  return {};
}

// Whatever a line does to the editor, it is that line that failed.
ScriptRunner::Result ScriptRunner::lineOrFailure(const ScriptLine& each) {
  try {
    return line(each);
  } catch (const std::exception& error) {
    return Failure(fmt::format("expected the editor to go on, found: {}", error.what()));
  }
}

ScriptRunner::Result ScriptRunner::line(const ScriptLine& line) {
  const std::string& name = line.words.front().text;
  const auto all = commands();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Command& command) { return command.name == name; });
  if (found == all.end()) return Failure(fmt::format("expected a command, found '{}'", name));
  const Words words = Words(line.words).subspan(1);
  if (words.size() < found->least || words.size() > found->most) {
    return Failure(fmt::format("expected {}, found {} arguments", found->usage, words.size()));
  }
  return (this->*found->run)(words, line);
}

tl::expected<std::vector<double>, std::string> ScriptRunner::numbers(Words words) const {
  std::vector<double> result;
  for (const ScriptWord& word : words) {
    const auto value = scriptNumber(word.text, points_);
    if (!value) return Failure(value.error());
    result.push_back(*value);
  }
  return result;
}

tl::expected<std::size_t, std::string> ScriptRunner::index(const ScriptWord& word) const {
  const auto value = scriptNumber(word.text, points_);
  if (!value) return Failure(value.error());
  if (*value < 0.0 || *value != std::floor(*value) || *value > 1e9) {
    return Failure(fmt::format("expected a whole number from 0, found '{}'", word.text));
  }
  return static_cast<std::size_t>(*value);
}

ScriptRunner::Result ScriptRunner::frame(Words words, const ScriptLine&) {
  std::size_t count = 1;
  if (!words.empty()) {
    const auto given = index(words[0]);
    if (!given) return Failure(given.error());
    count = *given;
  }
  for (std::size_t i = 0; i < count; ++i) player_.frame();
  return {};
}

ScriptRunner::Result ScriptRunner::move(Words words, const ScriptLine&) {
  const auto at = numbers(words);
  if (!at) return Failure(at.error());
  player_.move((*at)[0], (*at)[1]);
  return {};
}

ScriptRunner::Result ScriptRunner::press(Words words, const ScriptLine&) {
  const auto which = button(words[0]);
  if (!which) return Failure(which.error());
  player_.button(*which, true);
  return {};
}

ScriptRunner::Result ScriptRunner::release(Words words, const ScriptLine&) {
  const auto which = button(words[0]);
  if (!which) return Failure(which.error());
  player_.button(*which, false);
  return {};
}

ScriptRunner::Result ScriptRunner::wheel(Words words, const ScriptLine&) {
  const auto steps = numbers(words);
  if (!steps) return Failure(steps.error());
  player_.event(WheelTurned{0.0, (*steps)[0]});
  return {};
}

ScriptRunner::Result ScriptRunner::drag(Words words, const ScriptLine&) {
  const auto which = button(words[0]);
  if (!which) return Failure(which.error());
  const auto way = numbers(words.subspan(1, 4));
  if (!way) return Failure(way.error());
  std::size_t steps = 10;
  if (words.size() > 5) {
    const auto given = index(words[5]);
    if (!given) return Failure(given.error());
    steps = std::max<std::size_t>(1, *given);
  }
  const Vec2 from((*way)[0], (*way)[1]);
  const Vec2 to((*way)[2], (*way)[3]);
  player_.move(from.x, from.y);
  player_.button(*which, true);
  for (std::size_t i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps);
    const Vec2 at = i == steps ? to : from + share * (to - from);
    player_.move(at.x, at.y);
  }
  player_.button(*which, false);
  return {};
}

ScriptRunner::Result ScriptRunner::key(Words words, const ScriptLine&) {
  const auto keys = chord(words[0].text);
  if (!keys) return Failure(keys.error());
  player_.tap(keys->key, keys->modifiers);
  return {};
}

ScriptRunner::Result ScriptRunner::down(Words words, const ScriptLine&) {
  const auto keys = chord(words[0].text);
  if (!keys || keys->modifiers != Modifiers{}) {
    return Failure(fmt::format("expected a single key, found '{}'", words[0].text));
  }
  player_.key(keys->key, true);
  return {};
}

ScriptRunner::Result ScriptRunner::up(Words words, const ScriptLine&) {
  const auto keys = chord(words[0].text);
  if (!keys || keys->modifiers != Modifiers{}) {
    return Failure(fmt::format("expected a single key, found '{}'", words[0].text));
  }
  player_.key(keys->key, false);
  return {};
}

ScriptRunner::Result ScriptRunner::text(Words words, const ScriptLine&) {
  player_.type(words[0].text);
  return {};
}

ScriptRunner::Result ScriptRunner::click(Words words, const ScriptLine&) {
  return player_.clickWidget(words[0].text);
}

ScriptRunner::Result ScriptRunner::set(Words words, const ScriptLine&) {
  std::string value = words[1].text;
  // Points may stand for typed numbers, too.
  if (!words[1].quoted && value.starts_with('$')) {
    const auto number = scriptNumber(value, points_);
    if (!number) return Failure(number.error());
    value = fmt::format("{}", *number);
  }
  return player_.setWidget(words[0].text, value);
}

ScriptRunner::Result ScriptRunner::perform(Words, const ScriptLine& line) {
  const auto command = parseCommand(line.rest);
  if (!command) return Failure(player_.editor().words(command.error()));
  player_.perform(*command);
  return {};
}

ScriptRunner::Result ScriptRunner::drop(Words words, const ScriptLine&) {
  player_.event(FilesDropped{{words[0].text}});
  return {};
}

}  // namespace vides
