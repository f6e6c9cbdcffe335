// SPDX-License-Identifier: MIT
// Reads JSON (RFC 8259) value by value, as the caller's schema asks for it.
//
// nlohmann-json's event parser can't keep the promises of the `.vid` format: it stops at a number
// beyond double, takes a NUL for the end of the text, converts numbers by the locale, and doesn't
// tell where a value stands. This reader knows the place of everything, keeps nothing but the path
// to it, and leaves a value's text as it is where that is wanted.
//
// What isn't JSON ends in a thrown SyntaxError, nesting beyond limits::kNesting in TooDeep; nothing
// else throws. Both stay inside io.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "flight/limits.hpp"
#include "flight/problem.hpp"

namespace vides {

struct SyntaxError {
  Syntax expected = Syntax::kNone;
  std::size_t offset = 0;  // where the text stops being JSON
  std::string found;       // as in Problem
};

struct TooDeep {
  std::size_t offset = 0;
  std::string pointer;
};

struct JsonNumber {
  double value = 0.0;     // the nearest double; -0 is 0
  bool tooLarge = false;  // beyond double; `value` is then infinite
  std::string_view text;
};

class JsonReader {
 public:
  enum class Kind { kObject, kArray, kString, kNumber, kBoolean, kNull };

  // The text must outlive the reader. A byte order mark is skipped.
  explicit JsonReader(std::string_view text);

  // The value that comes next, and where it begins.
  Kind kind();
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }

  // What was read since an offset.
  std::string_view textSince(std::size_t offset) const {
    return {begin_ + offset, this->offset() - offset};
  }

  // Each reads one value, of which kind() has told that it is of this kind.
  JsonNumber number();
  std::string string();
  bool boolean();
  void null() { literal("null"); }

  // enterObject(); while (nextMember()) { name() ... read one value ... }
  void enterObject() { enter(true); }
  bool nextMember();
  // Of the member whose value comes next: decoded (valid until the next member is read), as it
  // stands in the file with its quotes, and where that is.
  std::string_view name();
  std::string_view nameText() const { return level().nameText; }
  std::size_t nameOffset() const { return level().nameOffset; }

  // enterArray(); while (nextElement()) { ... read one value ... }
  void enterArray() { enter(false); }
  bool nextElement();

  // Reads any value and returns its text. Members that occur twice in an object are told to `twice`
  // when pointer() is that object's; null: nobody wants to know.
  using Twice = std::function<void(std::string_view name, std::size_t offset)>;
  std::string_view skip(const Twice* twice);

  // The same check for an object that the caller reads: remember the names from a mark on, and when
  // the object has ended, tell those that occurred twice.
  std::size_t nameMark() const { return names_.size(); }
  void rememberName();
  void tellTwice(std::size_t mark, const Twice& twice);

  // After the outermost value: nothing but white space may follow.
  void finish();

  // JSON pointer of the value that comes next or was read last.
  std::string pointer() const;

 private:
  struct Level {
    bool object = false;
    bool first = true;
    bool nameEscaped = false;
    std::string_view nameText;
    std::size_t nameOffset = 0;
    std::size_t index = 0;  // of the element that comes next
  };
  struct StringText {
    std::string_view inner;  // without its quotes
    bool escaped = false;
  };
  struct Name {
    std::string_view name;
    std::size_t offset = 0;
    bool decoded = false;  // stands in decoded_
  };

  const Level& level() const { return levels_[depth_ - 1]; }
  void enter(bool object);
  void leave() { --depth_; }
  void skipSpace();
  StringText scanString();
  void scanEscape();
  unsigned scanHex();
  void scanDigits();
  void literal(std::string_view word);
  [[noreturn]] void fail(Syntax expected, const char* where) const;

  const char* begin_;
  const char* end_;
  const char* at_;
  std::size_t depth_ = 0;
  std::array<Level, limits::kNesting> levels_;
  std::string name_;
  std::vector<Name> names_;          // remembered: of the objects that are entered, outer first
  std::deque<std::string> decoded_;  // those of them that had escapes
};

// The characters of a JSON string without its quotes, which JsonReader found to be right.
std::string decodeJsonString(std::string_view inner);

// Line and column (from 1, in code points) of an offset; a byte order mark has no column. Lines end
// with CR, LF or CRLF.
struct TextPlace {
  std::size_t line = 1;
  std::size_t column = 1;
};
TextPlace placeInText(std::string_view text, std::size_t offset);

}  // namespace vides
