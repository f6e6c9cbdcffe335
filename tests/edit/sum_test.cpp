// SPDX-License-Identifier: MIT
// Sums as they are typed into fields. Values are worked out by hand.
#include "edit/sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/german_locale.hpp"

namespace vides {
namespace {

double value(const std::string& text, double own = 0.0) {
  const auto sum = evaluateSum(text, own);
  EXPECT_TRUE(sum) << text << ": " << (sum ? "" : sum.error().key);
  return sum.value_or(std::nan(""));
}

Text why(const std::string& text, double own = 0.0) {
  const auto sum = evaluateSum(text, own);
  EXPECT_FALSE(sum) << text;
  return sum ? Text() : sum.error();
}

TEST(Sum, NumbersStandForThemselves) {
  EXPECT_EQ(value("0.1"), 0.1);
  EXPECT_EQ(value("-0.1"), -0.1);
  EXPECT_EQ(value("+0.1"), 0.1);
  EXPECT_EQ(value(" 0,5 "), 0.5);
  EXPECT_EQ(value("\u22120.5"), -0.5);
  EXPECT_EQ(value(".5"), 0.5);
  EXPECT_EQ(value("5."), 5.0);
  EXPECT_EQ(value("1e-3"), 0.001);
  EXPECT_EQ(value("2E+2"), 200.0);
  EXPECT_EQ(value("1e-999"), 0.0);
  EXPECT_FALSE(std::signbit(value("-0")));
}

TEST(Sum, GoesByTheUsualOrder) {
  EXPECT_EQ(value("0.1+0.2"), 0.1 + 0.2);
  EXPECT_EQ(value("0,1+0,2"), 0.1 + 0.2);
  EXPECT_EQ(value("1+2*3"), 7.0);
  EXPECT_EQ(value("(1+2)*3"), 9.0);
  EXPECT_EQ(value("8/4/2"), 1.0);
  EXPECT_EQ(value("8-4-2"), 2.0);
  EXPECT_EQ(value("2*-3"), -6.0);
  EXPECT_EQ(value("--2"), 2.0);
  EXPECT_EQ(value("-(1+2)"), -3.0);
  EXPECT_EQ(value(" 6 \u00f7 3 \u00d7 2 "), 4.0);
  EXPECT_EQ(value("((((2))))"), 2.0);
}

TEST(Sum, StartsFromTheNumberThatIsThere) {
  EXPECT_EQ(value("*2", 0.3), 0.6);
  EXPECT_EQ(value("/3", 0.3), 0.3 / 3);
  EXPECT_EQ(value("*2+1", 5.0), 11.0);
  EXPECT_EQ(value("+=0.1", 0.3), 0.3 + 0.1);
  EXPECT_EQ(value("-=0.1", 0.3), 0.3 - 0.1);
  EXPECT_EQ(value("-=1-3", 5.0), 7.0);
  EXPECT_EQ(value("*=1+1", 5.0), 10.0);
  EXPECT_EQ(value("/=1+1", 5.0), 2.5);
  EXPECT_EQ(value("\u2212=2", 5.0), 3.0);
  for (const char* own : {"*2", "/2", "+=1", "-=1", " *2"}) EXPECT_TRUE(startsFromOwn(own)) << own;
  for (const char* plain : {"-0.1", "+0.1", "2*3", "", "x"}) {
    EXPECT_FALSE(startsFromOwn(plain)) << plain;
  }
}

TEST(Sum, TellsWhatIsWrongAndWhere) {
  EXPECT_EQ(why(""), Text("refusal.no-number", {""}));
  EXPECT_EQ(why("abc"), Text("refusal.no-number", {"abc"}));
  EXPECT_EQ(why("nan"), Text("refusal.no-number", {"nan"}));
  EXPECT_EQ(why("inf"), Text("refusal.no-number", {"inf"}));
  EXPECT_EQ(why("x+1"), Text("refusal.no-number", {"x+1"}));
  EXPECT_EQ(why("1+"), Text("refusal.sum.number", {"1+", std::size_t{3}}));
  EXPECT_EQ(why("\u2212\u00d72"), Text("refusal.sum.number", {"\u2212\u00d72", std::size_t{2}}));
  EXPECT_EQ(why("1 2"), Text("refusal.sum.sign", {"1 2", std::size_t{3}}));
  EXPECT_EQ(why("1.2.3"), Text("refusal.sum.sign", {"1.2.3", std::size_t{4}}));
  EXPECT_EQ(why("0x10"), Text("refusal.sum.sign", {"0x10", std::size_t{2}}));
  EXPECT_EQ(why("2*(1"), Text("refusal.sum.bracket", {"2*(1", std::size_t{3}}));
  EXPECT_EQ(why("1)"), Text("refusal.sum.sign", {"1)", std::size_t{2}}));
  EXPECT_EQ(why("1/0"), Text("refusal.sum.zero", {"1/0", std::size_t{2}}));
  EXPECT_EQ(why("/(1-1)", 3.0), Text("refusal.sum.zero", {"/(1-1)", std::size_t{1}}));
  EXPECT_EQ(why("1+1e999"), Text("refusal.sum.large", {"1+1e999", std::size_t{3}}));
  EXPECT_EQ(why("*1e300", 1e300).key, "refusal.sum.large");
  EXPECT_EQ(why(std::string(4000, '(') + "1").key, "refusal.sum.deep");
}

TEST(Sum, ReadsTheSameInEveryLocale) {
  const test::GermanLocale locale;
  EXPECT_EQ(value("0.5+0,25"), 0.75);
}

}  // namespace
}  // namespace vides
