// SPDX-License-Identifier: MIT
// Files appear whole or not at all: permissions, links, special files, errors.
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/leftovers.hpp"
#include "support/files.hpp"
#include "support/process.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;
using test::readAll;
using test::TemporaryFolder;
using test::writeAll;

// "" if it was saved, else the reason.
std::string save(const fs::path& path, const std::string& text) {
  AtomicFile file(path.string());
  file.write(text);
  const auto saved = file.commit();
  return saved ? "" : saved.error().reason();
}

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

mode_t modeOf(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(stat(path.c_str(), &status), 0);
  return status.st_mode & 07777;
}

// What `body` returns, from another process: for what can't be undone (users, limits).
int inChild(const std::function<int()>& body) {
  const pid_t child = fork();
  if (child == 0) _exit(body());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 256;
}

constexpr uid_t kNobody = 65534;

class AtomicFileTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  fs::path target = folder / "flight.vid";
};

TEST_F(AtomicFileTest, NewFile) {
  EXPECT_EQ(save(target, "text"), "");
  EXPECT_EQ(readAll(target), "text");
  EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("flight.vid"));
}

TEST_F(AtomicFileTest, EmptyAndLargeFiles) {
  EXPECT_EQ(save(target, ""), "");
  EXPECT_EQ(readAll(target), "");
  std::string large;
  AtomicFile file(target.string());
  for (int i = 0; i < 300'000; ++i) {
    const std::string piece = std::to_string(i);
    large += piece;
    ASSERT_TRUE(file.write(piece));
  }
  large += std::string(500'000, 'x');
  file.write(std::string(500'000, 'x'));
  EXPECT_EQ(readAll(target), "");  // not yet
  EXPECT_TRUE(file.commit().has_value());
  EXPECT_EQ(readAll(target), large);
}

TEST_F(AtomicFileTest, NothingHappensWithoutCommit) {
  writeAll(target, "old");
  {
    AtomicFile file(target.string());
    file.write(std::string(1'000'000, 'n'));
    EXPECT_EQ(readAll(target), "old");
  }
  EXPECT_EQ(readAll(target), "old");
  EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("flight.vid"));
}

// What a killed saver has left goes with the next saving; what one at work has stays, and so does
// everything that only looks like it.
TEST_F(AtomicFileTest, TheNextSavingClearsWhatDeadSaversLeft) {
  const std::string dead = temporaryName(), atWork = temporaryName();
  writeAll(folder / dead, "half");
  writeAll(folder / atWork, "half");
  const int file = open((folder / atWork).c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_TRUE(lockNamedTemporary(file));
  const std::string folderName = temporaryName(), link = temporaryName();
  fs::create_directory(folder / folderName);
  fs::create_symlink(target, folder / link);
  const std::vector<std::string> others = {".vides-", ".vides-0123456789abcdeg",
                                           ".vides-0123456789abcdef.vid", "vides-0123456789abcdef"};
  for (const std::string& name : others) writeAll(folder / name, "mine");
  EXPECT_EQ(save(target, "text"), "");
  std::vector<std::string> left = others;
  left.insert(left.end(), {"flight.vid", atWork, folderName, link});
  EXPECT_THAT(namesIn(folder.path()), testing::UnorderedElementsAreArray(left));
  close(file);
  EXPECT_EQ(save(target, "text"), "");
  EXPECT_FALSE(fs::exists(folder / atWork));
}

// Two that save in a folder at the same time leave each other alone.
TEST_F(AtomicFileTest, SaversSideBySide) {
  AtomicFile one((folder / "one").string());
  one.write("one");
  EXPECT_EQ(save(folder / "two", "two"), "");
  EXPECT_TRUE(one.commit().has_value());
  EXPECT_EQ(readAll(folder / "one"), "one");
  EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("one", "two"));
}

// A file that came meanwhile is replaced like one that was there before.
TEST_F(AtomicFileTest, ATargetThatAppearsMeanwhileIsReplaced) {
  AtomicFile file(target.string());
  file.write("ours");
  writeAll(target, "theirs");
  EXPECT_TRUE(file.commit().has_value());
  EXPECT_EQ(readAll(target), "ours");
  EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("flight.vid"));
}

TEST_F(AtomicFileTest, NewFilesGetThePermissionsOfTheUmask) {
  EXPECT_EQ(inChild([&] {
              umask(027);
              return save(target, "x") == "" ? 0 : 1;
            }),
            0);
  EXPECT_EQ(modeOf(target), 0640U);
}

TEST_F(AtomicFileTest, ReplacedFilesKeepTheirPermissions) {
  for (const mode_t mode : {0600U, 0644U, 0666U, 0755U, 0660U}) {
    writeAll(target, "old");
    ASSERT_EQ(chmod(target.c_str(), mode), 0);
    EXPECT_EQ(save(target, "new"), "");
    EXPECT_EQ(modeOf(target), mode);
    EXPECT_EQ(readAll(target), "new");
  }
}

TEST_F(AtomicFileTest, TheTemporaryFileOfAPrivateFileIsPrivate) {
  writeAll(target, "old");
  ASSERT_EQ(chmod(target.c_str(), 0600), 0);
  AtomicFile file(target.string());
  for (const std::string& name : namesIn(folder.path())) EXPECT_EQ(modeOf(folder / name), 0600U);
}

TEST_F(AtomicFileTest, ReplacedFilesKeepTheirOwner) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  writeAll(target, "old");
  ASSERT_EQ(chown(target.c_str(), kNobody, 12345), 0);
  ASSERT_EQ(chmod(target.c_str(), 0640), 0);
  EXPECT_EQ(save(target, "new"), "");
  struct stat status {};
  ASSERT_EQ(stat(target.c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, kNobody);
  EXPECT_EQ(status.st_gid, 12345U);
  EXPECT_EQ(modeOf(target), 0640U);
}

// Another user's file in a folder that is open to all: its group can't be kept, so the group gets
// no more than the others.
TEST_F(AtomicFileTest, AGroupThatCannotBeKeptGetsNoMoreThanOthers) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may become another user";
  writeAll(target, "old");
  ASSERT_EQ(chown(target.c_str(), kNobody, 12345), 0);
  ASSERT_EQ(chmod(target.c_str(), 0664), 0);
  ASSERT_EQ(chmod(folder.path().c_str(), 0777), 0);
  EXPECT_EQ(inChild([&] {
              if (setgid(kNobody) != 0 || setuid(kNobody) != 0) return 2;
              return save(target, "new") == "" ? 0 : 1;
            }),
            0);
  EXPECT_EQ(modeOf(target), 0644U);
  EXPECT_EQ(readAll(target), "new");
}

