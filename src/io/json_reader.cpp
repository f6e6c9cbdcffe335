// SPDX-License-Identifier: MIT
// Scans JSON text.
#include "io/json_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "flight/text_encoding.hpp"
#include "flight/utf8.hpp"

namespace vides {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isWordPart(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' || c == '-' ||
         c == '.' || c == '_';
}

// Characters of a string that need no second look.
constexpr auto kPlain = [] {
  std::array<bool, 256> plain{};
  for (std::size_t c = 0x20; c < 0x80; ++c) plain[c] = c != '"' && c != '\\';
  return plain;
}();

// What stands at a place of the text, as Problem::found wants it.
std::string characterAt(const char* at, const char* end) {
  if (at == end) return {};
  const auto byte = static_cast<unsigned char>(*at);
  if (byte < 0x20 || byte == 0x7F) return fmt::format("U+{:04X}", byte);
  const std::string_view rest(at, static_cast<std::size_t>(end - at));
  const std::size_t length = utf8Length(rest);
  if (length == 0) return fmt::format("\\x{:02X}", byte);
  return std::string(rest.substr(0, length));
}

void appendUtf8(std::string& out, unsigned code) {
  const auto add = [&](unsigned byte) { out.push_back(static_cast<char>(byte)); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | code >> 6);
    add(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12);
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  } else {
    add(0xF0 | code >> 18);
    add(0x80 | (code >> 12 & 0x3F));
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  }
}

unsigned hexValue(char c) {
  if (isDigit(c)) return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  return 16;
}

unsigned hex4(std::string_view digits) {
  unsigned code = 0;
  for (std::size_t i = 0; i < 4; ++i) code = code << 4 | hexValue(digits[i]);
  return code;
}

// A number's text that is right in JSON, as a double.
JsonNumber converted(std::string_view text) {
  JsonNumber number;
  number.text = text;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number.value);
  if (error == std::errc::result_out_of_range) {
    // Too large or too small? The text is "d…": compare the exponent of its first digit that isn't
    // 0 with the one that is written. Doubles reach from 1e-324 to 1e309, far from where this could
    // be in doubt.
    const std::size_t exponentAt = text.find_first_of("eE");
    const std::string_view mantissa = text.substr(0, exponentAt);
    double written = 0.0;
    if (exponentAt != text.npos) {
      std::string_view digits = text.substr(exponentAt + 1);
      const bool negative = digits.front() == '-';
      if (negative || digits.front() == '+') digits.remove_prefix(1);
      for (const char c : digits) written = std::min(written * 10.0 + (c - '0'), 1e18);
      if (negative) written = -written;
    }
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_of("123456789");
    const double place = static_cast<double>(point) - static_cast<double>(first);
    number.tooLarge = written + place > 0.0;
    number.value = number.tooLarge ? std::numeric_limits<double>::infinity() : 0.0;
    if (number.tooLarge && text.front() == '-') number.value = -number.value;
  }
  if (number.value == 0.0) number.value = 0.0;  // not -0
  return number;
}

}  // namespace

JsonReader::JsonReader(std::string_view text)
    : begin_(text.data()), end_(text.data() + text.size()), at_(begin_) {
  at_ += text.size() - withoutByteOrderMark(text).size();
}

void JsonReader::fail(Syntax expected, const char* where) const {
  // No text in another encoding gets beyond its first character or two.
  const TextEncoding encoding = encodingOf({begin_, static_cast<std::size_t>(end_ - begin_)});
  if (encoding != TextEncoding::kUtf8) throw SyntaxError{Syntax::kUtf8, 0, vides::name(encoding)};
  std::string found = characterAt(where, end_);
  if (expected == Syntax::kValue && where != end_ && isWordPart(*where)) {
    const char* last = std::find_if_not(where, std::min(end_, where + 30), isWordPart);
    found.assign(where, last);
  }
  throw SyntaxError{expected, static_cast<std::size_t>(where - begin_), std::move(found)};
}

void JsonReader::skipSpace() {
  while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t')) ++at_;
}

JsonReader::Kind JsonReader::kind() {
  skipSpace();
  if (at_ == end_) fail(Syntax::kValue, at_);
  switch (*at_) {
    case '{':
      return Kind::kObject;
    case '[':
      return Kind::kArray;
    case '"':
      return Kind::kString;
    case 't':
    case 'f':
      return Kind::kBoolean;
    case 'n':
      return Kind::kNull;
    default:
      if (*at_ == '-' || isDigit(*at_)) return Kind::kNumber;
      fail(Syntax::kValue, at_);
  }
}

