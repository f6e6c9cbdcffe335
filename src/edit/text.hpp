// SPDX-License-Identifier: MIT
// What the program says, as a value: a key into the translation table and the parts to be put in.
//
// Text is made wherever something is told and becomes words only where it is shown
// (edit/texts.hpp), so that the language can be switched while it stands there. Keys, orientations
// and presets are given as they are shown: keys and orientations counted from 1.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "flight/problem.hpp"
#include "math/vector.hpp"

namespace vides {

struct Text;

// A part of a text, which the table's words have as `{0}` (the first part), `{1}`, … Doubles are
// shown with at most three decimals, without trailing zeros; with just two in `{0:2}`, and so on.
// Words are shown as flight/printable.hpp has them.
class TextPart {
 public:
  TextPart(std::string words) : value_(std::move(words)) {}  // NOLINT: stands for its value
  TextPart(const char* words) : value_(std::string(words)) {}
  TextPart(int number) : value_(static_cast<std::int64_t>(number)) {}
  TextPart(std::int64_t number) : value_(number) {}
  TextPart(std::size_t number) : value_(static_cast<std::int64_t>(number)) {}
  TextPart(double number) : value_(number) {}
  TextPart(Text text);
  TextPart(Problem problem) : value_(std::make_shared<const Problem>(std::move(problem))) {}

  using Value = std::variant<std::string, std::int64_t, double, std::shared_ptr<const Text>,
                             std::shared_ptr<const Problem>>;
  const Value& value() const { return value_; }
  bool operator==(const TextPart& other) const;

 private:
  Value value_;
};

// An empty key says nothing.
struct Text {
  std::string key;
  std::vector<TextPart> parts;

  Text() = default;
  Text(std::string textKey) : key(std::move(textKey)) {}  // NOLINT: stands for its key
  Text(const char* textKey) : key(textKey) {}
  Text(std::string textKey, std::initializer_list<TextPart> textParts)
      : key(std::move(textKey)), parts(textParts) {}
  bool empty() const { return key.empty(); }
  bool operator==(const Text& other) const { return key == other.key && parts == other.parts; }
};

}  // namespace vides
