// SPDX-License-Identifier: MIT
// Texts as values: nested parts and equality.
#include "edit/text.hpp"

namespace vides {

TextPart::TextPart(Text text) : value_(std::make_shared<const Text>(std::move(text))) {}

bool TextPart::operator==(const TextPart& other) const {
  if (value_.index() != other.value_.index()) return false;
  if (const auto* text = std::get_if<std::shared_ptr<const Text>>(&value_)) {
    return **text == *std::get<std::shared_ptr<const Text>>(other.value_);
  }
  if (const auto* problem = std::get_if<std::shared_ptr<const Problem>>(&value_)) {
    return **problem == *std::get<std::shared_ptr<const Problem>>(other.value_);
  }
  return value_ == other.value_;
}

}  // namespace vides
