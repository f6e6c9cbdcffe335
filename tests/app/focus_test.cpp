// SPDX-License-Identifier: MIT
// The ring of the keyboard: which widgets take part and in which order; keys in menus.
#include "panels/focus.hpp"

#include <gtest/gtest.h>

#include "panels/menu_memory.hpp"

namespace vides {
namespace {

Widget widget(const std::string& id, WidgetKind kind, bool enabled = true) {
  Widget made;
  made.id = id;
  made.kind = kind;
  made.enabled = enabled;
  return made;
}

class Focus : public testing::Test {
 protected:
  Focus() {
    {
      const WidgetRegistry::Ring ring(registry_, "panel/one");
      registry_.add(widget("one/z_first", WidgetKind::kButton));
      registry_.add(widget("one/text", WidgetKind::kText));
      registry_.add(widget("one/field", WidgetKind::kField));
      registry_.add(widget("one/greyed", WidgetKind::kButton, false));
      registry_.add(widget("one/a_last", WidgetKind::kSlider));
    }
    registry_.add(widget("other/button", WidgetKind::kButton));
    const WidgetRegistry::Ring ring(registry_, "window");
    registry_.add(widget("window/ok", WidgetKind::kButton));
    registry_.add(widget("window/name", WidgetKind::kEntry));
    registry_.add(widget("window/close", WidgetKind::kButton));
  }
  std::string walked(int step) {
    focus_.walk(step);
    EXPECT_TRUE(focus_.settle(registry_));
    return focus_.widget();
  }
  WidgetRegistry registry_;
  KeyboardFocus focus_;
};

TEST_F(Focus, WalksRoundThePanelInItsOrder) {
  focus_.give("one/field");
  EXPECT_EQ(walked(1), "one/a_last");
  EXPECT_EQ(walked(1), "one/z_first");
  EXPECT_EQ(walked(1), "one/field");
  EXPECT_EQ(walked(-1), "one/z_first");
  EXPECT_EQ(walked(-1), "one/a_last");
  EXPECT_TRUE(focus_.operable(registry_));
  focus_.drop();
  EXPECT_FALSE(focus_.canWalk());
  focus_.walk(1);
  EXPECT_FALSE(focus_.settle(registry_));
}

// What was greyed meanwhile keeps it, so that Enter hits nothing else.
TEST_F(Focus, GreyedItKeepsIt) {
  focus_.give("one/greyed");
  EXPECT_FALSE(focus_.operable(registry_));
  EXPECT_FALSE(focus_.settle(registry_));
  EXPECT_EQ(focus_.widget(), "one/greyed");
  EXPECT_EQ(walked(1), "one/a_last");
  registry_.beginFrame();
  EXPECT_FALSE(focus_.settle(registry_));
  EXPECT_EQ(focus_.widget(), "");
}

TEST_F(Focus, AWindowBeginsAtWhatTakesItsText) {
  focus_.inWindow("window");
  EXPECT_EQ(walked(1), "window/close");
  focus_.drop();
  // From where it was.
  focus_.begin();
  focus_.inWindow("window");
  EXPECT_EQ(walked(1), "window/ok");
  EXPECT_EQ(walked(1), "window/name");
  EXPECT_FALSE(focus_.operable(registry_));
  // A window that opens takes it from a panel's button.
  focus_.give("one/z_first");
  focus_.settle(registry_);
  EXPECT_EQ(focus_.widget(), "");
}

TEST_F(Focus, EachIsAskedOnce) {
  focus_.give("one/z_first");
  focus_.operate();
  EXPECT_FALSE(focus_.takeOperation("one/field"));
  EXPECT_TRUE(focus_.takeOperation("one/z_first"));
  EXPECT_FALSE(focus_.takeOperation("one/z_first"));
  walked(1);
  EXPECT_TRUE(focus_.takeArrival("one/field"));
  EXPECT_FALSE(focus_.takeArrival("one/field"));
}

class MenuKeys : public testing::Test {
 protected:
  MenuKeys() {
    memory_.opened("menu/file");
    memory_.main.rows = {{"new", "Neu"},
                         {"open", "\u00d6ffnen\u2026"},
                         {"recent", "Zuletzt", true, true},
                         {"save", "Speichern"},
                         {"as", "Speichern unter", false}};
    memory_.main.marked = 0;
  }
  int pressed(KeyboardKey key) {
    memory_.key({key, true, false, {}});
    return memory_.main.marked;
  }
  MenuMemory memory_;
};

TEST_F(MenuKeys, ArrowsGoRoundWhatCanBeChosen) {
  EXPECT_EQ(pressed(KeyboardKey::kDown), 1);
  EXPECT_EQ(pressed(KeyboardKey::kEnd), 3);
  EXPECT_EQ(pressed(KeyboardKey::kDown), 0);
  EXPECT_EQ(pressed(KeyboardKey::kUp), 3);
  EXPECT_EQ(pressed(KeyboardKey::kHome), 0);
  pressed(KeyboardKey::kLeft);
  EXPECT_EQ(memory_.neighbour, -1);
  pressed(KeyboardKey::kRight);
  EXPECT_EQ(memory_.neighbour, 1);
  EXPECT_FALSE(memory_.operates);
  pressed(KeyboardKey::kEnter);
  EXPECT_TRUE(memory_.operates);
}

TEST_F(MenuKeys, LettersFindWhatBeginsWithThem) {
  EXPECT_EQ(pressed(KeyboardKey::kS), 3);
  memory_.typed("s");  // the same letter's text
  EXPECT_EQ(pressed(KeyboardKey::kS), 3);
  EXPECT_EQ(pressed(KeyboardKey::kZ), 2);
  EXPECT_EQ(pressed(KeyboardKey::kQ), 2);
  memory_.typed("\u00f6");
  EXPECT_EQ(memory_.main.marked, 1);
}

TEST_F(MenuKeys, EscapeClosesTheFurtherMenuFirst) {
  pressed(KeyboardKey::kZ);
  pressed(KeyboardKey::kRight);
  EXPECT_TRUE(memory_.operates);
  memory_.furtherOpen = true;
  pressed(KeyboardKey::kEscape);
  EXPECT_FALSE(memory_.furtherOpen);
  EXPECT_FALSE(memory_.closes);
  pressed(KeyboardKey::kEscape);
  EXPECT_TRUE(memory_.closes);
}

}  // namespace
}  // namespace vides
