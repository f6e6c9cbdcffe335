// SPDX-License-Identifier: MIT
// Scripts of `vides drive` as values.
#include "app/drive/script.hpp"

#include <fmt/format.h>

#include "edit/command.hpp"
#include "flight/text_encoding.hpp"
#include "render/failure.hpp"

namespace vides {
namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

// Error: a sentence.
tl::expected<ScriptLine, std::string> readLine(std::string_view text) {
  ScriptLine line;
  std::size_t restFrom = text.size();
  std::size_t i = 0;
  while (i < text.size()) {
    if (blank(text[i])) {
      ++i;
      continue;
    }
    if (text[i] == '#') break;
    if (line.words.size() == 1 && restFrom == text.size()) restFrom = i;
    ScriptWord word;
    if (text[i] == '"') {
      word.quoted = true;
      for (++i; i < text.size() && text[i] != '"'; ++i) {
        if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\')) {
          ++i;
        }
        word.text += text[i];
      }
      if (i >= text.size()) return Failure("expected a closing quote, found the line's end");
      ++i;
    } else {
      while (i < text.size() && !blank(text[i]) && text[i] != '#') word.text += text[i++];
    }
    line.words.push_back(std::move(word));
  }
  if (restFrom < i) line.rest = text.substr(restFrom, i - restFrom);
  while (!line.rest.empty() && blank(line.rest.back())) line.rest.pop_back();
  return line;
}

}  // namespace

tl::expected<std::vector<ScriptLine>, std::string> readScript(std::string_view text) {
  std::vector<ScriptLine> lines;
  std::size_t number = 0;
  const TextEncoding encoding = encodingOf(text);
  if (encoding != TextEncoding::kUtf8) {
    return Failure(fmt::format("1: expected UTF-8, found {}", name(encoding)));
  }
  text = withoutByteOrderMark(text);
  if (const std::size_t nul = text.find('\0'); nul != text.npos) {
    return Failure(
        fmt::format("{}: expected a text, found a NUL byte", 1 + lineEnds(text.substr(0, nul))));
  }
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    auto line = readLine(text.substr(0, end));
    ++number;
    if (!line) return Failure(fmt::format("{}: {}", number, line.error()));
    line->number = number;
    if (!line->words.empty()) lines.push_back(std::move(*line));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + (text.substr(end).starts_with("\r\n") ? 2 : 1));
  }
  return lines;
}

tl::expected<double, std::string> scriptNumber(std::string_view word, const ScriptPoints& points) {
  if (!word.starts_with('$')) {
    if (const auto number = parseNumber(word)) return *number;
    return Failure(fmt::format("expected a number, found '{}'", word));
  }
  const std::size_t dot = word.find('.');
  const std::string_view name = word.substr(1, dot == std::string_view::npos ? dot : dot - 1);
  const auto found = points.find(name);
  if (found == points.end()) {
    return Failure(fmt::format("expected a point kept earlier, found '${}'", name));
  }
  if (dot == std::string_view::npos || dot + 1 >= word.size() ||
      (word[dot + 1] != 'x' && word[dot + 1] != 'y')) {
    return Failure(fmt::format("expected ${0}.x or ${0}.y, found '{1}'", name, word));
  }
  const double value = word[dot + 1] == 'x' ? found->second.x : found->second.y;
  const std::string_view offset = word.substr(dot + 2);
  if (offset.empty()) return value;
  const auto by = offset[0] == '+' || offset[0] == '-' ? parseNumber(offset) : std::nullopt;
  if (!by) return Failure(fmt::format("expected +N or -N after ${}, found '{}'", name, offset));
  return value + *by;
}

}  // namespace vides
