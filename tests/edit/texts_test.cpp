// SPDX-License-Identifier: MIT
// Both languages say everything, with the same parts; texts are filled in.
#include "edit/texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "edit/command_table.hpp"
#include "edit/display.hpp"
#include "edit/place_text.hpp"
#include "edit/shortcuts.hpp"
#include "flight/utf8.hpp"

namespace vides {
namespace {

// Everything in braces.
std::multiset<std::string> placeholders(const std::string& text) {
  std::multiset<std::string> found;
  for (std::size_t at = text.find('{'); at != text.npos; at = text.find('{', at + 1)) {
    found.insert(text.substr(at, text.find('}', at) - at + 1));
  }
  return found;
}

// {0} or {0:3}.
bool isPlaceholder(const std::string& p) {
  const auto digit = [&](std::size_t i) { return p[i] >= '0' && p[i] <= '9'; };
  return (p.size() == 3 && digit(1) && p[2] == '}') ||
         (p.size() == 5 && digit(1) && p[2] == ':' && digit(3) && p[4] == '}');
}

// The string literals of a source that are keys of the table.
std::vector<std::string> keysNamedIn(const std::string& source) {
  std::vector<std::string> keys;
  for (const std::string group :
       {"refusal.", "output.", "step.", "question.", "title.", "menu.", "hint."}) {
    const std::string begin = '"' + group;
    for (std::size_t at = source.find(begin); at != source.npos; at = source.find(begin, at + 1)) {
      keys.push_back(source.substr(at + 1, source.find('"', at + 1) - at - 1));
    }
  }
  return keys;
}

TEST(Texts, BothLanguagesHaveTheSameKeysAndParts) {
  const Texts::Table english = builtInTexts(Language::kEnglish);
  const Texts::Table german = builtInTexts(Language::kGerman);
  ASSERT_GT(english.size(), 200u);
  for (const auto& [key, words] : english) {
    EXPECT_FALSE(words.empty()) << key;
    EXPECT_TRUE(codePoints(words)) << key;
    const auto found = german.find(key);
    if (found == german.end()) {
      ADD_FAILURE() << "no German for " << key;
      continue;
    }
    EXPECT_FALSE(found->second.empty()) << key;
    EXPECT_EQ(placeholders(words), placeholders(found->second)) << key;
    for (const std::string& p : placeholders(words)) {
      EXPECT_TRUE(isPlaceholder(p)) << key << ": " << p;
    }
  }
  for (const auto& [key, words] : german) {
    EXPECT_TRUE(english.contains(key)) << "no English for " << key;
  }
}

TEST(Texts, EveryCommandHasATitleAndEveryGroupOfShortcutsTo) {
  const Texts texts(Language::kEnglish);
  for (const CommandSpecification& command : commandTable()) {
    EXPECT_NE(texts.words(command.titleKey()), "") << command.name;
  }
  for (const Shortcut& shortcut : shortcutTable()) {
    EXPECT_NE(texts.words("shortcuts." + shortcut.group), "") << shortcut.group;
  }
}

// The settings window makes its keys from names: all of them must be there.
TEST(Texts, EverySwitchAndEveryElementHasALabel) {
  const Texts texts(Language::kEnglish);
  for (const std::string_view switchName : switchNames()) {
    std::string name(switchName);
    std::replace(name.begin(), name.end(), '-', '_');
    EXPECT_NE(texts.words("settings/show_" + name), "") << name;
  }
  for (std::size_t i = 0; i < kColourRoles; ++i) {
    const auto role = static_cast<ColourRole>(i);
    if (!isElement(role)) continue;
    EXPECT_NE(texts.words("settings/element_" + std::string(name(role))), "") << name(role);
  }
}

// Every key that the sources of edit/ name is in the table.
TEST(Texts, EveryTextThatTheSourcesNameIsThere) {
  const Texts texts(Language::kEnglish);
  std::size_t count = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(VIDES_SOURCE_DIR) / "src/edit")) {
    std::ifstream stream(file.path());
    const std::string source{std::istreambuf_iterator<char>(stream), {}};
    for (std::string key : keysNamedIn(source)) {
      if (key.ends_with('.')) key += 'x';  // one of x, y, z
      EXPECT_NE(texts.words(key), "") << key << " in " << file.path();
      ++count;
    }
  }
  EXPECT_GT(count, 80u);
}

