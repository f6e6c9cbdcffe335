// SPDX-License-Identifier: MIT
// Any bytes as a script of `vides drive`, and its lines as commands: refused with a sentence, or
// read, and then said again in the same words.
#include <cmath>

#include "app/drive/script.hpp"
#include "edit/command.hpp"
#include "edit/texts.hpp"
#include "fuzz/require.hpp"

namespace vides::test {
namespace {

std::string quoted(const ScriptWord& word) {
  if (!word.quoted) return word.text;
  std::string out = "\"";
  for (const char c : word.text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out += '"';
}

void checkWord(const ScriptWord& word) {
  require(word.quoted || !word.text.empty(), "only quotes hold nothing");
  require(word.text.find('\n') == std::string::npos, "a word ends with its line");
  static const ScriptPoints points{{"a", {10.5, -3.0}}, {"", {1e300, 0.0}}};
  const auto number = scriptNumber(word.text, points);
  require(!number || std::isfinite(*number), "numbers are finite");
  require(number || !number.error().empty(), "what is no number is told");
}

// The line in words again, a blank before each: at the very beginning a byte order mark is none of
// the first word.
void checkLine(const ScriptLine& line) {
  require(!line.words.empty(), "only lines that say something");
  std::string again;
  for (const ScriptWord& word : line.words) {
    checkWord(word);
    again += ' ' + quoted(word);
  }
  const auto read = readScript(again);
  require(read && read->size() == 1, "a line said again is a line");
  const auto& words = read->front().words;
  require(std::equal(words.begin(), words.end(), line.words.begin(), line.words.end(),
                     [](const ScriptWord& a, const ScriptWord& b) {
                       return a.text == b.text && a.quoted == b.quoted;
                     }),
          "and has the same words");
}

void checkScript(std::string_view text) {
  const auto script = readScript(text);
  if (!script) {
    require(!script.error().empty(), "what is no script is told");
    return;
  }
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  std::size_t before = 0;
  for (const ScriptLine& line : *script) {
    require(line.number > before && line.number <= lines, "lines are counted from 1");
    before = line.number;
    require(text.find(line.rest) != text.npos, "the rest stands in the line as it was written");
    checkLine(line);
  }
}

void checkCommand(std::string_view line) {
  static const Texts words(Language::kEnglish);
  const auto command = parseCommand(line);
  if (!command) {
    require(!words.tell(command.error()).empty(), "a refusal is told in words");
    return;
  }
  require(checkArguments(*command).has_value(), "a command that is read fits the table");
  const std::string written = format(*command);
  const auto again = parseCommand(written);
  require(again && *again == *command, "a command that is written is read as it was");
  require(format(*again) == written, "and written the same again");
}

}  // namespace
}  // namespace vides::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vides::test;
  std::string_view text = asText(data, size);
  checkScript(text);
  checkCommand(text);
  while (!text.empty()) {
    checkCommand(takeLine(text));
  }
  return 0;
}
