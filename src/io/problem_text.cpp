// SPDX-License-Identifier: MIT
// The words for problems, a table a language, and how they become sentences.
#include "io/problem_text.hpp"

#include <fmt/format.h>

#include <iterator>

#include "flight/limits.hpp"
#include "flight/printable.hpp"
#include "flight/utf8.hpp"

namespace vides {
namespace {

// Every sentence and part of a sentence, with the places of its parts in braces.
struct Words {
  // Whole messages.
  const char* expectedFound;  // 0: what was expected, 1: what was found
  const char* missing;        // 0: what was expected
  const char* unknownMember;
  const char* notBeside;  // 0: the member that excludes this one
  const char* duplicate;
  const char* tooDeep;        // 0: the depth that is allowed
  const char* tooLarge;       // 0: bytes
  const char* newerVersion;   // 0: format of the file, 1: of this program
  const char* tooManyFrames;  // 0: allowed, 1: found
  const char* unreadable;     // 0: the system's reason
  const char* unwritable;

  // What was expected.
  const char* object;
  const char* array;
  const char* string;  // 0: most characters
  const char* path;
  const char* boolean;
  const char* integer;  // 0: range
  const char* number;
  const char* numbers;   // 0: count, 1: range
  const char* elements;  // 0: from, 1: to
  const char* exactElements;
  const char* point;  // 0: the distance from the origin
  const char* away;   // 0: the distance from the key
  const char* oneOf;  // 0: the choices
  const char* shape;

  // Ranges: 0: min, 1: max.
  const char* fromTo;
  const char* only;
  const char* greater;
  const char* greaterUpTo;
  const char* finite;

  // What was found.
  const char* anObject;
  const char* anArray;
  const char* endOfFile;
  const char* byte;  // 0: its value

