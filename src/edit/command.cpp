// SPDX-License-Identifier: MIT
// Lines become commands and commands lines.
#include "edit/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "edit/command_table.hpp"
#include "edit/sum.hpp"

namespace vides {
namespace {

// Nothing that an editor of flights is told is larger, and what is computed from it stays finite.
constexpr double kLargestNumber = 1e15;

struct Token {
  std::string text;
  bool quoted = false;
};

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

// Takes the characters up to the closing quote, which must be there.
bool takeQuoted(std::string_view& rest, std::string& into) {
  for (rest.remove_prefix(1); !rest.empty(); rest.remove_prefix(1)) {
    if (rest.front() == '"') {
      rest.remove_prefix(1);
      return true;
    }
    if (rest.front() == '\\' && rest.size() > 1) rest.remove_prefix(1);
    into += rest.front();
  }
  return false;
}

tl::expected<std::vector<Token>, Text> tokensOf(std::string_view line) {
  std::vector<Token> tokens;
  std::string_view rest = line;
  while (true) {
    while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
    if (rest.empty()) return tokens;
    Token token;
    token.quoted = rest.front() == '"';
    if (token.quoted) {
      if (!takeQuoted(rest, token.text)) return tl::unexpected(Text("refusal.closing-quote"));
    } else {
      const auto end = std::find_if(rest.begin(), rest.end(), isBlank);
      token.text.assign(rest.begin(), end);
      rest.remove_prefix(token.text.size());
    }
    tokens.push_back(std::move(token));
  }
}

// The specification of argument i, the last one's where it may be repeated; null beyond the last.
const ArgumentSpecification* argumentOf(const CommandSpecification& command, std::size_t i) {
  if (i < command.arguments.size()) return &command.arguments[i];
  const bool repeated = !command.arguments.empty() && command.arguments.back().repeated;
  return repeated ? &command.arguments.back() : nullptr;
}

bool countFits(const CommandSpecification& command, std::size_t count) {
  if (count > 0 && argumentOf(command, count - 1) == nullptr) return false;
  if (count >= command.arguments.size()) return true;
  // All or none of the optional ones, but for those that begin another group.
  return command.arguments[count].optional;
}

bool isNumber(ArgumentKind kind) {
  return kind == ArgumentKind::kNumber || kind == ArgumentKind::kIndex ||
         kind == ArgumentKind::kValue;
}

std::optional<Text> problemWith(const ArgumentSpecification& specification,
                                const Argument& argument) {
  const std::string& name = specification.name;
  const auto* written = std::get_if<std::string>(&argument);
  if (specification.kind == ArgumentKind::kValue && written != nullptr && startsFromOwn(*written)) {
    const auto sum = evaluateSum(*written, 1.0);
    return sum ? std::nullopt : std::optional(sum.error());
  }
  if (isNumber(specification.kind)) {
    const double* number = std::get_if<double>(&argument);
    if (number == nullptr) {
      return Text("refusal.expected-number", {name, std::get<std::string>(argument)});
    }
    if (!std::isfinite(*number)) return Text("refusal.expected-number", {name, *number});
    if (std::abs(*number) > kLargestNumber) return Text("refusal.too-large", {name});
    const bool whole = *number >= 0.0 && *number <= 9e15 && std::trunc(*number) == *number;
    if (specification.kind == ArgumentKind::kIndex && !whole) {
      return Text("refusal.expected-index", {name, *number});
    }
    return std::nullopt;
  }
  const std::string* text = std::get_if<std::string>(&argument);
  if (text == nullptr) return Text("refusal.expected-text", {name, std::get<double>(argument)});
  const std::vector<std::string>& choices = specification.choices;
  if (specification.kind == ArgumentKind::kChoice &&
      std::find(choices.begin(), choices.end(), *text) == choices.end()) {
    return Text("refusal.expected-choice",
                {name, fmt::format("{}", fmt::join(choices, ", ")), *text});
  }
  return std::nullopt;
}

bool needsQuotes(const std::string& text) {
  return text.empty() || std::any_of(text.begin(), text.end(), [](char c) {
           return isBlank(c) || c == '"' || c == '#' || c == '\\';
         });
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out += '"';
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  constexpr std::string_view kMinus = "\u2212";
  const std::string_view digits = text.substr(text.starts_with('+') ? 1 : 0);
  if (!digits.empty() && !digits.starts_with('-') && !digits.starts_with(kMinus)) text = digits;
  std::string plain(text);
  if (std::count(plain.begin(), plain.end(), ',') == 1 && plain.find('.') == plain.npos) {
    std::replace(plain.begin(), plain.end(), ',', '.');
  }
  // The typographic minus is what the interface itself shows.
  if (plain.starts_with(kMinus)) plain.replace(0, kMinus.size(), "-");
  double number = 0.0;
  const char* end = plain.data() + plain.size();
  const auto [at, error] = std::from_chars(plain.data(), end, number);
  if (plain.empty() || error != std::errc() || at != end || !std::isfinite(number)) {
    return std::nullopt;
  }
  return number + 0.0;  // -0 becomes 0
}

tl::expected<void, Text> checkArguments(const Command& command) {
  const CommandSpecification* specification = findCommand(command.name);
  if (specification == nullptr) {
    return tl::unexpected(Text("refusal.unknown-command", {command.name}));
  }
  if (!countFits(*specification, command.arguments.size())) {
    return tl::unexpected(Text("refusal.usage", {usage(*specification)}));
  }
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    if (auto problem = problemWith(*argumentOf(*specification, i), command.arguments[i])) {
      return tl::unexpected(std::move(*problem));
    }
  }
  return {};
}

tl::expected<Command, Text> parseCommand(std::string_view line) {
  auto tokens = tokensOf(line);
  if (!tokens) return tl::unexpected(tokens.error());
  if (tokens->empty()) return tl::unexpected(Text("refusal.no-command"));
  const CommandSpecification* specification = findCommand(tokens->front().text);
  if (specification == nullptr) {
    return tl::unexpected(Text("refusal.unknown-command", {tokens->front().text}));
  }
  Command command(specification->name);
  for (std::size_t i = 1; i < tokens->size(); ++i) {
    const ArgumentSpecification* argument = argumentOf(*specification, i - 1);
    const Token& token = (*tokens)[i];
    const bool sum = argument != nullptr && argument->kind == ArgumentKind::kValue;
    if (sum && !token.quoted && !startsFromOwn(token.text)) {
      const auto value = evaluateSum(token.text);
      if (!value && value.error().key != "refusal.no-number") return tl::unexpected(value.error());
      value ? command.add(*value) : command.add(token.text);
      continue;
    }
    const bool number = argument != nullptr && !sum && isNumber(argument->kind) && !token.quoted;
    if (const auto value = number ? parseNumber(token.text) : std::nullopt) {
      command.add(*value);
    } else {
      command.add(token.text);
    }
  }
  if (auto checked = checkArguments(command); !checked) return tl::unexpected(checked.error());
  return command;
}

std::string format(const Command& command) {
  std::string line = command.name;
  for (const Argument& argument : command.arguments) {
    line += ' ';
    if (const double* number = std::get_if<double>(&argument)) {
      line += fmt::format("{}", *number + 0.0);
    } else {
      const std::string& text = std::get<std::string>(argument);
      line += needsQuotes(text) ? quoted(text) : text;
    }
  }
  return line;
}

}  // namespace vides
