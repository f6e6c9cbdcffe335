// SPDX-License-Identifier: MIT
// The setup's file: every member, everything that can be wrong, and that nothing is lost.
#include "edit/setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "edit/edit_fixture.hpp"
#include "edit/folder.hpp"
#include "edit/recent_files.hpp"
#include "edit/texts.hpp"
#include "io/problem_text.hpp"
#include "support/files.hpp"
#include "support/german_locale.hpp"

namespace vides {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Nothing in it is as built in.
Setup otherSetup() {
  Setup setup;
  Display& d = setup.display;
  for (const std::string_view name : switchNames()) {
    bool* const on = switchOf(d, name);
    *on = !*on;
  }
  d.shown.ghostEvery = 7;
  d.sizes = {3.5, 0.75, 9.25, 20.0};
  d.gridStep = 0.125;
  d.theme = ThemeKind::kHighContrast;
  d.units = Units::kScene;
  d.language = Language::kGerman;
  d.contentScale = 1.25;
  for (std::size_t i = 0; i < kColourRoles; ++i) {
    const auto role = static_cast<ColourRole>(i);
    const auto byte = static_cast<std::uint8_t>(i * 5);
    if (isElement(role)) d.colours[i] = Colour{byte, 255, static_cast<std::uint8_t>(255 - byte)};
  }
  setup.layout = {300.5f, 240.0f, 200.25f, false, false, false, false};
  setup.turn = -33.25;
  setup.tilt = 90.0;
  setup.size = 0.1 + 0.2;
  setup.perspective = true;
  return setup;
}

std::string around(const std::string& members) {
  return R"({"format": "vides-setup", "version": 1)" + members + "}";
}

std::vector<std::string> problemsOf(const std::string& text) {
  const ReadSetup read = readSetup(text);
  std::vector<std::string> lines;
  if (read) return lines;
  for (const Problem& problem : read.error()) lines.push_back(problemLine("s", problem));
  return lines;
}

TEST(Setup, WhatIsMissingIsAsBuiltIn) {
  EXPECT_EQ(readSetup(around("")).value(), vides::Setup());
  const vides::Setup setup =
      readSetup(around(R"(, "theme": "light", "view": {"tilt": -12})")).value();
  EXPECT_EQ(setup.display.theme, ThemeKind::kLight);
  EXPECT_EQ(setup.tilt, -12.0);
  EXPECT_EQ(setup.turn, 32.0);
}

TEST(Setup, WrittenAndReadAgainItIsTheSame) {
  const vides::Setup setup = otherSetup();
  EXPECT_EQ(readSetup(writeSetup(setup)).value(), setup);
  EXPECT_EQ(readSetup(writeSetup(vides::Setup())).value(), vides::Setup());
}

TEST(Setup, TheFileIsPlainJsonInEveryLocale) {
  const std::string text = writeSetup(otherSetup());
  {
    const test::GermanLocale german;
    EXPECT_EQ(writeSetup(otherSetup()), text);
    EXPECT_EQ(readSetup(text).value(), otherSetup());
  }
  const nlohmann::json json = nlohmann::json::parse(text);
  EXPECT_EQ(json.at("format"), "vides-setup");
  EXPECT_EQ(json.at("content_scale"), 1.25);
  EXPECT_EQ(json.at("view").at("turn"), -33.25);
  EXPECT_EQ(json.at("layout").at("timeline"), 200.25);
  EXPECT_EQ(json.at("grid_step"), 0.125);
  EXPECT_EQ(json.at("sizes").at("handles"), 9.25);
  EXPECT_EQ(json.at("shown").at("up-circle"), false);
  EXPECT_EQ(json.at("colours").at("cube").size(), 3u);
  // The screen's own scale is no number.
  EXPECT_FALSE(nlohmann::json::parse(writeSetup(vides::Setup())).contains("content_scale"));
}

TEST(Setup, EverythingThatIsWrongIsToldWithItsPlace) {
  EXPECT_THAT(
      problemsOf(around(R"(, "theme": "beige", "content_scale": 9, "ghost_every": 1.5,
        "grid_step": 0, "sizes": {"handles": 4, "hats": 3},
        "shown": {"cube": 1, "fog": 3}, "colours": {"curve": [1, 2], "aim": [1, 2, 256]},
        "layout": {"left": 9}, "view": 7)")),
      ElementsAre(R"(s: /theme: expected one of "dark", "light", "high_contrast", found "beige")",
                  "s: /content_scale: expected a number from 0.5 to 4, found 9",
                  "s: /ghost_every: expected an integer from 1 to 100000, found 1.5",
                  "s: /grid_step: expected a number from 0.001 to 0.5, found 0",
                  "s: /sizes/handles: expected a number from 5 to 16, found 4",
                  "s: /shown/cube: expected true or false, found 1",
                  "s: /colours/curve: expected 3 numbers from 0 to 255, found 2",
                  "s: /colours/aim/2: expected an integer from 0 to 255, found 256",
                  "s: /layout/left: expected a number from 220 to 480, found 9",
                  "s: /view: expected an object, found 7"));
}

TEST(Setup, OtherFilesAreNoSetups) {
  EXPECT_THAT(problemsOf("{}"), ElementsAre(R"(s: /format: missing; expected "vides-setup")",
                                            "s: /version: missing; expected an integer that is 1"));
  EXPECT_THAT(problemsOf(R"({"format": "vides", "version": 1, "keys": []})"),
              ElementsAre(R"(s: /format: expected "vides-setup", found "vides")"));
  EXPECT_THAT(problemsOf(""), ElementsAre("s:1:1: expected a value, found the end of the file"));
  EXPECT_THAT(problemsOf(around("") + "x"),
              ElementsAre("s:1:40: expected the end of the file, found 'x'"));
  EXPECT_THAT(problemsOf(std::string(100, '[')).size(), 1u);
}

TEST(Setup, ANewerVersionIsAllThatIsToldOfIt) {
  EXPECT_THAT(
      problemsOf(R"({"format": "vides-setup", "version": 2, "theme": 7})"),
      ElementsAre("s: /version: written by a newer vides (format 2; this one reads up to 1)"));
}

TEST(Setup, UnknownMembersArePassedOverAndDoubleOnesTold) {
  EXPECT_EQ(readSetup(around(R"(, "sound": {"loud": [1, 2]}, "shown": {"fog": "thick"},
      "colours": {"text": [1, 2, 3], "beige": 0}, "layout": {"middle": 1})"))
                .value(),
            vides::Setup());
  EXPECT_THAT(problemsOf(around(R"(, "shown": {"cube": true, "cube": false}, "shown": {})")),
              ElementsAre("s: /shown/cube: stands twice in the same object",
                          "s: /shown: stands twice in the same object"));
}

TEST(Setup, SavingMakesItsFolders) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "a/b/setup.json").string();
  EXPECT_EQ(saveSetup(otherSetup(), path), std::nullopt);
  EXPECT_EQ(readSetupFile(path).value(), otherSetup());
  test::writeAll(folder / "file", "");
  const auto problem = saveSetup(otherSetup(), (folder / "file/setup.json").string());
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->code, ProblemCode::kUnwritable);
}

