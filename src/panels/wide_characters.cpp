// SPDX-License-Identifier: MIT
// The table of stand-ins.
#include "panels/wide_characters.hpp"

#include <algorithm>

#include "flight/utf8.hpp"
#include "input/input_event.hpp"

namespace vides {
namespace {

// Of well-formed UTF-8 with three bytes; 0 of any other.
char32_t threeBytes(std::string_view one) {
  if (one.size() != 3) return 0;
  const auto bits = [&](std::size_t i, unsigned mask) {
    return static_cast<char32_t>(static_cast<unsigned char>(one[i]) & mask);
  };
  return bits(0, 0x0F) << 12 | bits(1, 0x3F) << 6 | bits(2, 0x3F);
}

bool standsIn(char32_t character) {
  return character >= WideCharacters::kFirst && character <= WideCharacters::kLast;
}

// As Dear ImGui's filter of what is typed has it.
bool isPrivate(char32_t character) { return character >= 0xE000 && character <= 0xF8FF; }

}  // namespace

std::string WideCharacters::folded(std::string_view text) { return folded(text, false); }
std::string WideCharacters::foldedName(std::string_view text) { return folded(text, true); }

std::string WideCharacters::folded(std::string_view text, bool controls) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const std::string_view one = text.substr(0, std::max<std::size_t>(1, length));
    text.remove_prefix(one.size());
    const char32_t character = threeBytes(one);
    const bool control = controls && length == 1 && (one[0] < ' ' || one[0] == 0x7F);
    const bool plain =
        length > 0 && length < 4 && !control && !standsIn(character) && !isPrivate(character);
    if (plain) {
      result += one;
      continue;
    }
    auto found = numbers_.find(std::string(one));
    if (found == numbers_.end() && room() > 0) {
      found = numbers_.emplace(one, kept_.size()).first;
      kept_.emplace_back(one);
    }
    result += utf8(found == numbers_.end() ? char32_t{0xFFFD}
                                           : kFirst + static_cast<char32_t>(found->second));
  }
  return result;
}

std::string WideCharacters::unfolded(std::string_view text) const {
  std::string result;
  while (!text.empty()) {
    const std::string_view one = text.substr(0, std::max<std::size_t>(1, utf8Length(text)));
    text.remove_prefix(one.size());
    const char32_t character = threeBytes(one);
    const bool known = standsIn(character) && character - kFirst < kept_.size();
    result += known ? std::string_view(kept_[character - kFirst]) : one;
  }
  return result;
}

void WideCharacters::clear() {
  kept_.clear();
  numbers_.clear();
}

}  // namespace vides
