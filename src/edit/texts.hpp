// SPDX-License-Identifier: MIT
// The translation table (assets/translations/*.json, put into the program) and how texts become
// words.
//
// {"KEY": {"en": "…", "de": "…"}, …}. {0}, {1}, … stand for a text's parts; {0:3} shows a number
// with exactly three decimals, {0} with as many as it has, at most three. Where KEY#one exists it
// is taken when the first part is the number 1. Numbers have a real minus sign and the decimal sign
// of the language. A text that a language lacks is told in English, an unknown key as it is.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "edit/text.hpp"
#include "io/problem_text.hpp"

namespace vides {

class Texts {
 public:
  using Table = std::map<std::string, std::string, std::less<>>;

  // The built-in table in a language.
  explicit Texts(Language language);
  Texts(Language language, Table words, Table english);

  Language language() const { return language_; }
  // The words for a key, with their placeholders; empty where the table has none.
  std::string_view words(std::string_view key) const;
  // The text in words.
  std::string tell(const Text& text) const;
  // `decimals` exactly, or with -1 as many as it has, at most three.
  std::string number(double value, int decimals = -1) const;

 private:
  std::string part(const TextPart& part, int decimals) const;

  Language language_;
  Table words_, english_;
};

// The built-in table of one language, as it is in the files.
Texts::Table builtInTexts(Language language);
// "en", "de".
std::string_view languageCode(Language language);

}  // namespace vides
