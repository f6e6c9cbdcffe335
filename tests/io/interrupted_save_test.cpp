// SPDX-License-Identifier: MIT
// Saving, interrupted: every system call fails in turn, the process is killed at each, signals
// arrive halfway. The file is the old one or the new one, whole.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/files.hpp"
#include "support/process.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBytes = 200'000;  // several writes
const std::string kOld(1000, 'o');
const std::string kNew(kBytes, 'n');

// What touches files or their contents.
const std::string kCalls =
    "open,openat,newfstatat,fstat,stat,lstat,readlink,readlinkat,access,faccessat,faccessat2,"
    "getrandom,getxattr,fsetxattr,fchown,fchmod,fcntl,write,fsync,close,rename,renameat,renameat2,"
    "unlink,unlinkat,linkat,flock,getdents64,geteuid,getuid";

struct Outcome {
  test::ProcessResult process;
  std::string content;
  std::size_t temporaryFiles = 0;
  std::size_t temporaryFilesAfterwards = 0;  // when the folder was saved into once more
};

// Saves over an old file, under strace with these options.
Outcome saveUnder(const std::vector<std::string>& options, const std::string& log = "/dev/null") {
  const test::TemporaryFolder folder;
  const fs::path target = folder / "flight.vid";
  test::writeAll(target, kOld);
  std::vector<std::string> command = {"strace", "-f", "-o", log};
  command.insert(command.end(), options.begin(), options.end());
  for (const std::string& word : {std::string(VIDES_SAVE_PROGRAM), target.string(),
                                  std::to_string(kBytes), std::string("n")}) {
    command.push_back(word);
  }
  Outcome outcome;
  // The leak checker can't run under strace.
  outcome.process = test::runProcess(command, {"ASAN_OPTIONS=detect_leaks=0", "LC_ALL=C"});
  outcome.content = fs::exists(target) ? test::readAll(target) : "gone";
  const auto others = [&] {
    const auto isOther = [&](const auto& entry) { return entry.path() != target; };
    return static_cast<std::size_t>(
        std::count_if(fs::directory_iterator(folder.path()), fs::directory_iterator(), isOther));
  };
  outcome.temporaryFiles = others();
  EXPECT_EQ(test::runProcess({VIDES_SAVE_PROGRAM, target.string(), "10", "z"}).status, 0);
  EXPECT_EQ(test::readAll(target), std::string(10, 'z'));
  outcome.temporaryFilesAfterwards = others();
  return outcome;
}

std::string inject(const std::string& call, const std::string& what, int when) {
  return "inject=" + call + ":" + what + ":when=" + std::to_string(when);
}

// How often a successful save makes each call, under strace with these options, too.
std::map<std::string, int> countCalls(const std::vector<std::string>& options = {}) {
  const test::TemporaryFolder folder;
  const fs::path log = folder / "log";
  std::vector<std::string> all = {"-e", "trace=" + kCalls};
  all.insert(all.end(), options.begin(), options.end());
  const Outcome outcome = saveUnder(all, log.string());
  EXPECT_EQ(outcome.process.status, 0) << outcome.process.errors;
  EXPECT_EQ(outcome.content, kNew);
  std::map<std::string, int> counts;
  std::istringstream lines(test::readAll(log));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t start = line.find_first_not_of("0123456789 ");
    const std::size_t end = line.find('(');
    if (start < end && end != line.npos) ++counts[line.substr(start, end - start)];
  }
  return counts;
}

class InterruptedSave : public testing::Test {
 protected:
  void SetUp() override {
    const test::ProcessResult result = test::runProcess({"strace", "-o", "/dev/null", "true"});
    if (result.status != 0) GTEST_SKIP() << "strace can't be used here: " << result.errors;
  }
};

// A file system that can't do without names: the options under which the one call that opens a file
// without a name fails.
std::vector<std::string> withoutUnnamedFiles() {
  const test::TemporaryFolder folder;
  const fs::path log = folder / "log";
  saveUnder({"-e", "trace=openat"}, log.string());
  std::istringstream lines(test::readAll(log));
  int calls = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("openat(") == line.npos) continue;
    ++calls;
    if (line.find("O_TMPFILE") != line.npos) break;
  }
  return {"-e", inject("openat", "error=EOPNOTSUPP", calls)};
}

