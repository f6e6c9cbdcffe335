// SPDX-License-Identifier: MIT
// What is wrong with a flight or a file, structured: put into words (and languages) only at the
// edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace vides {

// Of one flight or file at most so many problems are told at once.
inline constexpr std::size_t kMostProblems = 20;

enum class ProblemCode {
  kSyntax,         // not JSON; line and column tell where, `syntax` what
  kTooDeep,        // nesting deeper than `expected.max`
  kTooLarge,       // file of more than `expected.max` bytes
  kNewerVersion,   // written by a newer vides; `found` is its format, `expected.max` ours
  kMissing,        // a required member is absent
  kUnknownMember,  // a member that this version doesn't know, or that can't stand here
  kDuplicate,      // a member twice in one object
  kWrongType,      // another type than expected
  kOutOfRange,     // the type is right, the value isn't
  kWrongCount,     // too few or too many elements
  kAimAtKey,       // the aim point is closer than `expected.min` to its key
  kTooManyFrames,  // more than `expected.max` frames
  kUnreadable,     // the file can't be opened or read; `found` is the system's reason
  kUnwritable,     // the file can't be written; `found` is the system's reason
};

// What should have stood where the text stops being JSON.
enum class Syntax {
  kNone,
  kValue,                // a value
  kMemberName,           // a member's name in quotes
  kMemberNameOrEnd,      // a member's name, or the end of the object
  kColon,                // ':' after a member's name
  kCommaOrEndOfObject,   // ',' or '}'
  kCommaOrEndOfArray,    // ',' or ']'
  kEndOfFile,            // nothing more
  kDigit,                // a digit of a number
  kClosingQuote,         // the end of a string
  kEscape,               // one of " \ / b f n r t u
  kHexDigit,             // four hexadecimal digits after \u
  kLowSurrogate,         // \uDC00 to \uDFFF after \uD800 to \uDBFF
  kHighSurrogateBefore,  // \uDC00 to \uDFFF stands alone
  kNoControlCharacter,   // control characters in strings are written as escapes
  kUtf8,                 // bytes that are UTF-8
};

// What should have stood there. The numbers count where the kind names a range.
enum class Expected {
  kNothing,
  kValue,  // `text` says it in JSON, e.g. "vides"
  kObject,
  kArray,
  kString,  // at most `max` characters
  kPath,    // a string that can name a file
  kBoolean,
  kInteger,    // min to max
  kNumber,     // min to max; greater than min where minOpen is set
  kNumbers,    // `count` numbers, each min to max
  kCount,      // min to max elements
  kPoint,      // three numbers, together at most `max` from the origin
  kAway,       // a point at least `min` from the key
  kOneOf,      // `text` lists the choices in JSON, separated by ", "
  kShape,      // "preset", or "tension", "continuity" and "bias"
  kNoMember,   // no such member; names that begin with x_ are kept
  kNotBeside,  // no such member beside the member `text`
};

struct Expectation {
  Expected kind = Expected::kNothing;
  double min = 0.0;
  double max = 0.0;
  bool minOpen = false;  // the value must be greater than min
  int count = 0;
  std::string text;
  bool operator==(const Expectation&) const = default;
};

struct Problem {
  ProblemCode code = ProblemCode::kSyntax;
  // JSON pointer, e.g. /keys/3/orientations/0/zoom; long names are shortened. Empty for the whole
  // document, and for syntax.
  std::string pointer;
  std::int64_t line = 0;    // from 1, for syntax errors; 0 otherwise
  std::int64_t column = 0;  // from 1, in characters
  Syntax syntax = Syntax::kNone;
  Expectation expected;
  // JSON text, shortened ("{…}" and "[…]" for objects and arrays). Of syntax errors the word or
  // character that was found, or "U+000A", "\xFF" for characters and bytes that can't be shown;
  // empty for the end of the file. Or the system's reason.
  std::string found;
  bool operator==(const Problem&) const = default;
};

// JSON text for Problem::found: as it is, or its first characters and "…". UTF-8 stays UTF-8.
std::string shortened(std::string_view text);
// One reference token of a JSON pointer with its slash: '~' and '/' escaped, long names shortened.
std::string pointerToken(std::string_view name);

}  // namespace vides
