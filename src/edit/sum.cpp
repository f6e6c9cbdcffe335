// SPDX-License-Identifier: MIT
// A reader of sums by recursive descent.
#include "edit/sum.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace vides {
namespace {

constexpr int kMostBrackets = 64;  // one in the other

// The text in signs that are one byte each, and which character of the text each of them was.
struct Signs {
  std::string plain;
  std::vector<std::size_t> characters;  // one more than signs: the last is the end's
};

Signs signsOf(std::string_view text) {
  constexpr std::pair<std::string_view, char> kWritten[] = {
      {"\u2212", '-'}, {"\u00d7", '*'}, {"\u00b7", '*'}, {"\u00f7", '/'}, {"\u00a0", ' '}};
  Signs signs;
  std::size_t character = 1;
  while (!text.empty()) {
    std::size_t length = 1;
    while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) {
      ++length;
    }
    char sign = length == 1 ? text[0] : '?';
    for (const auto& [written, plain] : kWritten) {
      if (text.substr(0, length) == written) sign = plain;
    }
    if (sign == '\t' || sign == '\r' || sign == '\n') sign = ' ';
    if (sign != ' ') {
      signs.plain += sign;
      signs.characters.push_back(character);
    } else if (!signs.plain.empty()) {
      // Blanks may stand between signs, not within numbers: they are kept as the end of one.
      signs.plain += ' ';
      signs.characters.push_back(character);
    }
    text.remove_prefix(length);
    ++character;
  }
  while (signs.plain.ends_with(' ')) {
    signs.plain.pop_back();
    signs.characters.pop_back();
  }
  signs.characters.push_back(signs.characters.empty() ? 1 : signs.characters.back() + 1);
  return signs;
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Where the text goes on behind a beginning that starts from the number that is there.
enum class Beginning { kNone, kAdd, kSubtract, kMultiply, kDivide, kContinue };
Beginning beginningOf(const std::string& plain) {
  if (plain.starts_with("+=")) return Beginning::kAdd;
  if (plain.starts_with("-=")) return Beginning::kSubtract;
  if (plain.starts_with("*=")) return Beginning::kMultiply;
  if (plain.starts_with("/=")) return Beginning::kDivide;
  if (plain.starts_with('*') || plain.starts_with('/')) return Beginning::kContinue;
  return Beginning::kNone;
}

class Reader {
 public:
  Reader(std::string_view text, Signs signs) : text_(text), signs_(std::move(signs)) {}

  tl::expected<double, Text> read(double own) {
    const Beginning beginning = beginningOf(signs_.plain);
    double value = own;
    if (beginning == Beginning::kContinue) {
      value = sum(own);
    } else if (beginning == Beginning::kNone) {
      value = sum();
    } else {
      at_ = 2;
      const double by = sum();
      if (beginning == Beginning::kAdd) value = own + by;
      if (beginning == Beginning::kSubtract) value = own - by;
      if (beginning == Beginning::kMultiply) value = own * by;
      if (beginning == Beginning::kDivide) value = divided(own, by, 0);
    }
    if (sign() != '\0') fail("refusal.sum.sign", at_);
    if (!std::isfinite(value)) fail("refusal.sum.large", 0);
    if (problem_.empty()) return value + 0.0;  // -0 becomes 0
    return tl::unexpected(problem_);
  }

 private:
  // The next sign, blanks left out; 0 at the end and after a problem.
  char sign() {
    while (at_ < signs_.plain.size() && signs_.plain[at_] == ' ') ++at_;
    return problem_.empty() && at_ < signs_.plain.size() ? signs_.plain[at_] : '\0';
  }
  bool take(char wanted) {
    if (sign() != wanted) return false;
    ++at_;
    return true;
  }
  // The first problem is told. What has no number at all is called no number.
  double fail(const char* key, std::size_t at) {
    if (!problem_.empty()) return 0.0;
    const bool any = std::any_of(signs_.plain.begin(), signs_.plain.end(), isDigit);
    const bool whole = !any || (at == 0 && std::string_view(key) == "refusal.sum.number");
    problem_ =
        whole
            ? Text("refusal.no-number", {std::string(text_)})
            : Text(key, {std::string(text_), signs_.characters[std::min(at, signs_.plain.size())]});
    return 0.0;
  }
  double divided(double value, double by, std::size_t at) {
    return by == 0.0 ? fail("refusal.sum.zero", at) : value / by;
  }

  double sum() { return restOfSum(product()); }
  double sum(double first) { return restOfSum(restOfProduct(first)); }
  double restOfSum(double value) {
    while (true) {
      if (take('+')) {
        value += product();
      } else if (take('-')) {
        value -= product();
      } else {
        return value;
      }
    }
  }
  double product() { return restOfProduct(factor()); }
  double restOfProduct(double value) {
    while (true) {
      if (take('*')) {
        value *= factor();
      } else if (take('/')) {
        const std::size_t at = at_ - 1;
        value = divided(value, factor(), at);
      } else {
        return value;
      }
    }
  }
  double factor() {
    bool negative = false;
    while (sign() == '-' || sign() == '+') {
      if (sign() == '-') negative = !negative;
      ++at_;
    }
    const double value = take('(') ? bracket() : number();
    return negative ? -value : value;
  }
  double bracket() {
    const std::size_t opened = at_ - 1;
    if (++brackets_ > kMostBrackets) return fail("refusal.sum.deep", opened);
    const double value = sum();
    --brackets_;
    if (!take(')')) {
      return sign() == '\0' ? fail("refusal.sum.bracket", opened) : fail("refusal.sum.sign", at_);
    }
    return value;
  }
  // Digits with a point or a comma among them, and a power of ten.
  double number() {
    sign();
    const std::size_t from = at_;
    std::string digits;
    bool any = false;
    for (bool point = false; at_ < signs_.plain.size(); ++at_) {
      const char c = signs_.plain[at_];
      const bool separates = (c == '.' || c == ',') && !point;
      if (!isDigit(c) && !separates) break;
      point = point || separates;
      any = any || isDigit(c);
      digits += separates ? '.' : c;
    }
    if (!any) {
      at_ = from;
      return fail("refusal.sum.number", from);
    }
    const bool falls = takePower(digits);
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    static_cast<void>(end);
    if (error != std::errc::result_out_of_range) return value;
    return falls ? 0.0 : fail("refusal.sum.large", from);
  }
  // e-3, E+3; true where what is out of range is too small rather than too large.
  bool takePower(std::string& digits) {
    const std::string& plain = signs_.plain;
    const bool small = digits.starts_with('0') || digits.starts_with('.');
    std::size_t next = at_;
    if (next >= plain.size() || (plain[next] != 'e' && plain[next] != 'E')) return small;
    ++next;
    const bool negative = next < plain.size() && plain[next] == '-';
    if (negative || (next < plain.size() && plain[next] == '+')) ++next;
    if (next >= plain.size() || !isDigit(plain[next])) return small;
    digits += negative ? "e-" : "e";
    for (; next < plain.size() && isDigit(plain[next]); ++next) digits += plain[next];
    at_ = next;
    return negative;
  }

  std::string_view text_;
  Signs signs_;
  std::size_t at_ = 0;
  int brackets_ = 0;
  Text problem_;
};

}  // namespace

bool startsFromOwn(std::string_view text) {
  return beginningOf(signsOf(text).plain) != Beginning::kNone;
}

tl::expected<double, Text> evaluateSum(std::string_view text, double own) {
  return Reader(text, signsOf(text)).read(own);
}

}  // namespace vides
