// SPDX-License-Identifier: MIT
// Two digits at a time from a table; fixed decimals by exact integer arithmetic.
#include "io/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace vides {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::array<char, 200> kPairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

constexpr std::array<std::uint64_t, 20> kPowersOfTen = [] {
  std::array<std::uint64_t, 20> powers{};
  std::uint64_t power = 1;
  for (std::uint64_t& p : powers) {
    p = power;
    power *= 10;  // wraps after the last
  }
  return powers;
}();

void putPair(char* out, std::uint32_t value) {
  std::memcpy(out, &kPairs[std::size_t{2} * value], 2);
}

// The digits of value < 10^8; its two halves don't wait for each other.
void putEight(char* out, std::uint32_t value) {
  const std::uint32_t high = value / 10000;
  const std::uint32_t low = value % 10000;
  putPair(out, high / 100);
  putPair(out + 2, high % 100);
  putPair(out + 4, low / 100);
  putPair(out + 6, low % 100);
}

// Exactly `count` digits, with leading zeros.
void putDigits(char* out, std::uint64_t value, std::size_t count) {
  while (count > 8) {
    count -= 8;
    putEight(out + count, static_cast<std::uint32_t>(value % 100'000'000));
    value /= 100'000'000;
  }
  auto rest = static_cast<std::uint32_t>(value);
  while (count >= 2) {
    count -= 2;
    putPair(out + count, rest % 100);
    rest /= 100;
  }
  if (count == 1) *out = static_cast<char>('0' + rest % 10);
}

std::size_t digitCount(std::uint64_t value) {
  // log10 from log2: 1233 / 4096 is a little more than log10(2).
  const auto guess = static_cast<std::size_t>(std::bit_width(value | 1) * 1233 >> 12);
  return guess + (value >= kPowersOfTen[guess] ? 1 : 0) + (value == 0 ? 1 : 0);
}

char* putUnsigned(char* out, std::uint64_t value) {
  if (value < 10) {
    *out = static_cast<char>('0' + value);
    return out + 1;
  }
  const std::size_t count = digitCount(value);
  putDigits(out, value, count);
  return out + count;
}

// |value| = mantissa * 2^exponent.
struct Binary {
  std::uint64_t mantissa;
  int exponent;
};
Binary binaryOf(std::uint64_t bits) {
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  if (field == 0) return {fraction, -1074};
  return {fraction | std::uint64_t{1} << 52, field - 1075};
}

// |value| * 10^decimals to the nearest integer, ties to even: exact, because the mantissa times
// 10^decimals has at most 73 bits. For exponents below 0 that leave less than 2^63.
std::uint64_t scaled(const Binary& number, std::uint64_t scale) {
  const int shift = -number.exponent;
  if (shift > 75) return 0;  // less than a quarter
  const Wide product = static_cast<Wide>(number.mantissa) * scale;
  const Wide half = Wide{1} << (shift - 1);
  const Wide rest = product & ((half << 1) - 1);
  const auto whole = static_cast<std::uint64_t>(product >> shift);
  return whole + (rest > half || (rest == half && whole % 2 == 1) ? 1 : 0);
}

template <std::size_t Decimals>
char* writeFixed(char* out, double value) {
  constexpr std::uint64_t kScale = kPowersOfTen[Decimals];
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const Binary number = binaryOf(bits);
  // Below 2^42 the scaled value has less than 63 bits.
  if (number.exponent > -11) {
    return std::to_chars(out, out + kMostNumberBytes, value, std::chars_format::fixed,
                         static_cast<int>(Decimals))
        .ptr;
  }
  const std::uint64_t rounded = scaled(number, kScale);
  *out = '-';
  out += (bits >> 63) & (rounded != 0 ? 1u : 0u);
  out = putUnsigned(out, rounded / kScale);
  *out++ = '.';
  putDigits(out, rounded % kScale, Decimals);
  return out + Decimals;
}

// The `count` digits of a shortest decimal, at most 17. Always fills 17 places, with zeros behind:
// without branches that is quicker than stopping in time.
void putShortestDigits(char* out, std::uint64_t digits, std::size_t count) {
  digits *= kPowersOfTen[17 - count];
  const std::uint64_t high = digits / 100'000'000;
  putEight(out + 9, static_cast<std::uint32_t>(digits % 100'000'000));
  putEight(out + 1, static_cast<std::uint32_t>(high % 100'000'000));
  *out = static_cast<char>('0' + high / 100'000'000);
}

// "1e-05", "1.5e+300": at least two digits of exponent.
char* putScientific(char* out, std::uint64_t digits, std::size_t count, int exponent) {
  putShortestDigits(out + 1, digits, count);
  out[0] = out[1];
  out[1] = '.';
  out += count == 1 ? 1 : count + 1;
  *out++ = 'e';
  *out++ = exponent < 0 ? '-' : '+';
  const auto size = static_cast<std::uint64_t>(std::abs(exponent));
  if (size < 10) *out++ = '0';
  return putUnsigned(out, size);
}

// digits * 10^exponent; `count` digits, the first in front of 10^leading.
char* putPlain(char* out, std::uint64_t digits, std::size_t count, int exponent, int leading) {
  if (exponent >= 0) {
    putShortestDigits(out, digits, count);
    std::memset(out + count, '0', static_cast<std::size_t>(exponent));
    return out + count + exponent;
  }
  if (leading < 0) {
    const auto zeros = static_cast<std::size_t>(-leading - 1);
    std::copy_n("0.000", 5, out);  // zeros is at most 3
    putShortestDigits(out + 2 + zeros, digits, count);
    return out + 2 + zeros + count;
  }
  const auto whole = static_cast<std::size_t>(leading) + 1;
  putShortestDigits(out + 1, digits, count);
  for (std::size_t i = 0; i < whole; ++i) out[i] = out[i + 1];
  out[whole] = '.';
  return out + count + 1;
}

}  // namespace

char* writeFixed4(char* out, double value) { return writeFixed<4>(out, value); }
char* writeFixed6(char* out, double value) { return writeFixed<6>(out, value); }

char* writeInteger(char* out, std::int64_t value) {
  auto size = static_cast<std::uint64_t>(value);
  if (value < 0) {
    *out++ = '-';
    size = 0 - size;
  }
  return putUnsigned(out, size);
}

char* writeShortest(char* out, double value) {
  if (value == 0.0) {
    *out = '0';
    return out + 1;
  }
  *out = '-';
  out += value < 0.0 ? 1 : 0;
  const double size = std::abs(value);
  if (size < 1e15) {
    const auto whole = static_cast<std::int64_t>(size);
    if (static_cast<double>(whole) == size)
      return putUnsigned(out, static_cast<std::uint64_t>(whole));
  }
  // fmt's own digits without what it does around them: that takes longer than finding them. It is
  // no public interface; test number_text compares with fmt's "{}".
  const auto decimal = fmt::detail::dragonbox::to_decimal(size);
  const std::size_t count = digitCount(decimal.significand);
  const int leading = decimal.exponent + static_cast<int>(count) - 1;
  if (leading < -4 || leading >= 16) {
    return putScientific(out, decimal.significand, count, leading);
  }
  return putPlain(out, decimal.significand, count, decimal.exponent, leading);
}

}  // namespace vides
