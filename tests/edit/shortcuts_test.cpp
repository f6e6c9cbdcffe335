// SPDX-License-Identifier: MIT
// The table of shortcuts against the specification's, and its commands against theirs.
#include "edit/shortcuts.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace vides {
namespace {

TEST(Shortcuts, AsSpecified) {
  // 5-editor, "Shortcuts".
  const std::map<std::string, std::string> wanted = {{"ctrl+n", "new"},
                                                     {"ctrl+o", "open"},
                                                     {"ctrl+s", "save"},
                                                     {"ctrl+shift+s", "save-as"},
                                                     {"ctrl+q", "quit"},
                                                     {"ctrl+z", "undo"},
                                                     {"ctrl+shift+z", "redo"},
                                                     {"ctrl+y", "redo"},
                                                     {"ctrl+x", "cut"},
                                                     {"ctrl+c", "copy"},
                                                     {"ctrl+v", "paste"},
                                                     {"ctrl+d", "duplicate-keys"},
                                                     {"ctrl+a", "select-all"},
                                                     {"delete", "delete-keys"},
                                                     {"i", "insert-at-playhead"},
                                                     {"shift+i", "show-window insert-keys"},
                                                     {"e", "append-key"},
                                                     {"page_up", "previous-key"},
                                                     {"page_down", "next-key"},
                                                     {"ctrl+page_up", "previous-orientation"},
                                                     {"ctrl+page_down", "next-orientation"},
                                                     {"o", "insert-orientation"},
                                                     {"shift+o", "delete-orientation"},
                                                     {"u", "use-view"},
                                                     {"k", "new-key-from-view"},
                                                     {"tab", "swap-views"},
                                                     {"1", "view front"},
                                                     {"3", "view side"},
                                                     {"7", "view top"},
                                                     {"2", "view iso"},
                                                     {"9", "view-opposite"},
                                                     {"0", "view-camera"},
                                                     {"5", "perspective"},
                                                     {"f", "frame-selection"},
                                                     {"home", "frame-all"},
                                                     {"space", "play"},
                                                     {"left", "previous-frame"},
                                                     {"right", "next-frame"},
                                                     {"shift+left", "go-to-previous-orientation"},
                                                     {"shift+right", "go-to-next-orientation"},
                                                     {"ctrl+home", "first-frame"},
                                                     {"ctrl+end", "last-frame"},
                                                     {"l", "loop"},
                                                     {"escape", "escape"},
                                                     {"f1", "show-window shortcuts"},
                                                     {"f11", "full-screen"}};
  std::map<std::string, std::string> found;
  for (const Shortcut& shortcut : shortcutTable()) {
    EXPECT_TRUE(found.emplace(scriptName(shortcut), format(shortcut.command)).second);
    EXPECT_TRUE(checkArguments(shortcut.command)) << format(shortcut.command);
  }
  EXPECT_EQ(found, wanted);
}

TEST(Shortcuts, FoundByKeyAndModifiers) {
  const Modifiers none, control{false, true, false, false}, alt{false, false, true, false};
  ASSERT_NE(shortcutFor(KeyboardKey::kZ, control), nullptr);
  EXPECT_EQ(shortcutFor(KeyboardKey::kZ, control)->command, Command("undo"));
  EXPECT_EQ(shortcutFor(KeyboardKey::kZ, none), nullptr);
  EXPECT_EQ(shortcutFor(KeyboardKey::kI, alt), nullptr);
  // Digits also from the number pad.
  ASSERT_NE(shortcutFor(KeyboardKey::kPad7, none), nullptr);
  EXPECT_EQ(shortcutFor(KeyboardKey::kPad7, none)->command, Command("view", "top"));
}

TEST(Shortcuts, OnlyStepsRepeat) {
  const Modifiers none;
  EXPECT_NE(shortcutFor(KeyboardKey::kRight, none, true), nullptr);
  EXPECT_EQ(shortcutFor(KeyboardKey::kDelete, none, true), nullptr);
  EXPECT_EQ(shortcutFor(KeyboardKey::kSpace, none, true), nullptr);
}

TEST(Shortcuts, InWords) {
  const Texts english(Language::kEnglish), german(Language::kGerman);
  EXPECT_EQ(shown(*shortcutOf(Command("redo")), english), "Ctrl+Shift+Z");
  EXPECT_EQ(shown(*shortcutOf(Command("redo")), german), "Strg+Umschalt+Z");
  EXPECT_EQ(shown(*shortcutOf(Command("view", "iso")), english), "2");
  EXPECT_EQ(english.tell(titleOf(Command("view", "iso"), english)), "Iso");
  EXPECT_EQ(shortcutOf(Command("set-zoom", 3)), nullptr);
}

}  // namespace
}  // namespace vides