void checkFailedCall(const std::string& call, const std::string& error, int when) {
  SCOPED_TRACE(call + " fails with " + error + " at its call " + std::to_string(when));
  const Outcome outcome = saveUnder({"-e", inject(call, "error=" + error, when)});
  if (outcome.process.status == 0) {
    EXPECT_TRUE(outcome.content == kNew);
  } else {
    EXPECT_TRUE(outcome.content == kOld || outcome.content == kNew);
  }
  EXPECT_EQ(outcome.temporaryFiles, 0U);
}

TEST_F(InterruptedSave, EveryCallFailsInTurn) {
  const std::map<std::string, int> counts = countCalls();
  // If these weren't seen, nothing was tried.
  for (const char* call : {"write", "fsync", "close"}) ASSERT_TRUE(counts.contains(call)) << call;
  for (const auto& [call, count] : counts) {
    for (int when = 1; when <= count; ++when) {
      checkFailedCall(call, call == "write" ? "ENOSPC" : "EIO", when);
    }
  }
}

TEST_F(InterruptedSave, AFullDiskIsTold) {
  for (const auto& [call, error, told] :
       {std::tuple{"write", "ENOSPC", "No space left on device"},
        std::tuple{"fsync", "ENOSPC", "No space left on device"},
        std::tuple{"fsync", "EIO", "Input/output error"},
        std::tuple{"renameat", "EIO", "Input/output error"},
        std::tuple{"fchmod", "EPERM", "Operation not permitted"}}) {
    const Outcome outcome = saveUnder({"-e", inject(call, std::string("error=") + error, 1)});
    EXPECT_EQ(outcome.process.status, 1) << call;
    EXPECT_NE(outcome.process.errors.find(told), std::string::npos) << outcome.process.errors;
    EXPECT_TRUE(outcome.content == kOld) << call;
    EXPECT_EQ(outcome.temporaryFiles, 0U) << call;
  }
}

TEST_F(InterruptedSave, InterruptedCallsAreRepeated) {
  for (const char* call : {"write", "fsync", "getrandom"}) {
    const Outcome outcome = saveUnder({"-e", inject(call, "error=EINTR", 1)});
    EXPECT_EQ(outcome.process.status, 0) << call << outcome.process.errors;
    EXPECT_TRUE(outcome.content == kNew) << call;
  }
}

// Killed at every call, with and without names for temporary files. What stands around is gone
// when the folder is next saved into.
TEST_F(InterruptedSave, KilledAtEveryCall) {
  for (const auto& options : {std::vector<std::string>(), withoutUnnamedFiles()}) {
    for (const auto& [call, count] : countCalls(options)) {
      if (!options.empty() && call == "openat") continue;  // strace does one thing to a call
      for (int when = 1; when <= count; ++when) {
        SCOPED_TRACE(call + ": killed at its call " + std::to_string(when));
        std::vector<std::string> all = options;
        all.insert(all.end(), {"-e", inject(call, "signal=SIGKILL", when)});
        const Outcome outcome = saveUnder(all);
        EXPECT_TRUE(outcome.content == kOld || outcome.content == kNew);
        EXPECT_LE(outcome.temporaryFiles, 1U);
        EXPECT_EQ(outcome.temporaryFilesAfterwards, 0U);
      }
    }
  }
}

// Where the file system can, nothing has a name while it is written: killed there, nothing is left.
TEST_F(InterruptedSave, WhatIsWrittenHasNoName) {
  for (const char* call : {"write", "fsync"}) {
    const Outcome outcome = saveUnder({"-e", inject(call, "signal=SIGKILL", 1)});
    EXPECT_TRUE(outcome.content == kOld) << call;
    EXPECT_EQ(outcome.temporaryFiles, 0U) << call;
  }
}

class SignalledSave : public testing::TestWithParam<int> {};

TEST_P(SignalledSave, LeavesTheOldFileAndNothingElse) {
  const test::TemporaryFolder folder;
  const fs::path target = folder / "flight.vid";
  test::writeAll(target, kOld);
  int out[2];
  ASSERT_EQ(pipe(out), 0);
  const pid_t child = fork();
  if (child == 0) {
    dup2(out[1], STDOUT_FILENO);
    execl(VIDES_SAVE_PROGRAM, VIDES_SAVE_PROGRAM, target.c_str(), "200000", "n", "pause", nullptr);
    _exit(127);
  }
  close(out[1]);
  char text[4] = {};
  ASSERT_EQ(read(out[0], text, sizeof text), 4);  // "half": it is written, and it waits
  close(out[0]);
  kill(child, GetParam());
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), GetParam());
  EXPECT_TRUE(test::readAll(target) == kOld);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

INSTANTIATE_TEST_SUITE_P(Signals, SignalledSave, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace vides