TEST_F(AtomicFileTest, WriteProtectedFilesAndFoldersStayAsTheyAre) {
  writeAll(target, "old");
  ASSERT_EQ(chmod(target.c_str(), 0444), 0);
  ASSERT_EQ(chmod(folder.path().c_str(), 0777), 0);
  const auto asNobody = [&](const std::string& reason) {
    return inChild([&] {
      if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) return 2;
      return save(target, "new") == reason ? 0 : 1;
    });
  };
  EXPECT_EQ(asNobody("Permission denied"), 0);
  ASSERT_EQ(chmod(target.c_str(), 0666), 0);
  ASSERT_EQ(chmod(folder.path().c_str(), 0555), 0);
  EXPECT_EQ(asNobody("Permission denied"), 0);
  EXPECT_EQ(readAll(target), "old");
  ASSERT_EQ(chmod(folder.path().c_str(), 0733), 0);  // may be written, but not listed
  EXPECT_EQ(asNobody(""), 0);
  EXPECT_EQ(readAll(target), "new");
  ASSERT_EQ(chmod(folder.path().c_str(), 0755), 0);
}

TEST_F(AtomicFileTest, LinksAreFollowedAndStayLinks) {
  fs::create_directory(folder / "far");
  writeAll(folder / "far/real.vid", "old");
  fs::create_symlink("far/second", folder / "first");
  fs::create_symlink("real.vid", folder / "far/second");
  EXPECT_EQ(save(folder / "first", "new"), "");
  EXPECT_EQ(fs::read_symlink(folder / "first"), "far/second");
  EXPECT_EQ(fs::read_symlink(folder / "far/second"), "real.vid");
  EXPECT_FALSE(fs::is_symlink(folder / "far/real.vid"));
  EXPECT_EQ(readAll(folder / "far/real.vid"), "new");
  EXPECT_THAT(namesIn(folder / "far"), testing::ElementsAre("real.vid", "second"));
}

