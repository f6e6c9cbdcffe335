// SPDX-License-Identifier: MIT
// Reads single values and objects of a `.vid` against tables of their members, and collects what
// is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flight/flight.hpp"
#include "flight/limits.hpp"
#include "flight/problem.hpp"
#include "io/json_reader.hpp"

namespace vides {

// The first kMostProblems problems by their place in the file, in whatever order they are found.
class ProblemList {
 public:
  bool empty() const { return problems_.empty(); }
  // Whether a problem at that offset would be kept.
  bool wants(std::size_t offset) const;
  void add(std::size_t offset, Problem problem);
  std::vector<Problem> take();

 private:
  std::vector<std::pair<std::size_t, Problem>> problems_;  // sorted by offset
};

class VidValues;

// One member of an object T: how it is read, and what is expected where it is missing.
template <class T>
struct Member {
  std::string_view name;
  void (*read)(VidValues&, T&);
  Expectation (*required)() = nullptr;  // null: may be absent
};

class VidValues {
 public:
  explicit VidValues(std::string_view text);
  VidValues(const VidValues&) = delete;
  VidValues& operator=(const VidValues&) = delete;

  JsonReader& json() { return json_; }
  ProblemList& problems() { return problems_; }

  // The whole document: `read` reads its outermost value. What isn't JSON becomes a problem, and
  // nothing after it is read; what else `read` throws passes through.
  void document(const std::function<void()>& read);

  // Each reads the value that comes next. Where it isn't as wanted, the problem is noted and false
  // returned; `into` then keeps its value (of arrays: those elements that are wrong do).
  bool number(const Range& range, double& into);
  bool integer(const Range& range, int& into);
  bool numbers(const Range& range, std::span<double> into);
  // Also tells where it stands, if that is wanted.
  bool point(const Range& range, Vec3& into, std::size_t* offset = nullptr);
  bool boolean(bool& into);
  bool name(std::string& into);
  bool path(std::string& into);
  // Exactly this string.
  bool text(std::string_view wanted);

  template <class T>
  struct Choice {
    std::string_view name;
    T value;
  };
  template <class T>
  bool oneOf(std::span<const Choice<T>> choices, T& into);

  // What an object had: whether it was one, and which members of the table (by bit).
  struct Seen {
    bool object = false;
    std::uint32_t members = 0;
  };
  template <class T>
  Seen object(std::span<const Member<T>> members, T& into, Extra& extra);

  // Calls element(index), which reads one value, for each of at most count.max elements; the rest
  // is skipped. False if it isn't an array or the count isn't right.
  template <class Element>
  bool array(Expectation (*expected)(), const CountRange& count, Element element);

  void wrongType(Expectation expected);
  void note(std::size_t offset, ProblemCode code, std::string_view pointer, Expectation expected,
            std::string found = {});
  void skip() { json_.skip(nullptr); }

  // An object whose members have no table: read(name) reads one value, or returns false without
  // having read where it doesn't know the name. Such members are passed over.
  void members(const std::function<bool(const std::string& name)>& read);

 private:
  // Members that no table knows: their text, and where their names are remembered.
  struct Unknown {
    struct Text {
      std::string_view name;
      std::string_view value;
    };
    std::size_t mark = 0;
    std::vector<Text> texts;
  };

  template <class MakeExpectation>
  bool is(JsonReader::Kind kind, MakeExpectation expected) {
    if (json_.kind() == kind) return true;
    wrongType(expected());
    return false;
  }
  void outOfRange(std::size_t offset, Expectation expected, std::string_view found);
  void unknownMember(Unknown& unknown);
  void duplicateMember();
  void missingMember(std::string_view name, Expectation expected);
  void endObject(Unknown& unknown, Extra& extra);

  std::string_view text_;
  JsonReader json_;
  ProblemList problems_;
  JsonReader::Twice twice_;
};

Expectation expectKind(Expected kind);

template <class T>
VidValues::Seen VidValues::object(std::span<const Member<T>> members, T& into, Extra& extra) {
  Seen seen;
  if (!is(JsonReader::Kind::kObject, [] { return expectKind(Expected::kObject); })) return seen;
  seen.object = true;
  json_.enterObject();
  Unknown unknown{json_.nameMark(), {}};
  std::size_t likely = 0;  // files have the members in the order of the table
  while (json_.nextMember()) {
    const std::string_view name = json_.name();
    std::size_t index = likely;
    if (index == members.size() || members[index].name != name) {
      index = 0;
      while (index < members.size() && members[index].name != name) ++index;
    }
    if (index == members.size()) {
      unknownMember(unknown);
      continue;
    }
    const std::uint32_t bit = std::uint32_t{1} << index;
    if ((seen.members & bit) != 0) {
      duplicateMember();
      continue;
    }
    seen.members |= bit;
    likely = index + 1;
    members[index].read(*this, into);
  }
  endObject(unknown, extra);
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].required != nullptr && (seen.members >> i & 1u) == 0) {
      missingMember(members[i].name, members[i].required());
    }
  }
  return seen;
}

template <class Element>
bool VidValues::array(Expectation (*expected)(), const CountRange& count, Element element) {
  if (!is(JsonReader::Kind::kArray, expected)) return false;
  const std::size_t start = json_.offset();
  json_.enterArray();
  std::size_t size = 0;
  for (; json_.nextElement(); ++size) {
    if (size < count.max) {
      element(size);
    } else {
      skip();
    }
  }
  if (!count.contains(size)) {
    note(start, ProblemCode::kWrongCount, json_.pointer(), expected(), std::to_string(size));
  }
  return count.contains(size);
}

template <class T>
bool VidValues::oneOf(std::span<const Choice<T>> choices, T& into) {
  const auto expected = [&] {
    Expectation e = expectKind(Expected::kOneOf);
    for (const Choice<T>& choice : choices) {
      if (!e.text.empty()) e.text += ", ";
      ((e.text += '"') += choice.name) += '"';
    }
    return e;
  };
  if (!is(JsonReader::Kind::kString, expected)) return false;
  const std::size_t start = json_.offset();
  const std::string found = json_.string();
  for (const Choice<T>& choice : choices) {
    if (choice.name == found) {
      into = choice.value;
      return true;
    }
  }
  outOfRange(start, expected(), json_.textSince(start));
  return false;
}

}  // namespace vides
