// SPDX-License-Identifier: MIT
// The program in a real window on a screen in memory, and the same editor without a screen beside
// it.
//
// The twin is told the same. It says where things are seen, and what the window's file must come
// to; each has its own copy of the flight. The window's setup and state lie in the test's folder.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <sstream>
#include <thread>
#include <vector>

#include "app/drive/player.hpp"
#include "host/open_host.hpp"
#include "host/x_peer.hpp"
#include "support/files.hpp"
#include "support/picture_check.hpp"
#include "support/process.hpp"
#include "support/screen.hpp"

namespace vides {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// Long enough for a busy machine; only a failure takes that long.
inline constexpr std::chrono::seconds kPatience(120);

inline bool waitUntil(const std::function<bool()>& holds) {
  const auto start = steady_clock::now();
  while (!holds()) {
    if (steady_clock::now() - start > kPatience) return false;
    std::this_thread::sleep_for(milliseconds(10));
  }
  return true;
}

inline std::string xdotool(const std::string& arguments) {
  std::vector<std::string> command = {"xdotool"};
  std::istringstream stream(arguments);
  for (std::string word; stream >> word;) command.push_back(word);
  const auto result = test::runProcess(command);
  return result.status == 0 ? result.output : std::string();
}

// How often the process' main thread, which draws all display frames, has gone to sleep; negative
// while it is awake. The same number twice means one and the same sleep: nothing was drawn between.
inline long sleeps(pid_t process) {
  const std::string id = std::to_string(process);
  std::istringstream status(test::readAll("/proc/" + id + "/task/" + id + "/status"));
  bool asleep = false;
  long count = -1;
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("State:")) asleep = line.find("S (") != std::string::npos;
    if (line.starts_with("voluntary_ctxt_switches:")) count = std::stol(line.substr(24));
  }
  return asleep ? count : -1;
}

