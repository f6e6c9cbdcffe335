// SPDX-License-Identifier: MIT
// The table of shortcuts (5-editor).
#include "edit/shortcuts.hpp"

#include <algorithm>

namespace vides {
namespace {

using K = KeyboardKey;

constexpr Modifiers kPlain{};
constexpr Modifiers kShift{true, false, false, false};
constexpr Modifiers kCtrl{false, true, false, false};
constexpr Modifiers kCtrlShift{true, true, false, false};

std::vector<Shortcut> makeTable() {
  std::vector<Shortcut> table;
  const auto add = [&](const char* group, const Modifiers& modifiers, K key, Command command,
                       bool repeats = false) {
    table.push_back({key, modifiers, std::move(command), group, repeats});
  };
  add("file", kCtrl, K::kN, Command("new"));
  add("file", kCtrl, K::kO, Command("open"));
  add("file", kCtrl, K::kS, Command("save"));
  add("file", kCtrlShift, K::kS, Command("save-as"));
  add("file", kCtrl, K::kQ, Command("quit"));

  add("edit", kCtrl, K::kZ, Command("undo"), true);
  add("edit", kCtrlShift, K::kZ, Command("redo"), true);
  add("edit", kCtrl, K::kY, Command("redo"), true);
  add("edit", kCtrl, K::kX, Command("cut"));
  add("edit", kCtrl, K::kC, Command("copy"));
  add("edit", kCtrl, K::kV, Command("paste"));
  add("edit", kCtrl, K::kD, Command("duplicate-keys"));
  add("edit", kCtrl, K::kA, Command("select-all"));
  add("edit", kPlain, K::kDelete, Command("delete-keys"));

  add("keys", kPlain, K::kI, Command("insert-at-playhead"));
  add("keys", kShift, K::kI, Command("show-window", "insert-keys"));
  add("keys", kPlain, K::kE, Command("append-key"));
  add("keys", kPlain, K::kPageUp, Command("previous-key"), true);
  add("keys", kPlain, K::kPageDown, Command("next-key"), true);
  add("keys", kCtrl, K::kPageUp, Command("previous-orientation"), true);
  add("keys", kCtrl, K::kPageDown, Command("next-orientation"), true);
  add("keys", kPlain, K::kO, Command("insert-orientation"));
  add("keys", kShift, K::kO, Command("delete-orientation"));

  add("camera", kPlain, K::kU, Command("use-view"));
  add("camera", kPlain, K::kK, Command("new-key-from-view"));
  add("camera", kPlain, K::kTab, Command("swap-views"));

  add("view", kPlain, K::k1, Command("view", "front"));
  add("view", kPlain, K::k3, Command("view", "side"));
  add("view", kPlain, K::k7, Command("view", "top"));
  add("view", kPlain, K::k2, Command("view", "iso"));
  add("view", kPlain, K::k9, Command("view-opposite"));
  add("view", kPlain, K::k0, Command("view-camera"));
  add("view", kPlain, K::k5, Command("perspective"));
  add("view", kPlain, K::kF, Command("frame-selection"));
  add("view", kPlain, K::kHome, Command("frame-all"));

  add("playhead", kPlain, K::kSpace, Command("play"));
  add("playhead", kPlain, K::kLeft, Command("previous-frame"), true);
  add("playhead", kPlain, K::kRight, Command("next-frame"), true);
  add("playhead", kShift, K::kLeft, Command("go-to-previous-orientation"), true);
  add("playhead", kShift, K::kRight, Command("go-to-next-orientation"), true);
  add("playhead", kCtrl, K::kHome, Command("first-frame"));
  add("playhead", kCtrl, K::kEnd, Command("last-frame"));
  add("playhead", kPlain, K::kL, Command("loop"));

  add("window", kPlain, K::kEscape, Command("escape"));
  add("window", kPlain, K::kF1, Command("show-window", "shortcuts"));
  add("window", kPlain, K::kF11, Command("full-screen"));
  return table;
}

// The digit of the row for one of the number pad.
K withoutPad(K key) {
  const std::optional<int> digit = digitOf(key);
  return digit ? static_cast<K>(static_cast<int>(K::k0) + *digit) : key;
}

// The key's name as it is printed on it.
std::string shownKey(K key, const Texts& texts) {
  const std::string name(keyName(key));
  if (const std::string_view words = texts.words("key." + name); !words.empty()) {
    return std::string(words);
  }
  std::string capital = name;
  if (!capital.empty() && capital[0] >= 'a' && capital[0] <= 'z') {
    capital[0] = static_cast<char>(capital[0] - 'a' + 'A');
  }
  return capital;
}

}  // namespace

const std::vector<Shortcut>& shortcutTable() {
  static const std::vector<Shortcut> table = makeTable();
  return table;
}

const Shortcut* shortcutFor(KeyboardKey key, const Modifiers& modifiers, bool repeated) {
  const K plain = withoutPad(key);
  for (const Shortcut& shortcut : shortcutTable()) {
    if (shortcut.key == plain && shortcut.modifiers == modifiers) {
      return repeated && !shortcut.repeats ? nullptr : &shortcut;
    }
  }
  return nullptr;
}

const Shortcut* shortcutOf(const Command& command) {
  const std::vector<Shortcut>& table = shortcutTable();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const Shortcut& s) { return s.command == command; });
  return found == table.end() ? nullptr : &*found;
}

std::string shown(const Shortcut& shortcut, const Texts& texts) {
  std::string text;
  const auto add = [&](bool held, std::string_view key) {
    if (held) text += std::string(texts.words(key)) + "+";
  };
  add(shortcut.modifiers.control, "key.ctrl");
  add(shortcut.modifiers.alt, "key.alt");
  add(shortcut.modifiers.shift, "key.shift");
  add(shortcut.modifiers.super, "key.super");
  return text + shownKey(shortcut.key, texts);
}

std::string scriptName(const Shortcut& shortcut) {
  std::string text;
  if (shortcut.modifiers.control) text += "ctrl+";
  if (shortcut.modifiers.alt) text += "alt+";
  if (shortcut.modifiers.shift) text += "shift+";
  if (shortcut.modifiers.super) text += "super+";
  return text + std::string(keyName(shortcut.key));
}

Text titleOf(const Command& command, const Texts& texts) {
  if (!command.arguments.empty()) {
    if (const auto* argument = std::get_if<std::string>(&command.arguments.front())) {
      std::string key = "command." + command.name + "." + *argument;
      if (!texts.words(key).empty()) return Text(std::move(key));
    }
  }
  return Text("command." + command.name);
}

}  // namespace vides
