// SPDX-License-Identifier: MIT
// Files of any name among the recent ones and in what is recovered; both ways to save check alike.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "edit/edit_fixture.hpp"
#include "edit/recent_files.hpp"
#include "edit/recovery.hpp"
#include "edit/texts.hpp"
#include "flight/utf8.hpp"

namespace vides {
namespace {

const std::vector<std::string> kNames = {"pl\xE4ne.vid", "two\nlines\x1B.vid", "%2Fx%41.vid",
                                         "back\\slash \"q\".vid", "\u00E4 \u4E2D.vid"};

class KeptNames : public FolderTest {
 protected:
  std::string wholePath(const std::string& name) const {
    return (std::filesystem::canonical(folder_) / name).string();
  }
};

TEST_F(KeptNames, RecentFilesOfAnyNameAreThereAgain) {
  Session session;
  std::vector<std::string> wanted;
  for (const std::string& name : kNames) {
    ASSERT_TRUE(session.execute(Command("save-as", path(name)))) << name;
    wanted.insert(wanted.begin(), wholePath(name));
  }
  EXPECT_EQ(session.recentFiles(), wanted);
  const std::string file = path("recent.json");
  EXPECT_EQ(saveRecentFiles(session.recentFiles(), Session::kRecentFiles, file), std::nullopt);
  EXPECT_TRUE(codePoints(fileText(file)));  // JSON is UTF-8
  EXPECT_EQ(readRecentFilesFile(file), wanted);
  Session next;
  next.setRecentFiles(readRecentFilesFile(file));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    run(next, "open-recent " + std::to_string(i));
  }
  // What isn't whole, or no path at all, isn't kept: it would lead elsewhere, or nowhere.
  EXPECT_THAT(readRecentFiles(writeRecentFiles({"a.vid", "", "/b.vid"})),
              testing::ElementsAre("/b.vid"));
}

TEST_F(KeptNames, WorkOfAFileOfAnyNameIsRecovered) {
  for (const std::string& name : kNames) {
    const auto work = readUnsavedWork(writeVid(withUnsavedPath(newFlight(), path(name))));
    ASSERT_TRUE(work) << name;
    EXPECT_EQ(work->path, path(name));
  }
}

TEST_F(KeptNames, TitlesAndQuestionsAreLinesOfUtf8) {
  const Texts texts(Language::kEnglish);
  for (const std::string& name : kNames) {
    Session session;
    ASSERT_TRUE(session.execute(Command("save-as", path(name))));
    run(session, "set-zoom 20");
    run(session, "new");
    ASSERT_TRUE(session.question());
    for (const Text& text : {session.title(), session.question()->text, session.output().text}) {
      const std::string words = texts.tell(text);
      EXPECT_TRUE(codePoints(words)) << words;
      EXPECT_EQ(words.find_first_of("\n\x1B"), std::string::npos) << words;
    }
  }
}

// Defect 9: the editor's saving and the other one refuse the same.
TEST_F(KeptNames, BothWaysToSaveCheckAlike) {
  Flight flight = newFlight();
  flight.frameRate = 1000;
  Key key = flight.keys[0];
  key.orientations.resize(10, key.orientations.front());
  for (Orientation& o : key.orientations) o.hold = 86400;
  flight.keys.set(0, key);
  flight.keys.insert(1, key);
  flight.keys.insert(1, key);
  DiskFile file;
  const auto mine = file.save(flight, path("a.vid"));
  const auto other = saveVid(flight, path("a.vid"));
  ASSERT_TRUE(mine && other);
  EXPECT_EQ(mine->code, ProblemCode::kTooManyFrames);
  EXPECT_EQ(other->code, mine->code);
  EXPECT_FALSE(std::filesystem::exists(path("a.vid")));
}

// A pipe would keep the window waiting for its other end, a device feed it without one.
TEST_F(KeptNames, WhatIsNoFileIsNeitherReadNorWritten) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  Session session;
  for (const std::string& file : {path("pipe"), std::string("/dev/zero")}) {
    for (const char* command : {"open", "load-setup", "import-scene"}) {
      EXPECT_FALSE(session.execute(Command(command, file))) << command << file;
      EXPECT_EQ(session.output().kind, MessageKind::kError);
    }
  }
  for (const char* command : {"save-as", "save-setup"}) {
    EXPECT_FALSE(session.execute(Command(command, path("pipe")))) << command;
  }
}

}  // namespace
}  // namespace vides