TEST_F(AtomicFileTest, LinksThatLeadToNothingYetAreFollowed) {
  fs::create_symlink((folder / "real.vid").string(), target);
  EXPECT_EQ(save(target, "new"), "");
  EXPECT_TRUE(fs::is_symlink(target));
  EXPECT_EQ(readAll(folder / "real.vid"), "new");
}

TEST_F(AtomicFileTest, LinksInACircleAreAnError) {
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  EXPECT_EQ(save(folder / "a", "new"), "Too many levels of symbolic links");
}

// The system would see another name, the one up to it.
TEST_F(AtomicFileTest, ANameWithNulIsRefused) {
  EXPECT_EQ(save(target.string() + std::string("\0.vid", 5), "x"), "Invalid argument");
  EXPECT_THAT(namesIn(folder.path()), testing::IsEmpty());
}

TEST_F(AtomicFileTest, NamesAsLongAsTheSystemAllows) {
  const std::string name(255, 'n');
  EXPECT_EQ(save(folder / name, "new"), "");
  EXPECT_EQ(readAll(folder / name), "new");
  EXPECT_EQ(save(folder / (name + "n"), "new"), "File name too long");
}

TEST_F(AtomicFileTest, WhatCannotBeWrittenHasAReason) {
  EXPECT_EQ(save(folder / "none/flight.vid", "new"), "No such file or directory");
  EXPECT_EQ(save(folder.path(), "new"), "Is a directory");
  EXPECT_EQ(save("", "new"), "No such file or directory");
  writeAll(target, "old");
  EXPECT_EQ(save(target / "flight.vid", "new"), "Not a directory");
  EXPECT_EQ(save("/dev/full", "new"), "No space left on device");
  EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("flight.vid"));
  EXPECT_EQ(readAll(target), "old");
}

TEST_F(AtomicFileTest, NothingMoreIsWrittenAfterAnError) {
  AtomicFile file("/dev/full");
  EXPECT_TRUE(file.write("buffered"));
  EXPECT_FALSE(file.write(std::string(100'000, 'x')));
  ASSERT_TRUE(file.error().has_value());
  EXPECT_EQ(file.error()->number, ENOSPC);
  EXPECT_EQ(file.error()->path, "/dev/full");
  EXPECT_FALSE(file.write("x"));
  EXPECT_FALSE(file.commit().has_value());
}

TEST_F(AtomicFileTest, AFileThatMayNotGrowLeavesTheOldOne) {
  writeAll(target, "old");
  EXPECT_EQ(inChild([&] {
              signal(SIGXFSZ, SIG_IGN);
              const rlimit limit{100'000, 100'000};
              setrlimit(RLIMIT_FSIZE, &limit);
              return save(target, std::string(300'000, 'n')) == "File too large" ? 0 : 1;
            }),
            0);
  EXPECT_EQ(readAll(target), "old");
  EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("flight.vid"));
}

TEST_F(AtomicFileTest, DevicesAndPipesAreWrittenDirectly) {
  EXPECT_EQ(save("/dev/null", "x"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_EQ(save(pipe, "through"), "");
  char text[16] = {};
  EXPECT_EQ(read(reader, text, sizeof text), 7);
  EXPECT_STREQ(text, "through");
  close(reader);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

// Standard output may be a file that others write to as well: it is added to, not replaced.
TEST_F(AtomicFileTest, StandardOutputIsWrittenWhereItStands) {
  for (const char* name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    const test::ProcessResult result = test::runProcess(
        {"/bin/sh", "-c",
         "exec > \"$1\"; echo before; \"$2\" " + std::string(name) + " 3 x; echo after", "sh",
         target.string(), VIDES_SAVE_PROGRAM});
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(readAll(target), "before\nxxxafter\n") << name;
  }
  const test::ProcessResult piped = test::runProcess({VIDES_SAVE_PROGRAM, "/dev/stdout", "5", "y"});
  EXPECT_EQ(piped.output, "yyyyy");
}

}  // namespace
}  // namespace vides
