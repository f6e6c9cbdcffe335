// SPDX-License-Identifier: MIT
// Reads numbers and indices of OBJ files.
#include "scene/obj_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <system_error>

namespace vides {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

bool isDigit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool isWordPart(char c) { return isDigit(c) || (lower(c) >= 'a' && lower(c) <= 'z') || c == '_'; }

// Whether a text begins with a word, which is in lower case.
bool begins(std::string_view text, std::string_view word) {
  return text.size() >= word.size() && std::equal(word.begin(), word.end(), text.begin(),
                                                  [](char a, char b) { return a == lower(b); });
}
bool is(std::string_view text, std::string_view word) {
  return text.size() == word.size() && begins(text, word);
}

// What follows "1." where Microsoft's C library prints what isn't finite: "#QNAN", "#IND00" …, and
// what rounding makes of them: "#J" of "#INF", "$" of them all.
bool isPrintedNotANumber(std::string_view text) {
  while (text.ends_with('0')) text.remove_suffix(1);
  for (const std::string_view word : {"#qnan", "#snan", "#ind", "#inf", "$"}) {
    if (is(text, word)) return true;
  }
  const std::string_view rounded = text.substr(std::min<std::size_t>(1, text.size()));
  return text.starts_with('#') && !rounded.empty() && rounded.size() <= 4 &&
         std::ranges::all_of(rounded, [](char c) { return c >= 'A' && c <= 'Z'; });
}

// "nan", "inf", "nan(ind)", "1.#QNAN" … without a sign.
std::optional<double> notFinite(std::string_view word) {
  if (is(word, "inf") || is(word, "infinity")) return kInfinity;
  if (begins(word, "nan")) {
    const std::string_view rest = word.substr(3);
    // "nanq" and "nans": AIX.
    if (rest.empty() || is(rest, "q") || is(rest, "s")) return kNotANumber;
    const bool bracketed = rest.size() >= 2 && rest.front() == '(' && rest.back() == ')' &&
                           std::ranges::all_of(rest.substr(1, rest.size() - 2), isWordPart);
    return bracketed ? std::optional(kNotANumber) : std::nullopt;
  }
  if (word.starts_with("1.") && isPrintedNotANumber(word.substr(2))) {
    return begins(word.substr(2), "#inf") ? kInfinity : kNotANumber;
  }
  return std::nullopt;
}

// Which end of what a double holds a number lies beyond: its first digit that isn't 0 tells,
// before the point or behind it, moved by the exponent.
bool isTiny(std::string_view word) {
  const std::size_t e = std::min(word.find_first_of("eE"), word.size());
  std::string_view exponent = word.substr(std::min(e + 1, word.size()));
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  std::int32_t shift = 0;
  const auto read = std::from_chars(exponent.begin(), exponent.end(), shift);
  // No file is long enough to make up for such an exponent.
  if (read.ec == std::errc::result_out_of_range) return exponent.starts_with('-');
  const std::size_t point = std::min(word.find('.'), e);
  const auto before =
      static_cast<std::int64_t>(point) - static_cast<std::int64_t>(word.find_first_of("123456789"));
  return before + shift < 0;
}

// Behind an integer, with or without a sign; `at` where there is none.
std::size_t behindInteger(std::string_view text, std::size_t at) {
  const std::size_t sign = at < text.size() && (text[at] == '-' || text[at] == '+') ? at + 1 : at;
  std::size_t end = sign;
  while (end < text.size() && isDigit(text[end])) ++end;
  return end > sign ? end : at;
}

}  // namespace

std::optional<double> objNumber(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.begin(), word.end(), value);
  if (end == word.end() && error == std::errc()) return value;
  const bool negative = word.starts_with('-');
  const double sign = negative ? -1.0 : 1.0;
  if (end == word.end() && error == std::errc::result_out_of_range) {
    return isTiny(word) ? 0.0 : sign * kInfinity;
  }
  const auto special = notFinite(negative ? word.substr(1) : word);
  return special ? std::optional(sign * *special) : std::nullopt;
}

std::optional<std::int64_t> objIndex(std::string_view group) {
  if (group.starts_with('+') && !group.starts_with("+-")) group.remove_prefix(1);
  std::int64_t index = 0;
  auto [at, error] = std::from_chars(group.begin(), group.end(), index);
  if (error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    index = group.starts_with('-') ? std::numeric_limits<std::int64_t>::min()
                                   : std::numeric_limits<std::int64_t>::max();
  }
  if (index == 0) return std::nullopt;
  if (at == group.end()) return index;
  // The texture coordinate and the normal are not looked up, but they are numbers or left out.
  auto next = static_cast<std::size_t>(at - group.begin());
  for (int slashes = 0; slashes < 2 && next < group.size() && group[next] == '/'; ++slashes) {
    next = behindInteger(group, next + 1);
  }
  return next == group.size() ? std::optional(index) : std::nullopt;
}

}  // namespace vides
