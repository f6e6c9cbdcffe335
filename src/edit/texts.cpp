// SPDX-License-Identifier: MIT
// Looking up and filling in texts.
#include "edit/texts.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "flight/printable.hpp"
#include "translations.hpp"

namespace vides {
namespace {

constexpr std::string_view kMinus = "\u2212";
constexpr int kMostDecimals = 3;

std::array<std::string_view, 5> files() {
  return {translations::kSessionJson, translations::kPanelsJson, translations::kScenesJson,
          translations::kSettingsJson, translations::kHelpJson};
}

// "{0}" or "{0:3}" at the beginning of a template; size 0 where there is none.
struct Placeholder {
  std::size_t size = 0;
  std::size_t part = 0;
  int decimals = -1;
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

Placeholder placeholderAt(std::string_view text) {
  if (text.size() < 3 || text[0] != '{' || !isDigit(text[1])) return {};
  Placeholder found;
  found.part = static_cast<std::size_t>(text[1] - '0');
  if (text[2] == '}') {
    found.size = 3;
  } else if (text.size() >= 5 && text[2] == ':' && isDigit(text[3]) && text[4] == '}') {
    found.size = 5;
    found.decimals = text[3] - '0';
  }
  return found;
}

void withoutTrailingZeros(std::string& number) {
  if (number.find('.') == number.npos) return;
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
}

}  // namespace

std::string_view languageCode(Language language) {
  return language == Language::kGerman ? "de" : "en";
}

Texts::Table builtInTexts(Language language) {
  Texts::Table table;
  const std::string code(languageCode(language));
  for (const std::string_view file : files()) {
    const nlohmann::json json = nlohmann::json::parse(file);
    for (const auto& [key, entry] : json.items()) {
      if (entry.contains(code)) table.emplace(key, entry.at(code).get<std::string>());
    }
  }
  return table;
}

Texts::Texts(Language language)
    : Texts(language, builtInTexts(language), builtInTexts(Language::kEnglish)) {}

Texts::Texts(Language language, Table words, Table english)
    : language_(language), words_(std::move(words)), english_(std::move(english)) {}

std::string_view Texts::words(std::string_view key) const {
  if (const auto found = words_.find(key); found != words_.end()) return found->second;
  if (const auto found = english_.find(key); found != english_.end()) return found->second;
  return {};
}

std::string Texts::number(double value, int decimals) const {
  std::string text = fmt::format("{:.{}f}", value, decimals < 0 ? kMostDecimals : decimals);
  if (decimals < 0) withoutTrailingZeros(text);
  // "-0.000" is 0.
  const bool negative = text.front() == '-';
  if (negative) text.erase(0, 1);
  const bool zero = text.find_first_not_of("0.") == text.npos;
  if (language_ == Language::kGerman) {
    if (const auto point = text.find('.'); point != text.npos) text[point] = ',';
  }
  return negative && !zero ? std::string(kMinus) + text : text;
}

std::string Texts::part(const TextPart& part, int decimals) const {
  struct Shown {
    const Texts& texts;
    int decimals;
    // Words may be a file's name: one line of what a screen can show.
    std::string operator()(const std::string& words) const { return printable(words); }
    std::string operator()(std::int64_t number) const {
      return texts.number(static_cast<double>(number), 0);
    }
    std::string operator()(double number) const { return texts.number(number, decimals); }
    std::string operator()(const std::shared_ptr<const Text>& text) const {
      return texts.tell(*text);
    }
    std::string operator()(const std::shared_ptr<const Problem>& problem) const {
      // The pointer tells where in the file or flight; of syntax errors the line does.
      std::string place = problem->pointer;
      if (problem->line > 0) place = fmt::format("{}:{}", problem->line, problem->column);
      if (!place.empty()) place += ": ";
      return place + problemText(*problem, texts.language());
    }
  };
  return std::visit(Shown{*this, decimals}, part.value());
}

std::string Texts::tell(const Text& text) const {
  std::string_view form;
  if (!text.parts.empty() && text.parts.front() == TextPart(1)) form = words(text.key + "#one");
  if (form.empty()) form = words(text.key);
  if (form.empty()) return text.key;
  std::string result;
  while (!form.empty()) {
    const Placeholder placeholder = placeholderAt(form);
    if (placeholder.size == 0) {
      result += form.front();
      form.remove_prefix(1);
      continue;
    }
    if (placeholder.part < text.parts.size()) {
      result += part(text.parts[placeholder.part], placeholder.decimals);
    }
    form.remove_prefix(placeholder.size);
  }
  return result;
}

}  // namespace vides
