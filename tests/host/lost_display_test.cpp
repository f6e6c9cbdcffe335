// SPDX-License-Identifier: MIT
// A Wayland compositor that ends, played by functions of the names that GLFW's build for Wayland
// and its library have. (The X server's end is tried with a real one: tests/app/kept_test.cpp.)
#include "host/lost_display.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>

namespace {
int display = 0;       // its address counts
int displayError = 0;  // of the connection, once it is read
int flushError = 0;    // of writing
}  // namespace

extern "C" void* glfwGetWaylandDisplay();
extern "C" void* glfwGetWaylandDisplay() { return &display; }
extern "C" int wl_display_get_error(void* asked);
extern "C" int wl_display_get_error(void* asked) { return asked == &display ? displayError : 0; }
extern "C" int wl_display_flush(void* asked);
extern "C" int wl_display_flush(void* asked) {
  if (asked != &display || flushError == 0) return 0;
  errno = flushError;
  return -1;
}

namespace vides {
namespace {

TEST(LostDisplay, NothingHappensWhileTheCompositorIsThere) {
  displayError = 0;
  bool called = false;
  LostDisplay watch([&] { called = true; });
  watch.check();
  flushError = EAGAIN;  // it is only busy
  watch.check();
  EXPECT_FALSE(called);
  flushError = 0;
}

TEST(LostDisplayDeathTest, EveryWindowHasItsLastWordAndNoneThatIsGone) {
  const auto lose = [] {
    LostDisplay first([] { std::fputs("first\n", stderr); });
    {
      LostDisplay gone([] { std::fputs("gone\n", stderr); });
    }
    LostDisplay second([] { std::fputs("second\n", stderr); });
    LostDisplay silent({});
    displayError = EPIPE;
    second.check();
  };
  EXPECT_EXIT(lose(), testing::ExitedWithCode(1), "^first\nsecond\n$");
}

TEST(LostDisplayDeathTest, WhatThrowsThenDoesNotEndItOtherwise) {
  const auto lose = [] {
    LostDisplay first([] { throw std::runtime_error("no memory"); });
    LostDisplay second([] { std::fputs("kept\n", stderr); });
    displayError = EPIPE;
    first.check();
  };
  EXPECT_EXIT(lose(), testing::ExitedWithCode(1), "^kept\n$");
}

TEST(LostDisplayDeathTest, ALostCompositorEndsTheProgramAfterTheLastWord) {
  const auto lose = [](int& error) {
    LostDisplay watch([] { std::fputs("kept\n", stderr); });
    error = EPIPE;
    watch.check();
    std::fputs("still there\n", stderr);
  };
  EXPECT_EXIT(lose(displayError), testing::ExitedWithCode(1), "^kept\n$");
  EXPECT_EXIT(lose(flushError), testing::ExitedWithCode(1), "^kept\n$");
}

}  // namespace
}  // namespace vides
