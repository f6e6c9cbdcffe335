// SPDX-License-Identifier: MIT
// Single values of a `.vid`, and the bookkeeping of problems.
#include "io/vid_values.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "flight/utf8.hpp"
#include "flight/validation.hpp"

namespace vides {
namespace {

constexpr std::string_view kKeptPrefix = "x_";

Problem syntaxProblem(std::string_view text, const SyntaxError& error) {
  Problem problem;
  const TextPlace place = placeInText(text, error.offset);
  problem.line = static_cast<std::int64_t>(place.line);
  problem.column = static_cast<std::int64_t>(place.column);
  problem.syntax = error.expected;
  problem.found = error.found;
  return problem;
}

Problem tooDeep(const TooDeep& deep) {
  Problem problem;
  problem.code = ProblemCode::kTooDeep;
  problem.pointer = deep.pointer;
  problem.expected.max = static_cast<double>(limits::kNesting);
  return problem;
}

}  // namespace

Expectation expectKind(Expected kind) {
  Expectation expected;
  expected.kind = kind;
  return expected;
}

bool ProblemList::wants(std::size_t offset) const {
  return problems_.size() < kMostProblems || offset < problems_.back().first;
}

void ProblemList::add(std::size_t offset, Problem problem) {
  if (!wants(offset)) return;
  const auto after = std::upper_bound(problems_.begin(), problems_.end(), offset,
                                      [](std::size_t o, const auto& p) { return o < p.first; });
  problems_.emplace(after, offset, std::move(problem));
  if (problems_.size() > kMostProblems) problems_.pop_back();
}

std::vector<Problem> ProblemList::take() {
  std::vector<Problem> list;
  list.reserve(problems_.size());
  for (auto& [offset, problem] : problems_) list.push_back(std::move(problem));
  problems_.clear();
  return list;
}

VidValues::VidValues(std::string_view text) : text_(text), json_(text) {
  twice_ = [this](std::string_view name, std::size_t offset) {
    if (!problems_.wants(offset)) return;
    note(offset, ProblemCode::kDuplicate, json_.pointer() + pointerToken(name), {});
  };
}

void VidValues::document(const std::function<void()>& read) {
  try {
    read();
    json_.finish();
  } catch (const SyntaxError& error) {
    problems_.add(error.offset, syntaxProblem(text_, error));
  } catch (const TooDeep& deep) {
    problems_.add(deep.offset, tooDeep(deep));
  }
}

void VidValues::members(const std::function<bool(const std::string& name)>& read) {
  if (!is(JsonReader::Kind::kObject, [] { return expectKind(Expected::kObject); })) return;
  std::set<std::string> seen;
  json_.enterObject();
  while (json_.nextMember()) {
    const std::string name(json_.name());
    if (!seen.insert(name).second) {
      duplicateMember();
    } else if (!read(name)) {
      skip();
    }
  }
}

void VidValues::note(std::size_t offset, ProblemCode code, std::string_view pointer,
                     Expectation expected, std::string found) {
  Problem problem;
  problem.code = code;
  problem.pointer = pointer;
  problem.expected = std::move(expected);
  problem.found = std::move(found);
  problems_.add(offset, std::move(problem));
}

void VidValues::wrongType(Expectation expected) {
  const JsonReader::Kind kind = json_.kind();
  const std::size_t start = json_.offset();
  const std::string_view text = json_.skip(nullptr);
  if (!problems_.wants(start)) return;
  std::string found = kind == JsonReader::Kind::kObject  ? "{…}"
                      : kind == JsonReader::Kind::kArray ? "[…]"
                                                         : shortened(text);
  note(start, ProblemCode::kWrongType, json_.pointer(), std::move(expected), std::move(found));
}

void VidValues::outOfRange(std::size_t offset, Expectation expected, std::string_view found) {
  if (!problems_.wants(offset)) return;
  note(offset, ProblemCode::kOutOfRange, json_.pointer(), std::move(expected), shortened(found));
}

bool VidValues::number(const Range& range, double& into) {
  const auto expected = [&] { return expectNumber(range); };
  if (!is(JsonReader::Kind::kNumber, expected)) return false;
  const std::size_t start = json_.offset();
  const JsonNumber found = json_.number();
  if (!range.contains(found.value)) {
    outOfRange(start, expected(), found.text);
    return false;
  }
  into = found.value;
  return true;
}

bool VidValues::integer(const Range& range, int& into) {
  const auto expected = [&] { return expectInteger(range); };
  if (!is(JsonReader::Kind::kNumber, expected)) return false;
  const std::size_t start = json_.offset();
  const JsonNumber found = json_.number();
  if (std::trunc(found.value) != found.value) {
    note(start, ProblemCode::kWrongType, json_.pointer(), expected(), shortened(found.text));
    return false;
  }
  if (!range.contains(found.value)) {
    outOfRange(start, expected(), found.text);
    return false;
  }
  into = static_cast<int>(found.value);
  return true;
}

bool VidValues::numbers(const Range& range, std::span<double> into) {
  const auto expected = [&] { return expectNumbers(static_cast<int>(into.size()), range); };
  if (!is(JsonReader::Kind::kArray, expected)) return false;
  const std::size_t start = json_.offset();
  bool good = true;
  std::size_t size = 0;
  json_.enterArray();
  for (; json_.nextElement(); ++size) {
    if (size < into.size()) {
      good = number(range, into[size]) && good;
    } else {
      skip();
    }
  }
  if (size == into.size()) return good;
  note(start, ProblemCode::kWrongCount, json_.pointer(), expected(), std::to_string(size));
  return false;
}

bool VidValues::point(const Range& range, Vec3& into, std::size_t* offset) {
  json_.kind();  // now the value begins here
  if (offset != nullptr) *offset = json_.offset();
  double values[3] = {into.x, into.y, into.z};
  if (!numbers(range, values)) return false;
  into = {values[0], values[1], values[2]};
  return true;
}

bool VidValues::boolean(bool& into) {
  if (!is(JsonReader::Kind::kBoolean, [] { return expectKind(Expected::kBoolean); })) return false;
  into = json_.boolean();
  return true;
}

bool VidValues::name(std::string& into) {
  const auto expected = [] {
    Expectation e = expectKind(Expected::kString);
    e.max = static_cast<double>(limits::kNameCharacters);
    return e;
  };
  if (!is(JsonReader::Kind::kString, expected)) return false;
  const std::size_t start = json_.offset();
  std::string found = json_.string();
  if (codePoints(found) > limits::kNameCharacters) {
    outOfRange(start, expected(), json_.textSince(start));
    return false;
  }
  into = std::move(found);
  return true;
}

bool VidValues::path(std::string& into) {
  const auto expected = [] { return expectKind(Expected::kPath); };
  if (!is(JsonReader::Kind::kString, expected)) return false;
  const std::size_t start = json_.offset();
  std::string found = json_.string();
  if (checkPath(found, {})) {
    outOfRange(start, expected(), json_.textSince(start));
    return false;
  }
  into = std::move(found);
  return true;
}

bool VidValues::text(std::string_view wanted) {
  const auto expected = [&] {
    Expectation e = expectKind(Expected::kValue);
    e.text = '"' + std::string(wanted) + '"';
    return e;
  };
  if (!is(JsonReader::Kind::kString, expected)) return false;
  const std::size_t start = json_.offset();
  if (json_.string() == wanted) return true;
  outOfRange(start, expected(), json_.textSince(start));
  return false;
}

void VidValues::unknownMember(Unknown& unknown) {
  if (json_.name().starts_with(kKeptPrefix)) {
    json_.rememberName();
    const std::string_view name = json_.nameText();
    unknown.texts.push_back({name, json_.skip(&twice_)});
    return;
  }
  const std::size_t start = json_.nameOffset();
  if (problems_.wants(start)) {
    note(start, ProblemCode::kUnknownMember, json_.pointer(), expectKind(Expected::kNoMember));
  }
  skip();
}

void VidValues::duplicateMember() {
  const std::size_t start = json_.nameOffset();
  if (problems_.wants(start)) note(start, ProblemCode::kDuplicate, json_.pointer(), {});
  skip();
}

void VidValues::missingMember(std::string_view name, Expectation expected) {
  const std::size_t end = json_.offset();
  if (!problems_.wants(end)) return;
  note(end, ProblemCode::kMissing, json_.pointer() + pointerToken(name), std::move(expected));
}

void VidValues::endObject(Unknown& unknown, Extra& extra) {
  if (unknown.texts.empty()) return;
  json_.tellTwice(unknown.mark, twice_);
  auto members = std::make_shared<ExtraMembers>();
  members->reserve(unknown.texts.size());
  for (const Unknown::Text& text : unknown.texts) members->emplace_back(text.name, text.value);
  extra = std::move(members);
}

}  // namespace vides
