// SPDX-License-Identifier: MIT
// Keys have names that lead back to them; characters become UTF-8.
#include "input/key.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "input/input_event.hpp"

namespace vides {
namespace {

TEST(KeyName, LeadsBackToTheKey) {
  std::set<std::string_view> names;
  for (int i = 1; i < kKeyCount; ++i) {
    const auto key = static_cast<KeyboardKey>(i);
    EXPECT_EQ(keyFromName(keyName(key)), key) << keyName(key);
    names.insert(keyName(key));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kKeyCount) - 1);
}

TEST(KeyName, IsWhatScriptsWrite) {
  EXPECT_EQ(keyName(KeyboardKey::kZ), "z");
  EXPECT_EQ(keyName(KeyboardKey::k7), "7");
  EXPECT_EQ(keyName(KeyboardKey::kPad7), "pad_7");
  EXPECT_EQ(keyName(KeyboardKey::kF12), "f12");
  EXPECT_EQ(keyName(KeyboardKey::kPageDown), "page_down");
  EXPECT_EQ(keyName(KeyboardKey::kGraveAccent), "grave_accent");
  EXPECT_EQ(keyName(KeyboardKey::kRightSuper), "right_super");
  EXPECT_EQ(keyFromName("Escape"), KeyboardKey::kEscape);
  EXPECT_EQ(keyFromName("PAGE_UP"), KeyboardKey::kPageUp);
  EXPECT_EQ(keyFromName("ctrl"), KeyboardKey::kLeftControl);
  EXPECT_EQ(keyFromName("return"), KeyboardKey::kEnter);
  EXPECT_EQ(keyFromName("unknown"), std::nullopt);
  EXPECT_EQ(keyFromName(""), std::nullopt);
  EXPECT_EQ(keyFromName("zz"), std::nullopt);
}

TEST(KeyThatPrints, LettersDigitsSigns) {
  EXPECT_EQ(keyThatPrints("z"), KeyboardKey::kZ);
  EXPECT_EQ(keyThatPrints("A"), KeyboardKey::kA);
  EXPECT_EQ(keyThatPrints("0"), KeyboardKey::k0);
  EXPECT_EQ(keyThatPrints("+"), KeyboardKey::kPlus);
  EXPECT_EQ(keyThatPrints("`"), KeyboardKey::kGraveAccent);
  EXPECT_EQ(keyThatPrints("ö"), std::nullopt);
  EXPECT_EQ(keyThatPrints("ab"), std::nullopt);
  EXPECT_EQ(keyThatPrints(""), std::nullopt);
}

TEST(DigitOf, RowAndPad) {
  EXPECT_EQ(digitOf(KeyboardKey::k0), 0);
  EXPECT_EQ(digitOf(KeyboardKey::k9), 9);
  EXPECT_EQ(digitOf(KeyboardKey::kPad0), 0);
  EXPECT_EQ(digitOf(KeyboardKey::kPad9), 9);
  EXPECT_EQ(digitOf(KeyboardKey::kZ), std::nullopt);
  EXPECT_EQ(digitOf(KeyboardKey::kPadDecimal), std::nullopt);
}

TEST(ModifierOf, BothSides) {
  EXPECT_EQ(modifierOf(KeyboardKey::kRightShift), (Modifiers{.shift = true}));
  EXPECT_EQ(modifierOf(KeyboardKey::kLeftControl), (Modifiers{.control = true}));
  EXPECT_EQ(modifierOf(KeyboardKey::kRightAlt), (Modifiers{.alt = true}));
  EXPECT_EQ(modifierOf(KeyboardKey::kLeftSuper), (Modifiers{.super = true}));
  EXPECT_EQ(modifierOf(KeyboardKey::kA), Modifiers{});
}

// The bounds of each length, from the Unicode standard, table 3-6.
TEST(Utf8, EachLengthAndWhatIsNoCharacter) {
  EXPECT_EQ(utf8(U'a'), "a");
  EXPECT_EQ(utf8(0x7F), "\x7F");
  EXPECT_EQ(utf8(0x80), "\xC2\x80");
  EXPECT_EQ(utf8(U'ö'), "ö");
  EXPECT_EQ(utf8(0x7FF), "\xDF\xBF");
  EXPECT_EQ(utf8(0x800), "\xE0\xA0\x80");
  EXPECT_EQ(utf8(U'€'), "€");
  EXPECT_EQ(utf8(0xFFFF), "\xEF\xBF\xBF");
  EXPECT_EQ(utf8(0x10000), "\xF0\x90\x80\x80");
  EXPECT_EQ(utf8(U'😀'), "😀");
  EXPECT_EQ(utf8(0x10FFFF), "\xF4\x8F\xBF\xBF");
  EXPECT_EQ(utf8(0xD800), "");
  EXPECT_EQ(utf8(0xDFFF), "");
  EXPECT_EQ(utf8(0x110000), "");
}

}  // namespace
}  // namespace vides
