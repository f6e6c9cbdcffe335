// SPDX-License-Identifier: MIT
// What a text field can't hold comes back from it: characters beyond U+FFFF, private ones, bytes.
#include "panels/wide_characters.hpp"

#include <gtest/gtest.h>

#include "flight/utf8.hpp"
#include "input/input_event.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

TEST(WideCharacters, OrdinaryTextStaysAsItIs) {
  WideCharacters wide;
  for (const char* text :
       {"", "Around the pyramid", "größe ½ … \u2212 \u4e2d\u6587 \uffee\ufffd"}) {
    EXPECT_EQ(wide.folded(text), text);
    EXPECT_EQ(wide.unfolded(text), text);
  }
}

TEST(WideCharacters, WhatIsBeyond16BitsHasAStandInOfItsOwn) {
  WideCharacters wide;
  const std::string text = "a\U0001F3A5b\U0001F680\U0001F3A5";
  const std::string folded = wide.folded(text);
  EXPECT_EQ(folded, "a\uA000b\uA001\uA000");
  EXPECT_EQ(wide.unfolded(folded), text);
  // Whatever was done to it: some taken out, some twice, others between.
  EXPECT_EQ(wide.unfolded("\uA001x\uA001"), "\U0001F680x\U0001F680");
}

// Every text, of any bytes, comes back; and 16 bits are enough for what is handed out.
TEST(WideCharacters, EveryTextComesBack) {
  test::Random random(71);
  for (int round = 0; round < 2000; ++round) {
    WideCharacters wide;
    std::string text;
    for (int i = test::integer(random, 0, 60); i > 0; --i) {
      switch (test::integer(random, 0, 4)) {
        case 0:
          text += utf8(static_cast<char32_t>(test::integer(random, 0x20, 0x7e)));
          break;
        case 1:
          text += utf8(static_cast<char32_t>(test::integer(random, 0x10000, 0x10FFFF)));
          break;
        case 2:
          text += utf8(static_cast<char32_t>(test::integer(random, 0xE000, 0xF8FF)));
          break;
        case 3:
          text += utf8(static_cast<char32_t>(test::integer(random, 0x9FF0, 0xA650)));
          break;
        default:
          text += static_cast<char>(test::integer(random, -128, 127));
      }
    }
    const std::string folded = wide.folded(text);
    ASSERT_TRUE(codePoints(folded));
    for (std::size_t at = 0; at < folded.size(); at += utf8Length(folded.substr(at))) {
      ASSERT_LT(utf8Length(folded.substr(at)), 4u);
    }
    ASSERT_EQ(wide.unfolded(folded), text);
    ASSERT_EQ(wide.folded(text), folded);
  }
}

// The longest text that a field takes, each character another.
TEST(WideCharacters, ThereIsRoomForAnyField) {
  WideCharacters wide;
  std::string text;
  for (char32_t c = WideCharacters::kFirst; text.size() < 4095 - 3; ++c) text += utf8(c);
  EXPECT_EQ(wide.unfolded(wide.folded(text)), text);
  EXPECT_GT(wide.room(), 100u);
  for (char32_t c = 0x20000; wide.room() > 0; ++c) wide.folded(utf8(c));
  EXPECT_EQ(wide.folded("\U0010FFFF"), "\uFFFD");
  wide.clear();
  EXPECT_EQ(wide.folded("\U0010FFFF"), "\uA000");
}

}  // namespace
}  // namespace vides