  // Syntax, in the order of the enumeration.
  const char* syntax[16];
};

constexpr Words kEnglishWords = {
    .expectedFound = "expected {0}, found {1}",
    .missing = "missing; expected {0}",
    .unknownMember = "unknown member; only names that begin with x_ are free",
    .notBeside = "can't stand beside \"{0}\"",
    .duplicate = "stands twice in the same object",
    .tooDeep = "nested deeper than {0}",
    .tooLarge = "the file has more than {0} bytes",
    .newerVersion = "written by a newer vides (format {0}; this one reads up to {1})",
    .tooManyFrames = "expected at most {0} frames, found {1}",
    .unreadable = "can't be read: {0}",
    .unwritable = "can't be written: {0}",
    .object = "an object",
    .array = "an array",
    .string = "a string of at most {0} characters",
    .path = "the path of a file, in UTF-8",
    .boolean = "true or false",
    .integer = "an integer{0}",
    .number = "a number{0}",
    .numbers = "{0} numbers{1}",
    .elements = "an array of {0} to {1} elements",
    .exactElements = "an array of exactly {0} elements",
    .point = "a point at most {0} from the origin",
    .away = "an aim point at least {0} from the key",
    .oneOf = "one of {0}",
    .shape = "\"preset\", or \"tension\", \"continuity\" and \"bias\"",
    .fromTo = " from {0} to {1}",
    .only = " that is {0}",
    .greater = " greater than {0}",
    .greaterUpTo = " greater than {0}, up to {1}",
    .finite = "",
    .anObject = "an object",
    .anArray = "an array",
    .endOfFile = "the end of the file",
    .byte = "the byte {0}",
    .syntax = {"JSON", "a value", "a member's name in quotes", "a member's name in quotes or '}'",
               "':' after the member's name", "',' or '}'", "',' or ']'", "the end of the file",
               "a digit", "the closing quote of a string",
               "one of \" \\ / b f n r t u after the backslash",
               "four hexadecimal digits after \\u",
               "a low surrogate (\\uDC00 to \\uDFFF) after the high one",
               "a high surrogate (\\uD800 to \\uDBFF) before the low one",
               "an escape for a control character", "UTF-8"},
};

constexpr Words kGermanWords = {
    .expectedFound = "erwartet: {0}; gefunden: {1}",
    .missing = "fehlt; erwartet: {0}",
    .unknownMember = "unbekannter Eintrag; frei sind nur Namen, die mit x_ beginnen",
    .notBeside = "kann nicht neben „{0}“ stehen",
    .duplicate = "steht zweimal im selben Objekt",
    .tooDeep = "tiefer verschachtelt als {0}",
    .tooLarge = "die Datei hat mehr als {0} Bytes",
    .newerVersion =
        "von einem neueren vides geschrieben (Format {0}; dieses liest Formate bis {1})",
    .tooManyFrames = "erwartet: höchstens {0} Zwischenpositionen; gefunden: {1}",
    .unreadable = "nicht lesbar: {0}",
    .unwritable = "nicht zu schreiben: {0}",
    .object = "ein Objekt",
    .array = "eine Liste",
    .string = "ein Text von höchstens {0} Zeichen",
    .path = "der Pfad einer Datei, in UTF-8",
    .boolean = "true oder false",
    .integer = "eine ganze Zahl{0}",
    .number = "eine Zahl{0}",
    .numbers = "{0} Zahlen{1}",
    .elements = "eine Liste von {0} bis {1} Elementen",
    .exactElements = "eine Liste von genau {0} Elementen",
    .point = "ein Punkt, höchstens {0} vom Ursprung entfernt",
    .away = "ein Blickpunkt, mindestens {0} vom Stützpunkt entfernt",
    .oneOf = "eines von {0}",
    .shape = "„preset“ oder „tension“, „continuity“ und „bias“",
    .fromTo = " von {0} bis {1}",
    .only = ", und zwar {0}",
    .greater = " größer als {0}",
    .greaterUpTo = " größer als {0}, höchstens {1}",
    .finite = "",
    .anObject = "ein Objekt",
    .anArray = "eine Liste",
    .endOfFile = "das Ende der Datei",
    .byte = "das Byte {0}",
    .syntax = {"JSON", "ein Wert", "der Name eines Eintrags in Anführungszeichen",
               "der Name eines Eintrags in Anführungszeichen oder '}'",
               "':' nach dem Namen des Eintrags", "',' oder '}'", "',' oder ']'",
               "das Ende der Datei", "eine Ziffer",
               "das schließende Anführungszeichen eines Textes",
               "eines von \" \\ / b f n r t u nach dem umgekehrten Schrägstrich",
               "vier hexadezimale Ziffern nach \\u",
               "ein unteres Surrogat (\\uDC00 bis \\uDFFF) nach dem oberen",
               "ein oberes Surrogat (\\uD800 bis \\uDBFF) vor dem unteren",
               "eine Ersatzdarstellung für ein Steuerzeichen", "UTF-8"},
};

const Words& wordsOf(Language language) {
  switch (language) {
    case Language::kEnglish:
      return kEnglishWords;
    case Language::kGerman:
      return kGermanWords;
  }
  return kEnglishWords;
}

template <class... Parts>
std::string put(const char* sentence, const Parts&... parts) {
  return fmt::format(fmt::runtime(sentence), parts...);
}

// Numbers as in the file.
std::string number(double value) { return fmt::format("{}", value); }

std::string range(const Expectation& e, const Words& words) {
  if (e.max >= limits::kFinite && e.min <= -limits::kFinite) return words.finite;
  if (e.min == e.max) return put(words.only, number(e.min));
  if (e.max >= limits::kFinite) return put(words.greater, number(e.min));
  return put(e.minOpen ? words.greaterUpTo : words.fromTo, number(e.min), number(e.max));
}

std::string expectedText(const Expectation& e, const Words& words) {
  switch (e.kind) {
    case Expected::kNothing:
    case Expected::kNoMember:
    case Expected::kNotBeside:
      return {};
    case Expected::kValue:
      return e.text;
    case Expected::kObject:
      return words.object;
    case Expected::kArray:
      return words.array;
    case Expected::kString:
      return put(words.string, number(e.max));
    case Expected::kPath:
      return words.path;
    case Expected::kBoolean:
      return words.boolean;
    case Expected::kInteger:
      return put(words.integer, range(e, words));
    case Expected::kNumber:
      return put(words.number, range(e, words));
    case Expected::kNumbers:
      return put(words.numbers, e.count, range(e, words));
    case Expected::kCount:
      return e.min == e.max ? put(words.exactElements, number(e.min))
                            : put(words.elements, number(e.min), number(e.max));
    case Expected::kPoint:
      return put(words.point, number(e.max));
    case Expected::kAway:
      return put(words.away, number(e.min));
    case Expected::kOneOf:
      return put(words.oneOf, e.text);
    case Expected::kShape:
      return words.shape;
  }
  return {};
}

std::string foundText(const std::string& found, const Words& words) {
  if (found == "{…}") return words.anObject;
  if (found == "[…]") return words.anArray;
  return found;
}

std::string syntaxText(const Problem& problem, const Words& words) {
  const std::string& found = problem.found;
  std::string what = found;
  if (found.empty()) {
    what = words.endOfFile;
  } else if (found.size() > 1 && found.starts_with('\\')) {
    what = put(words.byte, "0" + found.substr(1));
  } else if (!found.starts_with("U+") && !found.starts_with("UTF-")) {
    what = "'" + found + "'";
  }
  const auto index = static_cast<std::size_t>(problem.syntax);
  return put(words.expectedFound, words.syntax[index], what);
}

std::string message(const Problem& p, const Words& words) {
  switch (p.code) {
    case ProblemCode::kSyntax:
      return syntaxText(p, words);
    case ProblemCode::kTooDeep:
      return put(words.tooDeep, number(p.expected.max));
    case ProblemCode::kTooLarge:
      return put(words.tooLarge, number(p.expected.max));
    case ProblemCode::kNewerVersion:
      return put(words.newerVersion, p.found, number(p.expected.max));
    case ProblemCode::kMissing:
      return put(words.missing, expectedText(p.expected, words));
    case ProblemCode::kUnknownMember:
      return p.expected.kind == Expected::kNotBeside ? put(words.notBeside, p.expected.text)
                                                     : words.unknownMember;
    case ProblemCode::kDuplicate:
      return words.duplicate;
    case ProblemCode::kTooManyFrames:
      return put(words.tooManyFrames, number(p.expected.max), p.found);
    case ProblemCode::kUnreadable:
      return put(words.unreadable, p.found);
    case ProblemCode::kUnwritable:
      return put(words.unwritable, p.found);
    case ProblemCode::kWrongType:
    case ProblemCode::kOutOfRange:
    case ProblemCode::kWrongCount:
    case ProblemCode::kAimAtKey:
      return put(words.expectedFound, expectedText(p.expected, words), foundText(p.found, words));
  }
  return {};
}

// A line stays a line, and a terminal a terminal, whatever a file holds: control characters (C0,
// DEL, C1) become escapes, as they are written in JSON, and so do bytes that aren't UTF-8.
std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const auto first = static_cast<unsigned char>(text.front());
    if (length == 0) {
      fmt::format_to(std::back_inserter(out), "\\x{:02X}", static_cast<unsigned>(first));
    } else if (first < 0x20 || first == 0x7F) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(first));
    } else if (first == 0xC2 && static_cast<unsigned char>(text[1]) < 0xA0) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}",
                     static_cast<unsigned>(static_cast<unsigned char>(text[1])));
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

}  // namespace

std::string problemText(const Problem& problem, Language language) {
  return escaped(message(problem, wordsOf(language)));
}

std::string problemLine(std::string_view file, const Problem& problem, Language language) {
  std::string line = printable(file);
  if (problem.line > 0) {
    line += fmt::format(":{}:{}", problem.line, problem.column);
  } else if (!problem.pointer.empty()) {
    (line += ": ") += escaped(problem.pointer);
  }
  return (line += ": ") += problemText(problem, language);
}

}  // namespace vides