TEST(Texts, PartsAreFilledIn) {
  const Texts english(Language::kEnglish), german(Language::kGerman);
  const Text undo("menu.undo", {Text("step.move-key", {3})});
  EXPECT_EQ(english.tell(undo), "Undo Move key 3");
  EXPECT_EQ(german.tell(undo), "Rückgängig: Stützpunkt 3 bewegen");
  EXPECT_EQ(english.tell(Text("step.insert-keys", {1})), "Insert 1 key");
  EXPECT_EQ(english.tell(Text("step.insert-keys", {4})), "Insert 4 keys");
  EXPECT_EQ(english.tell(Text("output.point", {-0.5, 0.25, -0.0001})), "\u22120.500  0.250  0.000");
  EXPECT_EQ(german.tell(Text("output.point", {-0.5, 0.25, 1.0})), "\u22120,500  0,250  1,000");
}

TEST(Texts, ProblemsAreToldInTheLanguage) {
  Problem problem;
  problem.code = ProblemCode::kOutOfRange;
  problem.pointer = "/keys/1/orientations/0/zoom";
  problem.expected.kind = Expected::kNumber;
  problem.expected.min = 1;
  problem.expected.max = 100;
  problem.found = "250";
  EXPECT_EQ(Texts(Language::kEnglish).tell(Text("refusal.problem", {problem})),
            "/keys/1/orientations/0/zoom: expected a number from 1 to 100, found 250");
  EXPECT_EQ(Texts(Language::kGerman).tell(Text("refusal.problem", {problem})),
            "/keys/1/orientations/0/zoom: erwartet: eine Zahl von 1 bis 100; gefunden: 250");
}

// In the window places are told in its words, counted as it counts.
TEST(Texts, PlacesInAKeyAreWords) {
  Problem problem;
  problem.code = ProblemCode::kOutOfRange;
  problem.expected.kind = Expected::kNumber;
  problem.expected.min = 1;
  problem.expected.max = 100;
  problem.found = "250";
  const Texts english(Language::kEnglish), german(Language::kGerman);
  const std::string wrong = ": expected a number from 1 to 100, found 250";
  const std::pair<const char*, const char*> places[] = {
      {"/keys/1/orientations/0/zoom", "Key 2, orientation 1, zoom"},
      {"/keys/0/position/0", "Key 1, position x"},
      {"/keys/11/position", "Key 12, position"},
      {"/keys/2/orientations/9/aim/2", "Key 3, orientation 10, aim z"},
      {"/keys/2/orientations/1/speed/0", "Key 3, orientation 2, speed 1"},
      {"/keys/2/orientations/1/duration", "Key 3, orientation 2, duration"},
      {"/keys/2/shape/bias", "Key 3, bias"},
      {"/rates/move", "/rates/move"},
      {"/keys", "/keys"},
      {"/keys/2/orientations", "/keys/2/orientations"},
      {"/keys/x/position/0", "/keys/x/position/0"},
      {"/keys/1/position/7", "/keys/1/position/7"}};
  for (const auto& [pointer, words] : places) {
    problem.pointer = pointer;
    EXPECT_EQ(english.tell(refusalOf(problem)), words + wrong);
  }
  problem.pointer = "/keys/0/position/1";
  EXPECT_EQ(german.tell(refusalOf(problem)),
            "St\u00fctzpunkt 1, Position y: erwartet: eine Zahl von 1 bis 100; gefunden: 250");
}

TEST(Texts, WhatALanguageLacksIsToldInEnglish) {
  const Texts texts(Language::kGerman, {{"a", "ein A"}}, {{"a", "an A"}, {"b", "a {0}"}});
  EXPECT_EQ(texts.tell(Text("a")), "ein A");
  EXPECT_EQ(texts.tell(Text("b", {"B"})), "a B");
  EXPECT_EQ(texts.tell(Text("c")), "c");
  EXPECT_EQ(texts.words("c"), "");
}

TEST(Texts, Numbers) {
  const Texts texts(Language::kEnglish);
  EXPECT_EQ(texts.number(12.0), "12");
  EXPECT_EQ(texts.number(0.1 + 0.2), "0.3");
  EXPECT_EQ(texts.number(-12.5), "\u221212.5");
  EXPECT_EQ(texts.number(-0.0004), "0");
  EXPECT_EQ(texts.number(100.0, 3), "100.000");
}

}  // namespace
}  // namespace vides