TEST(Setup, ASessionTakesAndGivesIt) {
  Session session;
  session.setSetup(otherSetup());
  EXPECT_EQ(session.setup(), otherSetup());
  EXPECT_TRUE(session.execute("reset-setup"));
  vides::Setup builtIn;
  builtIn.display.language = Language::kGerman;  // kept
  EXPECT_EQ(session.setup(), builtIn);
}

TEST(Setup, CommandsSaveAndLoadIt) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "my setup.json").string();
  Session session;
  session.setSetup(otherSetup());
  EXPECT_TRUE(session.execute(Command("save-setup", path)));
  session.setSetup(vides::Setup());
  EXPECT_TRUE(session.execute(Command("load-setup", path)));
  EXPECT_EQ(session.setup(), otherSetup());
  // A broken one changes nothing and is told with its place.
  test::writeAll(path, around(R"(, "view": {"tilt": 91})"));
  EXPECT_FALSE(session.execute(Command("load-setup", path)));
  EXPECT_EQ(session.setup(), otherSetup());
  EXPECT_EQ(session.output().kind, MessageKind::kError);
  EXPECT_EQ(
      Texts(Language::kEnglish).tell(session.output().text),
      "my setup.json: the setup was not loaded: /view/tilt: expected a number from -90 to 90, "
      "found 91");
  EXPECT_FALSE(session.execute(Command("save-setup", (folder / "none" / "\0x").string())));
}

TEST(RecentFiles, NewestFirstAndTheOthersBehind) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "state/recent.json").string();
  EXPECT_THAT(readRecentFilesFile(path), IsEmpty());
  EXPECT_EQ(saveRecentFiles({"/a \"b\"\n.vid", "/c"}, 3, path), std::nullopt);
  EXPECT_THAT(readRecentFilesFile(path), ElementsAre("/a \"b\"\n.vid", "/c"));
  // Another editor's entries stay behind ours, as many as there is room for.
  EXPECT_EQ(saveRecentFiles({"/d", "/c"}, 3, path), std::nullopt);
  EXPECT_THAT(readRecentFilesFile(path), ElementsAre("/d", "/c", "/a \"b\"\n.vid"));
  EXPECT_EQ(saveRecentFiles({"/e", "/f"}, 3, path), std::nullopt);
  EXPECT_THAT(readRecentFilesFile(path), ElementsAre("/e", "/f", "/d"));
  for (const char* other :
       {"", "[1]", R"({"files": ["/a"]})", R"({"format": "vides-recent", "files": [7]})"}) {
    test::writeAll(path, other);
    EXPECT_THAT(readRecentFilesFile(path), IsEmpty()) << other;
  }
}

// Sets a variable of the environment and puts it back.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  ~Variable() { set(before_ ? before_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void set(const char* value) { value == nullptr ? unsetenv(name_) : setenv(name_, value, 1); }
  const char* name_;
  std::optional<std::string> before_;
};

TEST(OwnFolders, AreThoseOfXdg) {
  const Variable home("HOME", "/home/x");
  {
    const Variable config("XDG_CONFIG_HOME", "/etc/c"), state("XDG_STATE_HOME", "/var/s");
    EXPECT_EQ(configFolder(), "/etc/c/vides");
    EXPECT_EQ(stateFolder(), "/var/s/vides");
  }
  for (const char* unusable : {static_cast<const char*>(nullptr), "", "relative"}) {
    const Variable config("XDG_CONFIG_HOME", unusable), state("XDG_STATE_HOME", unusable);
    EXPECT_EQ(configFolder(), "/home/x/.config/vides");
    EXPECT_EQ(stateFolder(), "/home/x/.local/state/vides");
  }
  const Variable none("HOME", nullptr), config("XDG_CONFIG_HOME", nullptr);
  EXPECT_EQ(configFolder(), "");
}

}  // namespace
}  // namespace vides
