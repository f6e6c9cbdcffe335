// SPDX-License-Identifier: MIT
// Any bytes on one line, and names that can be told apart.
#include "flight/printable.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <set>

#include "flight/utf8.hpp"

namespace vides {
namespace {

bool latin(char32_t c) { return c < 0x250; }

TEST(Printable, ControlCharactersAndForeignBytesAreEscaped) {
  EXPECT_EQ(printable("flight.vid"), "flight.vid");
  EXPECT_EQ(printable("plaene \\ \u00e4 \u4e2d \U0001f600"), "plaene \\ \u00e4 \u4e2d \U0001f600");
  EXPECT_EQ(printable("esc\x1b[31m"), "esc\\x1B[31m");
  EXPECT_EQ(printable("two\nlines\t\r"), "two\\x0Alines\\x09\\x0D");
  EXPECT_EQ(printable("pl\xe4ne"), "pl\\xE4ne");
  EXPECT_EQ(printable("\x7f"), "\\x7F");
  EXPECT_EQ(printable("\xc3"), "\\xC3");                    // half a character
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xED\\xA0\\x80");  // a surrogate
  EXPECT_EQ(printable("\xc2\x9b"), "\\xC2\\x9B");           // a terminal's own escape
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
}

TEST(Printable, NamesInListsAreToldApart) {
  const auto shown = [](std::string_view name) { return unambiguous(name, latin); };
  EXPECT_EQ(shown("a b.vid"), "a b.vid");
  EXPECT_EQ(shown("a\\x1B"), "a\\\\x1B");
  EXPECT_EQ(shown("a\x1b"), "a\\x1B");
  EXPECT_EQ(shown("\u00e4"), "\u00e4");
  EXPECT_EQ(shown("a\u0308"), "a\\u{308}");  // the same letter of two characters
  EXPECT_EQ(shown("\u4e2d\U0001f600"), "\\u{4e2d}\\u{1f600}");
  EXPECT_EQ(shown("a\u00a0b"), "a\\u{a0}b");
  EXPECT_EQ(shown(" a "), "\\x20a\\x20");
  EXPECT_EQ(shown("  "), "\\x20\\x20");
}

TEST(Printable, NoTwoNamesLookAlike) {
  std::mt19937 random(13);
  constexpr std::string_view kLetters[] = {"a",    "x",    "2",      "0",    "{",      "u",
                                           "\\",   " ",    "\n",     "\xe4", "\u00e4", "\u4e2d",
                                           "\x7f", "\xc2", "\u00a0", "}"};
  std::set<std::string> names, shown;
  for (int i = 0; i < 100000; ++i) {
    std::string name;
    for (std::size_t n = random() % 5; n > 0; --n) name += kLetters[random() % std::size(kLetters)];
    if (!names.insert(name).second) continue;
    const std::string text = unambiguous(name, latin);
    EXPECT_TRUE(codePoints(text)) << text;
    EXPECT_TRUE(shown.insert(text).second) << text;
    for (const char c : printable(name)) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20);
  }
}

}  // namespace
}  // namespace vides
