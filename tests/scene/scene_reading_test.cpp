// SPDX-License-Identifier: MIT
// A reading is a result, whatever it runs into, and nobody waits for one that is given up.
#include "scene/scene_reading.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "support/files.hpp"

namespace vides {
namespace {

std::string largeScene() {
  std::string text;
  for (int i = 0; i < 20000; ++i) {
    const std::string x = std::to_string(i % 173), y = std::to_string(i % 91);
    text += "v " + x + " " + y + " 1\nv " + y + " " + x + " 2\nl -1 -2\n";
  }
  return text;
}

// Opening a scene is no reason to end because there is no room for a thread.
TEST(SceneReading, WithoutAThreadItHasEndedAndSaysWhy) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need the address space";
#endif
  const test::TemporaryFolder folder;
  test::writeAll(folder / "s.obj", "v 0 0 0\nv 1 1 1\nl 1 2\n");
  const pid_t child = fork();
  if (child == 0) {
    // Less than a thread's stack is left.
    std::ifstream statm("/proc/self/statm");
    std::size_t pages = 0;
    statm >> pages;
    const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + (1 << 20);
    const struct rlimit limit { most, most };
    setrlimit(RLIMIT_AS, &limit);
    const auto reading = std::make_shared<SceneReading>(folder / "s.obj");
    const bool good = reading->ended() && !*reading->result() &&
                      reading->result()->error().fault == SceneFault::kUnreadable;
    _exit(good ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(SceneReading, GivenUpItEndsByItself) {
  const test::TemporaryFolder folder;
  test::writeAll(folder / "s.obj", largeScene());
  for (int i = 0; i < 50; ++i) SceneReading(folder / "s.obj");
  SceneReading last(folder / "s.obj");
  last.wait();
  EXPECT_TRUE(last.result()->has_value());
}

}  // namespace
}  // namespace vides
