// SPDX-License-Identifier: MIT
// The program in a real window on a screen in memory: what a hand does there ends up in the file.
//
// The same editor without a screen runs beside it and is told the same. It says where things are
// seen, and what the window's file must come to; each has its own copy of the flight.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <sstream>
#include <thread>

#include "app/drive/player.hpp"
#include "host/open_host.hpp"
#include "host/x_peer.hpp"
#include "support/files.hpp"
#include "support/picture_check.hpp"
#include "support/process.hpp"
#include "support/screen.hpp"

namespace vides {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// Long enough for a busy machine; only a failure takes that long.
constexpr std::chrono::seconds kPatience(120);

bool waitUntil(const std::function<bool()>& holds) {
  const auto start = steady_clock::now();
  while (!holds()) {
    if (steady_clock::now() - start > kPatience) return false;
    std::this_thread::sleep_for(milliseconds(10));
  }
  return true;
}

std::string xdotool(const std::string& arguments) {
  std::vector<std::string> command = {"xdotool"};
  std::istringstream stream(arguments);
  for (std::string word; stream >> word;) command.push_back(word);
  const auto result = test::runProcess(command);
  return result.status == 0 ? result.output : std::string();
}

// How often the process' main thread, which draws all display frames, has gone to sleep; negative
// while it is awake. The same number twice means one and the same sleep: nothing was drawn between.
long sleeps(pid_t process) {
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

    program_.emplace(std::vector<std::string>{VIDES_PROGRAM, file("window").string()});
    ASSERT_TRUE(waitUntil([&] {
      const std::string id = xdotool("search --onlyvisible --class ^vides$");
      if (!id.empty()) window_ = std::stoul(id);
      return window_ != 0 || program_->ended();
    }));
    ASSERT_FALSE(program_->ended()) << *program_->ended();
    // Its first picture is there; then it has nothing more to do.
    ASSERT_TRUE(waitUntil([&] { return peer_.screenshot(window_).pixel(640, 790)[0] > 0; }));
    ASSERT_TRUE(fallsAsleep());
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
  test::Screen screen_;
  test::XPeer peer_;
  std::unique_ptr<OffscreenHost> host_;
  std::unique_ptr<Player> twin_;
  std::optional<test::RunningProcess> program_;
  unsigned long window_ = 0;
};

TEST_F(WindowTest, DragsAndTypesAndSaves) {
  // An empty place turns the view, so that all that follows is aimed at where it has turned to.
  const EditorView before = twin_->editor().session().view().view;
  const Rect seen = twin_->editor().viewport();
  drag(PointerButton::kLeft,
       {static_cast<double>(seen.x) + 60.0, static_cast<double>(seen.y) + 90.0}, 35, 12);
  const EditorView turned = twin_->editor().session().view().view;
  ASSERT_NE(turned.turn, before.turn);
  ASSERT_NE(turned.tilt, before.tilt);

  // Each button keeps its own coordinate and moves the two others.
  const PointerButton buttons[] = {PointerButton::kLeft, PointerButton::kMiddle,
                                   PointerButton::kRight};
  for (int axis = 0; axis < 3; ++axis) {
    const auto key = static_cast<std::size_t>(axis);
    const Vec3 from = position(key);
    drag(buttons[axis], placeOf(key), 14, -10);
    const Vec3 to = position(key);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(to[i] == from[i], i == axis) << "key " << key << ", coordinate " << i;
    }
    expectSavedAlike("dragged along plane " + std::to_string(axis));
  }

  const Widget* field = twin_->editor().widgets().find("position/x");
  ASSERT_NE(field, nullptr);
  const std::string at = std::to_string(std::lround(field->rect.centreX())) + " " +
                         std::to_string(std::lround(field->rect.centreY()));
  xdotool("mousemove " + at + " click 1 key ctrl+a type 0.125");
  xdotool("key Return");
  ASSERT_TRUE(twin_->setWidget("position/x", "0.125"));
  EXPECT_EQ(position(twin_->editor().session().current().key).x, 0.125);
  expectSavedAlike("typed");

  // What the screen shows is what the twin shows, within what two drivers may differ.
  twin_->move(640, 790);
  xdotool("mousemove 640 790");
  ASSERT_TRUE(fallsAsleep());
  for (int i = 0; i < 60; ++i) twin_->frame();
  PictureTolerance tolerance;
  tolerance.share = kEglShare;
  EXPECT_TRUE(test::equalsPicture(peer_.screenshot(window_), twin_->picture().value(),
                                  "window_on_screen", tolerance));

  // Nothing is unsaved: the window goes without a question.
  peer_.requestClose(window_);
  ASSERT_TRUE(waitUntil([&] { return program_->ended().has_value(); }));
  EXPECT_EQ(program_->ended(), 0);
}

TEST_F(WindowTest, DrawsNothingWhileNothingHappens) {
  const long before = sleeps(program_->id());
  ASSERT_GT(before, 0);
  std::this_thread::sleep_for(std::chrono::seconds(3));  // what is measured, not a wait for it
  EXPECT_EQ(sleeps(program_->id()), before);
  // The counter tells a cause.
  xdotool("mousemove 500 300");
  EXPECT_TRUE(waitUntil([&] { return sleeps(program_->id()) > before; }));
}

}  // namespace
}  // namespace vides
