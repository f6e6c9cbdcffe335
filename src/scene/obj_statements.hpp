// SPDX-License-Identifier: MIT
// The statements of an OBJ file, word by word.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace vides {

// Lines end with CR, LF or CRLF. A backslash before the line's end, also with blanks between, goes
// on in the next line; a comment, from # on, never does. All but nextLine() is about the line that
// it has come to.
class ObjStatements {
 public:
  explicit ObjStatements(std::string_view text)
      : at_(text.data()), begin_(text.data()), end_(text.data() + text.size()) {}

  // False after the last line.
  bool nextLine() {
    if (line_ > 0) skipLine();
    if (at_ == end_) return false;
    ++line_;
    return true;
  }

  // The next word of the line; empty at its end.
  std::string_view word() {
    for (;;) {
      while (at_ != end_ && kind(*at_) == Kind::kBlank) ++at_;
      if (at_ == end_ || kind(*at_) == Kind::kEnd || *at_ == '#') return {};
      const char* const next = continuation(at_);
      if (next == nullptr) break;
      goOn(next);
    }
    const char* const first = at_;
    while (at_ != end_ && isPart(at_, first)) ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
  }

  std::int64_t line() const { return line_; }
  // How much of the text has been read, 0 to 1.
  double share() const {
    return static_cast<double>(at_ - begin_) / static_cast<double>(end_ - begin_);
  }

 private:
  enum class Kind : std::uint8_t { kText, kBlank, kEnd, kSpecial };
  static constexpr std::array<Kind, 256> kKinds = [] {
    std::array<Kind, 256> kinds{};
    for (const char c : {' ', '\t', '\v', '\f'})
      kinds[static_cast<unsigned char>(c)] = Kind::kBlank;
    for (const char c : {'\r', '\n'}) kinds[static_cast<unsigned char>(c)] = Kind::kEnd;
    for (const char c : {'#', '\\'}) kinds[static_cast<unsigned char>(c)] = Kind::kSpecial;
    return kinds;
  }();
  static Kind kind(char c) { return kKinds[static_cast<unsigned char>(c)]; }

  bool isPart(const char* at, const char* first) const {
    const Kind its = kind(*at);
    if (its != Kind::kSpecial) return its == Kind::kText;
    if (*at == '\\') return continuation(at) == nullptr;
    return !isComment(at, first);
  }

  // "1.#QNAN" is a word, as some programs print what isn't finite.
  static bool isComment(const char* at, const char* first) { return at == first || at[-1] != '.'; }

  // Behind a mark to go on at this place: where the next line begins; else null.
  const char* continuation(const char* at) const {
    if (*at != '\\') return nullptr;
    do ++at;
    while (at != end_ && kind(*at) == Kind::kBlank);
    if (at == end_) return at;
    return kind(*at) == Kind::kEnd ? behindEnd(at) : nullptr;
  }

  // The text's end is none of a line.
  void goOn(const char* next) {
    at_ = next;
    if (kind(next[-1]) == Kind::kEnd) ++line_;
  }

  const char* behindEnd(const char* at) const {
    return at + (*at == '\r' && at + 1 != end_ && at[1] == '\n' ? 2 : 1);
  }

  // A statement that is passed over goes on in the next line, too.
  void skipLine() {
    bool comment = false;
    for (const char* const first = at_; at_ != end_;) {
      const Kind its = kind(*at_);
      if (its == Kind::kEnd) {
        at_ = behindEnd(at_);
        return;
      }
      if (its == Kind::kSpecial && !comment) {
        comment = *at_ == '#' && isComment(at_, first);
        if (const char* const next = continuation(at_)) {
          goOn(next);
          continue;
        }
      }
      ++at_;
    }
  }

  const char* at_;
  const char* begin_;
  const char* end_;
  std::int64_t line_ = 0;
};

}  // namespace vides