void JsonReader::scanDigits() {
  if (at_ == end_ || !isDigit(*at_)) fail(Syntax::kDigit, at_);
  while (at_ != end_ && isDigit(*at_)) ++at_;
}

JsonNumber JsonReader::number() {
  const char* const start = at_;
  if (*at_ == '-') ++at_;
  if (at_ != end_ && *at_ == '0') {
    ++at_;
  } else {
    scanDigits();
  }
  if (at_ != end_ && *at_ == '.') {
    ++at_;
    scanDigits();
  }
  if (at_ != end_ && (*at_ == 'e' || *at_ == 'E')) {
    ++at_;
    if (at_ != end_ && (*at_ == '+' || *at_ == '-')) ++at_;
    scanDigits();
  }
  if (at_ != end_ && isWordPart(*at_)) fail(Syntax::kValue, start);  // 025, 0x19, 1.2.3
  return converted({start, static_cast<std::size_t>(at_ - start)});
}

unsigned JsonReader::scanHex() {
  for (int i = 0; i < 4; ++i, ++at_) {
    if (at_ == end_ || hexValue(*at_) > 15) fail(Syntax::kHexDigit, at_);
  }
  return hex4({at_ - 4, 4});
}

// at_ stands on the backslash.
void JsonReader::scanEscape() {
  const char* const start = at_++;
  if (at_ == end_) fail(Syntax::kEscape, at_);
  const char c = *at_;
  if (c != 'u') {
    if (std::string_view("\"\\/bfnrt").find(c) == std::string_view::npos) {
      fail(Syntax::kEscape, at_);
    }
    ++at_;
    return;
  }
  ++at_;
  const unsigned code = scanHex();
  if (code >= 0xDC00 && code <= 0xDFFF) fail(Syntax::kHighSurrogateBefore, start);
  if (code < 0xD800 || code > 0xDBFF) return;
  const char* const second = at_;
  if (end_ - at_ < 2 || at_[0] != '\\' || at_[1] != 'u') fail(Syntax::kLowSurrogate, at_);
  at_ += 2;
  const unsigned low = scanHex();
  if (low < 0xDC00 || low > 0xDFFF) fail(Syntax::kLowSurrogate, second);
}

// at_ stands on the opening quote.
JsonReader::StringText JsonReader::scanString() {
  StringText text;
  const char* const start = ++at_;
  while (true) {
    while (at_ != end_ && kPlain[static_cast<unsigned char>(*at_)]) ++at_;
    if (at_ == end_) fail(Syntax::kClosingQuote, at_);
    if (*at_ == '"') break;
    if (*at_ == '\\') {
      text.escaped = true;
      scanEscape();
    } else if (static_cast<unsigned char>(*at_) < 0x20) {
      fail(Syntax::kNoControlCharacter, at_);
    } else {
      const std::size_t length = utf8Length({at_, static_cast<std::size_t>(end_ - at_)});
      if (length == 0) fail(Syntax::kUtf8, at_);
      at_ += length;
    }
  }
  text.inner = {start, static_cast<std::size_t>(at_ - start)};
  ++at_;
  return text;
}

std::string JsonReader::string() {
  const StringText text = scanString();
  return text.escaped ? decodeJsonString(text.inner) : std::string(text.inner);
}

void JsonReader::literal(std::string_view word) {
  const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
  if (!rest.starts_with(word) || (rest.size() > word.size() && isWordPart(rest[word.size()]))) {
    fail(Syntax::kValue, at_);
  }
  at_ += word.size();
}

bool JsonReader::boolean() {
  const bool value = *at_ == 't';
  literal(value ? "true" : "false");
  return value;
}

void JsonReader::enter(bool object) {
  if (depth_ == limits::kNesting) throw TooDeep{offset(), pointer()};
  ++at_;
  levels_[depth_] = Level{};
  levels_[depth_].object = object;
  ++depth_;
}

bool JsonReader::nextMember() {
  Level& level = levels_[depth_ - 1];
  skipSpace();
  if (at_ != end_ && *at_ == '}') {
    ++at_;
    leave();
    return false;
  }
  Syntax expected = Syntax::kMemberNameOrEnd;
  if (!level.first) {
    if (at_ == end_ || *at_ != ',') fail(Syntax::kCommaOrEndOfObject, at_);
    ++at_;
    skipSpace();
    expected = Syntax::kMemberName;
  }
  level.first = false;
  if (at_ == end_ || *at_ != '"') fail(expected, at_);
  level.nameOffset = offset();
  const char* const start = at_;
  level.nameEscaped = scanString().escaped;
  level.nameText = {start, static_cast<std::size_t>(at_ - start)};
  skipSpace();
  if (at_ == end_ || *at_ != ':') fail(Syntax::kColon, at_);
  ++at_;
  return true;
}