class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* who : {"window", "twin"}) {
      std::filesystem::copy(std::string(VIDES_SOURCE_DIR) + "/assets", folder_ / who,
                            std::filesystem::copy_options::recursive);
    }
    OffscreenOptions options;
    options.size = {1280, 800};
    auto host = openOffscreen(OffscreenKind::kOsmesa, options);
    ASSERT_TRUE(host) << host.error();
    host_ = std::move(*host);
    auto twin = Player::create(*host_);
    ASSERT_TRUE(twin) << twin.error();
    twin_ = std::move(*twin);
    ASSERT_TRUE(twin_->perform(Command("open", file("twin").string())));
    for (int i = 0; i < 5; ++i) twin_->frame();

    begin();
  }

  // What stands before the program's first start belongs into an override of this.
  virtual void begin() { startProgram({file("window").string()}); }

  std::vector<std::string> environment() const {
    return {"XDG_CONFIG_HOME=" + (folder_ / "config").string(),
            "XDG_STATE_HOME=" + (folder_ / "state").string()};
  }

  // What the program has written to its standard error.
  std::string errors() const { return test::readAll(folder_ / "errors"); }

  // Its first picture is there; then it has nothing more to do.
  void startProgram(std::vector<std::string> arguments) {
    window_ = 0;
    arguments.insert(arguments.begin(), {"sh", "-c", "exec \"$@\" 2> \"$0\"",
                                         (folder_ / "errors").string(), VIDES_PROGRAM});
    program_.emplace(arguments, environment());
    ASSERT_TRUE(waitUntil([&] {
      const std::string id = xdotool("search --onlyvisible --class ^vides$");
      if (!id.empty()) window_ = std::stoul(id);
      return window_ != 0 || program_->ended();
    }));
    ASSERT_FALSE(program_->ended()) << *program_->ended() << '\n' << errors();
    ASSERT_TRUE(waitUntil([&] { return peer_->screenshot(window_).pixel(640, 790)[0] > 0; }));
    ASSERT_TRUE(fallsAsleep());
  }

  // The window's own way to its end; nothing may be unsaved.
  void closeProgram() {
    peer_->requestClose(window_);
    ASSERT_TRUE(waitUntil([&] { return program_->ended().has_value(); }));
    EXPECT_EQ(program_->ended(), 0) << errors();
    program_.reset();
  }

  // A widget of both, where the twin has it.
  void clickBoth(const std::string& id) {
    for (int i = 0; i < 3; ++i) twin_->frame();
    const Widget* widget = twin_->editor().widgets().find(id);
    ASSERT_NE(widget, nullptr) << id;
    const long x = std::lround(widget->rect.centreX());
    const long y = std::lround(widget->rect.centreY());
    xdotool("mousemove " + std::to_string(x) + " " + std::to_string(y));
    ASSERT_TRUE(fallsAsleep());
    xdotool("mousedown 1");
    ASSERT_TRUE(fallsAsleep());
    xdotool("mouseup 1");
    ASSERT_TRUE(fallsAsleep());
    twin_->click(static_cast<double>(x), static_cast<double>(y));
  }

  std::filesystem::path file(const std::string& whose) const {
    return folder_ / whose / "flights" / "pyramid.vid";
  }

  // Waits until the program sleeps for longer than any of its own waits (a tooltip's) lasts.
  bool fallsAsleep() {
    long since = -1;
    auto start = steady_clock::now();
    return waitUntil([&] {
      const long now = sleeps(program_->id());
      if (now >= 0 && now == since) return steady_clock::now() - start > milliseconds(1000);
      since = now;
      start = steady_clock::now();
      return false;
    });
  }

  void keyBoth(KeyboardKey key, const Modifiers& modifiers, const std::string& xName) {
    twin_->tap(key, modifiers);
    xdotool("key " + xName);
    ASSERT_TRUE(fallsAsleep());
  }

  // On whole pixels, since the pointer of the screen stands there only.
  void drag(PointerButton button, const Vec2& from, int right, int down) {
    const int x = static_cast<int>(std::lround(from.x));
    const int y = static_cast<int>(std::lround(from.y));
    const std::string number = std::to_string(button == PointerButton::kLeft     ? 1
                                              : button == PointerButton::kMiddle ? 2
                                                                                 : 3);
    const auto to = [](int a, int b) {
      return "mousemove " + std::to_string(a) + " " + std::to_string(b) + " ";
    };
    xdotool(to(x, y) + "mousedown " + number + " " + to(x + right / 2, y + down / 2) +
            to(x + right, y + down) + "mouseup " + number);
    twin_->move(x, y);
    twin_->button(button, true);
    twin_->move(x + right / 2, y + down / 2);
    twin_->move(x + right, y + down);
    twin_->button(button, false);
  }

  // What the screen shows is what the twin shows, within what two drivers may differ.
  void expectOnScreen(const std::string& name) {
    twin_->move(640, 790);
    xdotool("mousemove 640 790");
    ASSERT_TRUE(fallsAsleep());
    for (int i = 0; i < 60; ++i) twin_->frame();
    PictureTolerance tolerance;
    tolerance.share = kEglShare;
    EXPECT_TRUE(
        test::equalsPicture(peer_->screenshot(window_), twin_->picture().value(), name, tolerance));
  }

  Vec2 placeOf(std::size_t key) {
    const Rect rect = twin_->editor().viewport();
    const PixelRectangle pixels{static_cast<double>(rect.x), static_cast<double>(rect.y),
                                static_cast<double>(rect.width), static_cast<double>(rect.height)};
    const Session& session = twin_->editor().session();
    return viewProjection(session.view().view, pixels).project(position(key)).value();
  }
  Vec3 position(std::size_t key) const {
    return twin_->editor().session().flight().keys[key].position;
  }

  // Both save; the files become equal and differ from what they were.
  void expectSavedAlike(const std::string& what) {
    const std::string before = test::readAll(file("twin"));
    twin_->tap(KeyboardKey::kS, {.control = true});
    xdotool("key ctrl+s");
    const std::string wanted = test::readAll(file("twin"));
    EXPECT_NE(wanted, before) << what;
    std::string found;
    EXPECT_TRUE(waitUntil([&] { return (found = test::readAll(file("window"))) == wanted; }))
        << what << "; the window's file is\n"
        << found << "\nand should be\n"
        << wanted;
  }

  test::TemporaryFolder folder_;
  std::optional<test::Screen> screen_{std::in_place};
  std::optional<test::XPeer> peer_{std::in_place};
  std::unique_ptr<OffscreenHost> host_;
  std::unique_ptr<Player> twin_;
  std::optional<test::RunningProcess> program_;
  unsigned long window_ = 0;
};

}  // namespace vides
