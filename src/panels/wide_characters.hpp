// SPDX-License-Identifier: MIT
// Characters that Dear ImGui's text fields would lose: its characters have 16 bits here, so that
// what lies beyond U+FFFF (emoji, say) becomes U+FFFD as soon as another letter is edited, and it
// drops typed ones of the private use area.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace vides {

// While a text is edited, stand-ins take the place of such characters, of bytes that are no UTF-8
// (names of files may have some), and of the characters that are stand-ins here themselves. They
// are syllables of Yi and Vai, which our fonts do not draw either.
class WideCharacters {
 public:
  // As many as any text that a field takes can need.
  static constexpr char32_t kFirst = 0xA000, kLast = 0xA63F;

  // The text as Dear ImGui takes it. The same character always gets the same stand-in; what finds
  // none left (`room()` is 0) becomes U+FFFD.
  std::string folded(std::string_view text);
  // The same with stand-ins for control characters, too, which names of files may have.
  std::string foldedName(std::string_view text);
  // What it stands for.
  std::string unfolded(std::string_view text) const;
  std::size_t room() const { return kLast - kFirst + 1 - kept_.size(); }
  // Forgets all: only while nothing is being edited.
  void clear();

 private:
  std::string folded(std::string_view text, bool controls);
  std::vector<std::string> kept_;  // what stand-in number i stands for
  std::unordered_map<std::string, std::size_t> numbers_;
};

}  // namespace vides
