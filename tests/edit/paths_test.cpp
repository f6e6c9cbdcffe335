// SPDX-License-Identifier: MIT
// Paths that lead nowhere: each command that takes one refuses in words, and nothing else happens.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>

#include "edit/edit_fixture.hpp"
#include "edit/frame_job.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

// What a command line or a keyboard can name: nothing, no file, folders, loops, names too long.
std::vector<std::string> badPaths(const fs::path& folder) {
  fs::create_directory(folder / "folder");
  fs::create_symlink(folder / "loop", folder / "loop");
  writeFile(folder / "file", "a file");
  return {"",
          ".",
          "..",
          "/",
          (folder / "folder").string(),
          (folder / "file/in_a_file.vid").string(),
          (folder / "loop").string(),
          (folder / "loop/a.vid").string(),
          (folder / "none/a.vid").string(),
          (folder / std::string(300, 'n')).string(),
          (folder / std::string(5000, '/')).string() + "../" + std::string(300, 'n'),
          std::string(10000, 'x'),
          "/proc/self/mem/x",
          "/dev/full"};
}

constexpr std::array kCommands = {"open", "save-as", "load-setup", "save-setup", "import-scene"};

class PathsTest : public FolderTest {
 protected:
  PathsTest() : before_(fs::current_path()) {}
  ~PathsTest() override { fs::current_path(before_); }
  // The working directory is a folder that exists no more.
  void loseWorkingDirectory() {
    fs::create_directory(folder_ / "work");
    fs::current_path(folder_ / "work");
    fs::remove(folder_ / "work");
  }
  static void expectRefused(Session& session, const char* command, const std::string& file) {
    SCOPED_TRACE(std::string(command) + " " + file.substr(0, 100));
    const Flight before = session.flight();
    const std::string path = session.path();
    EXPECT_FALSE(session.execute(Command(command, file)));
    EXPECT_EQ(session.output().kind, MessageKind::kError);
    EXPECT_EQ(session.flight(), before);
    EXPECT_EQ(session.path(), path);
  }

  fs::path before_;
};

// Defect 3: an empty name in a flight that has a file ended the program.
TEST_F(PathsTest, NamesThatLeadNowhereAreRefused) {
  Session named, untitled;
  run(named, "save-as " + path("a.vid"));
  for (const std::string& file : badPaths(folder_)) {
    for (const char* command : kCommands) {
      // A setup's folders are made.
      if (file.ends_with("/none/a.vid") && std::string_view(command) == "save-setup") continue;
      expectRefused(named, command, file);
      expectRefused(untitled, command, file);
    }
  }
}

TEST_F(PathsTest, FramesIntoNowhereAreRefusedOrFail) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  for (const std::string& file : badPaths(folder_)) {
    if (file.empty()) continue;  // beside the flight
    SCOPED_TRACE(file.substr(0, 100));
    run(session, "frames-file \"" + file + "\"");
    if (session.execute("write-frames")) {
      if (session.question()) session.execute("answer overwrite");
      session.finishFrames();
    }
    EXPECT_THAT(session.output().kind, testing::AnyOf(MessageKind::kError, MessageKind::kRefusal));
  }
}

// What is relative has nowhere to be: it is refused, and whole paths go on working.
TEST_F(PathsTest, WithoutAWorkingDirectoryOnlyWholePathsWork) {
  Session session;
  run(session, "save-as " + path("a.vid"));
  loseWorkingDirectory();
  for (const char* command : kCommands) expectRefused(session, command, "relative.vid");
  run(session, "set-name ours");
  run(session, "save");
  run(session, "save-as " + path("b.vid"));
  EXPECT_EQ(session.path(), fs::canonical(folder_).string() + "/b.vid");
  run(session, "frames-file frames.txt");  // in the flight's folder
  run(session, "write-frames");
  session.finishFrames();
  EXPECT_EQ(session.output().text.key, "output.frames-written");

  Session untitled;
  expectRefused(untitled, "save-as", "a.vid");
  run(untitled, "frames-file frames.txt");
  run(untitled, "write-frames");
  untitled.finishFrames();
  EXPECT_EQ(untitled.output().text.key, "output.frames-failed");
  run(untitled, "save-as " + path("c.vid"));
  Session reader;
  run(reader, "open " + path("c.vid"));
}

// Folders that vanish, and scenes that are named from them.
TEST_F(PathsTest, AFolderThatGoesTakesNothingAlong) {
  fs::create_directory(folder_ / "gone");
  writeFile(path("gone/s.obj"), "v 0 0 0\nv 1 0 0\nl 1 2\n");
  Session session;
  run(session, "save-as " + path("gone/a.vid"));
  run(session, "import-scene " + path("gone/s.obj"));
  fs::remove_all(folder_ / "gone");
  EXPECT_FALSE(session.execute("save"));
  EXPECT_EQ(session.output().text.key, "output.save-failed");
  EXPECT_FALSE(session.execute("revert"));
  session.checkDisk();
  session.scenes();
  run(session, "save-as " + path("b.vid"));
  EXPECT_EQ(session.flight().scene.front().file, "gone/s.obj");
}

}  // namespace
}  // namespace vides
