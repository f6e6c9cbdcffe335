// SPDX-License-Identifier: MIT
// Lines become commands and back; the table of commands is sound.
#include "edit/command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "edit/command_table.hpp"

namespace vides {
namespace {

TEST(Command, LineBecomesNameAndTypedArguments) {
  const auto command = parseCommand("  move-key 2 0.1 -0.25 1e-3 ");
  ASSERT_TRUE(command);
  EXPECT_EQ(*command, Command("move-key", 2, 0.1, -0.25, 0.001));
  // Numbers where a text is expected are text.
  EXPECT_EQ(*parseCommand("set-name 2001"), Command("set-name", "2001"));
  EXPECT_EQ(*parseCommand(R"(set-name "a \"b\" \\ c # d")"),
            Command("set-name", R"(a "b" \ c # d)"));
}

TEST(Command, FormatIsReadBackAsTheSame) {
  for (const Command& command :
       {Command("undo"), Command("move-key", 1, 0.1, 1.0 / 3.0, -0.0), Command("set-name", ""),
        Command("set-name", "two words"), Command("set-name", R"(\ " #)"),
        Command("set-name", "Flug über Köln"), Command("set-zoom", 12.5),
        Command("select-keys", 3, 1, 2)}) {
    const auto again = parseCommand(format(command));
    ASSERT_TRUE(again) << format(command);
    EXPECT_EQ(*again, command) << format(command);
  }
  EXPECT_EQ(format(Command("move-key", 2, 0.1, 0.2, 0.3)), "move-key 2 0.1 0.2 0.3");
}

TEST(Command, RefusalTellsWhatWasExpected) {
  const auto why = [](const char* line) {
    const auto command = parseCommand(line);
    return command ? Text() : command.error();
  };
  EXPECT_EQ(why(""), Text("refusal.no-command"));
  EXPECT_EQ(why("fly-to-the-moon"), Text("refusal.unknown-command", {"fly-to-the-moon"}));
  EXPECT_EQ(why("move-key 1 2"), Text("refusal.usage", {"move-key KEY X Y Z"}));
  EXPECT_EQ(why("undo 1"), Text("refusal.usage", {"undo"}));
  EXPECT_EQ(why("set-zoom wide"), Text("refusal.expected-number", {"ZOOM", "wide"}));
  EXPECT_EQ(why("set-zoom nan"), Text("refusal.expected-number", {"ZOOM", "nan"}));
  EXPECT_EQ(why("set-zoom \"12\""), Text("refusal.expected-number", {"ZOOM", "12"}));
  EXPECT_EQ(why("select-key 1.5"), Text("refusal.expected-index", {"KEY", 1.5}));
  EXPECT_EQ(why("select-key -1"), Text("refusal.expected-index", {"KEY", -1.0}));
  EXPECT_EQ(why("set-aim-mode up"),
            Text("refusal.expected-choice", {"MODE", "absolute, relative", "up"}));
  EXPECT_EQ(why("set-name \"open"), Text("refusal.closing-quote"));
  EXPECT_EQ(
      why("add-scene a.obj 1 2"),
      Text("refusal.usage", {"add-scene FILE [LOW_X LOW_Y LOW_Z HIGH_X HIGH_Y HIGH_Z [UP]]"}));
}

TEST(Command, NumbersAsUsersTypeThem) {
  EXPECT_EQ(parseNumber("0,5"), 0.5);
  EXPECT_EQ(parseNumber(" +0.5 "), 0.5);
  EXPECT_EQ(parseNumber("-1,25"), -1.25);
  EXPECT_EQ(parseNumber("\u22120.5"), -0.5);
  EXPECT_EQ(parseNumber("1e-3"), 0.001);
  EXPECT_EQ(parseNumber("-0").value(), 0.0);
  EXPECT_FALSE(std::signbit(*parseNumber("-0")));
  for (const char* no : {"", " ", "1,000.5", "1,2,3", "nan", "inf", "1e999", "+-1", "+\u22121",
                         "-\u22121", "++1", "1x", "0x10", "1 2"}) {
    EXPECT_FALSE(parseNumber(no)) << no;
  }
}

TEST(CommandTable, NamesAreUniqueAndFound) {
  std::set<std::string> names;
  for (const CommandSpecification& command : commandTable()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_EQ(findCommand(command.name), &command);
    EXPECT_THAT(command.name, testing::MatchesRegex("[a-z]+(-[a-z]+)*"));
  }
  EXPECT_EQ(findCommand("no-such-command"), nullptr);
}

}  // namespace
}  // namespace vides
