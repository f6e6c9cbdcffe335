// SPDX-License-Identifier: MIT
// The fast writers give byte for byte what snprintf and fmt give.
#include "io/number_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

namespace vides {
namespace {

constexpr int kRandomValues = 2'500'000;  // of each of the four kinds: ten million together

using Writer = char* (*)(char*, double);

std::string written(Writer write, double value) {
  char text[kMostNumberBytes];
  return {text, write(text, value)};
}

std::string printed(int decimals, double value) {
  char text[kMostNumberBytes + 1];
  const int size = std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string all(text, static_cast<std::size_t>(size));
  // What differs from C: a value that rounds to 0 has no sign.
  if (all.find_first_not_of("-0.") == std::string::npos && all[0] == '-') all.erase(0, 1);
  return all;
}

void expectFixed(double value) {
  // Not EXPECT_EQ: ten million messages cost more than the comparison.
  if (written(writeFixed4, value) != printed(4, value)) {
    ADD_FAILURE() << fmt::format("{:.20g}: {}", value, written(writeFixed4, value));
  }
}

void expectFixed6(double value) {
  if (written(writeFixed6, value) != printed(6, value)) {
    ADD_FAILURE() << fmt::format("{:.20g}: {}", value, written(writeFixed6, value));
  }
}

void expectShortest(double value) {
  char text[kMostNumberBytes], wanted[kMostNumberBytes];
  const auto size = static_cast<std::size_t>(writeShortest(text, value) - text);
  const auto wantedSize = static_cast<std::size_t>(fmt::format_to(wanted, "{}", value) - wanted);
  if (std::string_view(text, size) != std::string_view(wanted, wantedSize)) {
    ADD_FAILURE() << std::string_view(wanted, wantedSize) << ": " << std::string_view(text, size);
  }
}

TEST(NumberText, FixedOfOrdinaryValues) {
  EXPECT_EQ(written(writeFixed4, 0.0), "0.0000");
  EXPECT_EQ(written(writeFixed4, -0.0), "0.0000");
  EXPECT_EQ(written(writeFixed4, -0.00004), "0.0000");
  EXPECT_EQ(written(writeFixed4, -0.00006), "-0.0001");
  EXPECT_EQ(written(writeFixed4, 12.0), "12.0000");
  EXPECT_EQ(written(writeFixed4, -0.99996), "-1.0000");
  EXPECT_EQ(written(writeFixed4, 99.99996), "100.0000");
  EXPECT_EQ(written(writeFixed6, -0.0000004), "0.000000");
  EXPECT_EQ(written(writeFixed6, 89.9999996), "90.000000");
}

// k / 32 * 10^-3 and the like: values that lie exactly between two texts, and their neighbours.
TEST(NumberText, FixedOfTies) {
  int ties = 0;
  for (int k = -200'000; k <= 200'000; ++k) {
    for (const double step : {1.0 / 32.0, 1.0 / 128.0, 5e-5, 5e-7}) {
      const double value = k * step;
      for (const double v : {std::nextafter(value, -1e300), value, std::nextafter(value, 1e300)}) {
        expectFixed(v);
        expectFixed6(v);
      }
    }
    ties += std::abs(k) % 32 % 2;
  }
  EXPECT_GT(ties, 100'000);
  EXPECT_EQ(written(writeFixed4, 0.03125), "0.0312");  // to even
  EXPECT_EQ(written(writeFixed4, 0.09375), "0.0938");  // to even
  EXPECT_EQ(written(writeFixed4, -0.03125), "-0.0312");
}

TEST(NumberText, FixedOfRandomValuesInTheCube) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> cube{-1.3, 1.3};
  for (int i = 0; i < kRandomValues; ++i) expectFixed(cube(random));
}

TEST(NumberText, FixedOfRandomValuesNearTies) {
  std::mt19937_64 random{2};
  for (int i = 0; i < kRandomValues; ++i) {
    const auto half =
        static_cast<double>(static_cast<std::int64_t>(random() % 2'000'001) - 1000000);
    const double tie = (half + 0.5) * 1e-4;
    expectFixed(tie + (static_cast<double>(random() % 9) - 4.0) * 1e-17);
  }
}

TEST(NumberText, FixedOfRandomMagnitudes) {
  std::mt19937_64 random{3};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  for (int i = 0; i < kRandomValues; ++i) {
    const double value = std::ldexp(unit(random), static_cast<int>(random() % 120) - 50);
    expectFixed(value);
  }
}

TEST(NumberText, FixedOfRandomBits) {
  std::mt19937_64 random{4};
  for (int i = 0; i < kRandomValues; ++i) {
    const auto value = std::bit_cast<double>(random());
    // Huge values take snprintf long, and go another way: a share of them is enough.
    if (!std::isfinite(value) || (std::abs(value) > 1e30 && i % 32 != 0)) continue;
    expectFixed(value);
    if (i % 8 == 0) expectFixed6(value);
  }
}

TEST(NumberText, ShortestOfOrdinaryValues) {
  EXPECT_EQ(written(writeShortest, 0.0), "0");
  EXPECT_EQ(written(writeShortest, -0.0), "0");
  EXPECT_EQ(written(writeShortest, 30.0), "30");
  EXPECT_EQ(written(writeShortest, 0.1), "0.1");
  EXPECT_EQ(written(writeShortest, -12.5), "-12.5");
  EXPECT_EQ(written(writeShortest, 0.0001), "0.0001");
  EXPECT_EQ(written(writeShortest, 0.00001), "1e-05");
  EXPECT_EQ(written(writeShortest, 1.5e300), "1.5e+300");
  EXPECT_EQ(written(writeShortest, 5e-324), "5e-324");
}

TEST(NumberText, ShortestAroundThePowersOfTen) {
  for (int exponent = -30; exponent <= 30; ++exponent) {
    const double power = std::stod("1e" + std::to_string(exponent));
    for (const double v : {std::nextafter(power, 0.0), power, std::nextafter(power, 1e300)}) {
      for (const double factor : {1.0, -1.0, 2.0, 9.0, 12.0, 0.5}) expectShortest(factor * v);
    }
  }
  expectShortest(std::numeric_limits<double>::max());
  expectShortest(std::numeric_limits<double>::min());
  expectShortest(std::numeric_limits<double>::denorm_min());
}

TEST(NumberText, ShortestOfRandomValues) {
  std::mt19937_64 random{5};
  std::uniform_real_distribution<double> cube{-1.3, 1.3};
  for (int i = 0; i < kRandomValues; ++i) {
    expectShortest(cube(random));
    const auto bits = std::bit_cast<double>(random());
    if (std::isfinite(bits) && bits != 0.0) expectShortest(bits);
    // Short ones: times, zooms, positions typed by hand; and whole numbers.
    expectShortest(static_cast<double>(static_cast<std::int64_t>(random() % 2'000'001) + 1) / 1e4);
    expectShortest(static_cast<double>(random() >> (random() % 64) | 1));
  }
}

TEST(NumberText, Integers) {
  const auto text = [](std::int64_t value) {
    char buffer[kMostNumberBytes];
    return std::string(buffer, writeInteger(buffer, value));
  };
  for (std::int64_t power = 1; power < 1'000'000'000'000'000'000; power *= 10) {
    for (const std::int64_t value : {power - 1, power, power + 1, -power, 1 - power}) {
      EXPECT_EQ(text(value), std::to_string(value));
    }
  }
  EXPECT_EQ(text(std::numeric_limits<std::int64_t>::max()), "9223372036854775807");
  EXPECT_EQ(text(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

}  // namespace
}  // namespace vides
