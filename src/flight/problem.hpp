// SPDX-License-Identifier: MIT
// What is wrong with a flight or a file, structured: put into words (and languages) only at the
// edge.
#pragma once

#include <cstdint>
#include <string>

namespace vides {

enum class ProblemCode {
  kSyntax,         // not JSON; line and column tell where
  kTooDeep,        // nesting deeper than 32
  kTooLarge,       // file over 1 GiB
  kNewerVersion,   // written by a newer vides
  kMissing,        // a required member is absent
  kUnknownMember,  // a member that this version doesn't know
  kDuplicate,      // a member twice in one object
  kWrongType,      // another type than expected
  kOutOfRange,     // the type is right, the value isn't
  kWrongCount,     // too few or too many elements
  kAimAtKey,       // the aim point is closer than 1e-9 to its key
  kTooManyFrames,  // more than 2,000,000,000 frames
  kUnreadable,     // the file can't be opened or read; `found` is the system's reason
};

// What should have stood there. The numbers count where the kind names a range.
enum class Expected {
  kNothing,
  kValue,  // `text` says it in JSON, e.g. "vides"
  kObject,
  kArray,
  kString,  // at most `max` characters
  kBoolean,
  kInteger,   // min to max
  kNumber,    // min to max, either end open where minOpen is set
  kNumbers,   // `count` numbers, each min to max
  kCount,     // min to max elements
  kOneOf,     // `text` lists the choices
  kNoMember,  // no such member; names that begin with x_ are kept
  kOnce,      // the member once
};

struct Expectation {
  Expected kind = Expected::kNothing;
  double min = 0.0;
  double max = 0.0;
  bool minOpen = false;  // the value must be greater than min
  int count = 0;
  std::string text;
};

struct Problem {
  ProblemCode code = ProblemCode::kSyntax;
  std::string pointer;      // JSON pointer, e.g. /keys/3/orientations/0/zoom; empty for syntax
  std::int64_t line = 0;    // from 1, for syntax errors; 0 otherwise
  std::int64_t column = 0;  // from 1, in characters
  Expectation expected;
  std::string found;  // as JSON text, shortened; or the system's or the parser's reason
};

}  // namespace vides