std::string_view JsonReader::name() {
  const Level& now = level();
  const std::string_view inner = now.nameText.substr(1, now.nameText.size() - 2);
  if (!now.nameEscaped) return inner;
  name_ = decodeJsonString(inner);
  return name_;
}

bool JsonReader::nextElement() {
  Level& level = levels_[depth_ - 1];
  skipSpace();
  if (level.first) {
    level.first = false;
    if (at_ != end_ && *at_ == ']') {
      ++at_;
      leave();
      return false;
    }
    return true;
  }
  if (at_ != end_ && *at_ == ',') {
    ++at_;
    ++level.index;
    return true;
  }
  if (at_ == end_ || *at_ != ']') fail(Syntax::kCommaOrEndOfArray, at_);
  ++at_;
  leave();
  return false;
}

std::string_view JsonReader::skip(const Twice* twice) {
  const Kind next = kind();
  const char* const start = at_;
  switch (next) {
    case Kind::kNumber:
      number();
      break;
    case Kind::kString:
      scanString();
      break;
    case Kind::kBoolean:
      boolean();
      break;
    case Kind::kNull:
      null();
      break;
    case Kind::kArray:
      enterArray();
      while (nextElement()) skip(twice);
      break;
    case Kind::kObject: {
      const std::size_t mark = nameMark();
      enterObject();
      while (nextMember()) {
        if (twice != nullptr) rememberName();
        skip(twice);
      }
      if (twice != nullptr) tellTwice(mark, *twice);
      break;
    }
  }
  return {start, static_cast<std::size_t>(at_ - start)};
}

void JsonReader::rememberName() {
  const bool escaped = level().nameEscaped;
  std::string_view text = name();
  if (escaped) text = decoded_.emplace_back(text);
  names_.push_back({text, nameOffset(), escaped});
}

void JsonReader::tellTwice(std::size_t mark, const Twice& twice) {
  const auto first = names_.begin() + static_cast<std::ptrdiff_t>(mark);
  std::sort(first, names_.end(), [](const Name& a, const Name& b) {
    const int order = a.name.compare(b.name);
    return order != 0 ? order < 0 : a.offset < b.offset;
  });
  for (auto it = first; it != names_.end(); ++it) {
    if (it != first && it->name == (it - 1)->name) twice(it->name, it->offset);
  }
  // Both are stacks: what this object put on top goes.
  const auto decoded = std::count_if(first, names_.end(), [](const Name& n) { return n.decoded; });
  decoded_.resize(decoded_.size() - static_cast<std::size_t>(decoded));
  names_.erase(first, names_.end());
}

void JsonReader::finish() {
  skipSpace();
  if (at_ != end_) fail(Syntax::kEndOfFile, at_);
}

std::string JsonReader::pointer() const {
  std::string pointer;
  for (std::size_t i = 0; i < depth_; ++i) {
    const Level& now = levels_[i];
    if (now.object) {
      const std::string_view inner = now.nameText.substr(1, now.nameText.size() - 2);
      pointer += now.nameEscaped ? pointerToken(decodeJsonString(inner)) : pointerToken(inner);
    } else {
      (pointer += '/') += std::to_string(now.index);
    }
  }
  return pointer;
}

std::string decodeJsonString(std::string_view inner) {
  std::string out;
  out.reserve(inner.size());
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i] != '\\') {
      out.push_back(inner[i]);
      continue;
    }
    constexpr std::string_view kLetters = "bfnrt";
    constexpr std::string_view kControls = "\b\f\n\r\t";
    const char c = inner[++i];
    if (c != 'u') {
      const std::size_t control = kLetters.find(c);
      out.push_back(control == kLetters.npos ? c : kControls[control]);
      continue;
    }
    unsigned code = hex4(inner.substr(i + 1));
    i += 4;
    if (code >= 0xD800 && code <= 0xDBFF) {
      code = 0x10000 + ((code - 0xD800) << 10) + (hex4(inner.substr(i + 3)) - 0xDC00);
      i += 6;
    }
    appendUtf8(out, code);
  }
  return out;
}

TextPlace placeInText(std::string_view text, std::size_t offset) {
  TextPlace place;
  std::size_t start = text.size() - withoutByteOrderMark(text).size();
  for (std::size_t i = start; i < offset; ++i) {
    // A CR before an LF is part of the line's end.
    if (text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'))) {
      ++place.line;
      start = i + 1;
    }
  }
  // Continuation bytes don't begin a character.
  for (std::size_t i = start; i < offset; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) ++place.column;
  }
  return place;
}

}  // namespace vides
