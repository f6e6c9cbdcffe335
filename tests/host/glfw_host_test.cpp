// SPDX-License-Identifier: MIT
// A real window on a screen in memory: what a hand does to it arrives as events.
#include "host/glfw_host.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <optional>
#include <sstream>
#include <thread>

#include "host/x_peer.hpp"
#include "support/picture_check.hpp"
#include "support/process.hpp"
#include "support/screen.hpp"
#include "support/triangle.hpp"

// What GLX's drivers keep until the process ends cannot be told apart from a leak of ours.
extern "C" int __lsan_is_turned_off();
extern "C" int __lsan_is_turned_off() { return 1; }

namespace vides {
namespace {

using std::chrono::steady_clock;
using test::runProcess;
using test::XPeer;
using testing::HasSubstr;
using testing::StartsWith;

// Long enough for a busy machine; only a failure takes that long.
constexpr std::chrono::seconds kPatience(30);

void xdotool(const std::string& arguments) {
  std::vector<std::string> command = {"xdotool"};
  std::istringstream stream(arguments);
  for (std::string word; stream >> word;) command.push_back(word);
  const auto result = runProcess(command);
  ASSERT_EQ(result.status, 0) << arguments << ": " << result.errors;
}

class GlfwHostTest : public testing::Test {
 protected:
  void open(PixelSize size = {640, 480}) {
    WindowOptions options;
    options.size = size;
    options.title = "vides test";
    options.samples = 4;  // the triangle has no other smooth edges
    auto opened = openGlfwHost(options);
    ASSERT_TRUE(opened) << opened.error();
    host_ = std::move(*opened);
    expect<Exposed>([](const Exposed&) { return true; });  // it is on the screen
  }

  // Takes events until one of that kind for which `wanted` holds; those before it are forgotten.
  // Events after it stay for the next call.
  template <typename Event>
  std::optional<Event> find(const std::function<bool(const Event&)>& wanted) {
    const auto start = steady_clock::now();
    while (steady_clock::now() - start < kPatience) {
      for (std::size_t i = 0; i < events_.size(); ++i) {
        const auto* event = std::get_if<Event>(&events_[i]);
        if (event == nullptr || !wanted(*event)) continue;
        const Event found = *event;
        events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        return found;
      }
      host_->waitForEvents(std::chrono::milliseconds(100));
      for (InputEvent& event : host_->takeEvents()) events_.push_back(std::move(event));
    }
    return std::nullopt;
  }
  template <typename Event>
  void expect(const std::function<bool(const Event&)>& wanted, const std::string& what = "") {
    EXPECT_TRUE(find<Event>(wanted)) << "no such event: " << what;
  }
  template <typename Event>
  void expect(const Event& event, const std::string& what = "") {
    expect<Event>([&](const Event& other) { return other == event; }, what);
  }

  unsigned long windowId() {
    const auto result = runProcess({"xdotool", "search", "--name", "^vides test$"});
    return result.output.empty() ? 0 : std::stoul(result.output);
  }

  test::Screen screen_;
  std::unique_ptr<Host> host_;
  std::vector<InputEvent> events_;
};

TEST_F(GlfwHostTest, OpensAndDraws) {
  open({200, 100});
  EXPECT_EQ(host_->size(), (PixelSize{200, 100}));
  EXPECT_EQ(host_->contentScale(), 1.0);
  ASSERT_TRUE(test::drawTriangle(*host_));
  // The screen's server shows it in its own time.
  const unsigned long window = windowId();
  XPeer peer;
  Picture picture;
  const auto start = steady_clock::now();
  do {
    host_->takeEvents();
    picture = peer.screenshot(window);
  } while (picture.width == 200 && picture.pixel(100, 60)[0] == 0 &&
           steady_clock::now() - start < kPatience);
  EXPECT_TRUE(test::equalsBaseline(picture, "host_triangle"));
}

TEST_F(GlfwHostTest, PointerAndButtons) {
  open();
  xdotool("mousemove 100 80");
  expect(PointerMoved{100, 80});
  const PointerButton buttons[] = {PointerButton::kLeft, PointerButton::kMiddle,
                                   PointerButton::kRight};
  for (int i = 0; i < 3; ++i) {
    xdotool("mousedown " + std::to_string(i + 1));
    expect(ButtonChanged{buttons[i], true, {}});
    xdotool("mousemove_relative 5 3");
    expect(PointerMoved{100.0 + 5 * (i + 1), 80.0 + 3 * (i + 1)});
    xdotool("mouseup " + std::to_string(i + 1));
    expect(ButtonChanged{buttons[i], false, {}});
  }
  xdotool("keydown ctrl mousedown 1 mouseup 1 keyup ctrl");
  expect(ButtonChanged{PointerButton::kLeft, true, {.control = true}});
  expect(ButtonChanged{PointerButton::kLeft, false, {.control = true}});
  xdotool("mousemove 1000 700");
  expect(PointerLeft{});
}

TEST_F(GlfwHostTest, Wheel) {
  open();
  xdotool("mousemove 100 80 click 4");
  expect(WheelTurned{0, 1}, "away from the user");
  xdotool("click 5");
  expect(WheelTurned{0, -1}, "towards the user");
  xdotool("click 6");
  expect(WheelTurned{-1, 0}, "left");
  xdotool("click 7");
  expect(WheelTurned{1, 0}, "right");
}

TEST_F(GlfwHostTest, KeysWithModifiersAfterTheChange) {
  open();
  xdotool("mousemove 100 80 keydown ctrl keydown shift key z keyup shift keyup ctrl");
  const Modifiers control{.control = true};
  const Modifiers both{.shift = true, .control = true};
  expect(KeyChanged{KeyboardKey::kLeftControl, true, false, control});
  expect(KeyChanged{KeyboardKey::kLeftShift, true, false, both});
  expect(KeyChanged{KeyboardKey::kZ, true, false, both});
  expect(KeyChanged{KeyboardKey::kZ, false, false, both});
  expect(KeyChanged{KeyboardKey::kLeftShift, false, false, control});
  expect(KeyChanged{KeyboardKey::kLeftControl, false, false, {}});
  // One of two Shift keys let go: Shift is still held.
  xdotool("keydown Shift_L keydown Shift_R keyup Shift_L");
  expect(KeyChanged{KeyboardKey::kLeftShift, false, false, {.shift = true}});
  xdotool("keyup Shift_R key Page_Up key F11 key KP_7 key Escape");
  for (const KeyboardKey key :
       {KeyboardKey::kPageUp, KeyboardKey::kF11, KeyboardKey::kPad7, KeyboardKey::kEscape}) {
    expect(KeyChanged{key, true, false, {}}, std::string(keyName(key)));
  }
}

TEST_F(GlfwHostTest, HeldKeyRepeats) {
  open();
  xdotool("mousemove 100 80 keydown Right");
  expect(KeyChanged{KeyboardKey::kRight, true, false, {}});
  expect(KeyChanged{KeyboardKey::kRight, true, true, {}});
  xdotool("keyup Right");
  expect(KeyChanged{KeyboardKey::kRight, false, false, {}});
}

TEST_F(GlfwHostTest, Text) {
  open();
  xdotool("mousemove 100 80 type aZ7");
  for (const char* text : {"a", "Z", "7"}) expect(TextTyped{text}, text);
}

// Key code 29 is US Y's place, 52 US Z's; 16 that of US 7.
TEST_F(GlfwHostTest, GermanKeysGoByWhatTheyPrint) {
  ASSERT_EQ(runProcess({"setxkbmap", "de"}).status, 0);
  open();
  xdotool("mousemove 100 80 key 29");
  expect(KeyChanged{KeyboardKey::kZ, true, false, {}}, "z");
  expect(TextTyped{"z"});
  xdotool("key 52");
  expect(KeyChanged{KeyboardKey::kY, true, false, {}}, "y");
  xdotool("key 47");  // ö, beyond ASCII, on no letter's place
  expect(TextTyped{"ö"});
}

TEST_F(GlfwHostTest, FrenchDigitsAndRussianLettersGoByPlace) {
  ASSERT_EQ(runProcess({"setxkbmap", "fr"}).status, 0);
  open();
  xdotool("mousemove 100 80 key 16");
  expect(KeyChanged{KeyboardKey::k7, true, false, {}}, "7 without Shift");
  xdotool("key 24");
  expect(KeyChanged{KeyboardKey::kA, true, false, {}}, "a");
  host_.reset();
  events_.clear();
  ASSERT_EQ(runProcess({"setxkbmap", "ru"}).status, 0);
  open();
  xdotool("mousemove 110 80 key 52");
  expect(KeyChanged{KeyboardKey::kZ, true, false, {}}, "я");
  expect(TextTyped{"я"});
}

TEST_F(GlfwHostTest, ResizesDownToOnePixel) {
  open();
  const std::string id = std::to_string(windowId());
  xdotool("windowsize " + id + " 300 200");
  expect(Resized{{300, 200}, 1.0});
  EXPECT_EQ(host_->size(), (PixelSize{300, 200}));
  xdotool("windowsize " + id + " 1 1");
  expect(Resized{{1, 1}, 1.0});
  EXPECT_TRUE(test::drawTriangle(*host_));
}

TEST_F(GlfwHostTest, ContentScaleIsTheDesktops) {
  XPeer().setDotsPerInch(192);
  open({300, 200});
  EXPECT_EQ(host_->contentScale(), 2.0);
  EXPECT_EQ(host_->size(), (PixelSize{600, 400}));
  xdotool("mousemove 500 300");
  expect(PointerMoved{500, 300});
}

TEST_F(GlfwHostTest, CloseIsOnlyARequest) {
  open();
  XPeer().requestClose(windowId());
  expect(CloseRequested{});
  EXPECT_TRUE(test::drawTriangle(*host_));
  XPeer().requestClose(windowId());
  expect(CloseRequested{}, "a second time");
}

TEST_F(GlfwHostTest, DroppedFiles) {
  open();
  XPeer peer;
  std::vector<InputEvent> events;
  ASSERT_TRUE(peer.drop(windowId(), "file:///tmp/a%20b.vid\r\nfile:///tmp/%C3%B6.obj\r\n", [&] {
    for (InputEvent& event : host_->takeEvents()) events_.push_back(std::move(event));
  }));
  expect(FilesDropped{{"/tmp/a b.vid", "/tmp/ö.obj"}});
}

TEST_F(GlfwHostTest, FullScreenAndBack) {
  open();
  host_->setFullScreen(true);
  EXPECT_TRUE(host_->fullScreen());
  expect(Resized{{1280, 800}, 1.0});
  host_->setFullScreen(false);
  EXPECT_FALSE(host_->fullScreen());
  expect(Resized{{640, 480}, 1.0});
}

TEST_F(GlfwHostTest, TitleAndClipboard) {
  open();
  const std::string id = std::to_string(windowId());
  host_->setTitle("Pyramide ●");
  EXPECT_EQ(runProcess({"xdotool", "getwindowname", id}).output, "Pyramide ●\n");
  host_->setClipboard("Schlüssel « »");
  EXPECT_EQ(host_->clipboard(), "Schlüssel « »");
}

TEST_F(GlfwHostTest, Cursors) {
  open();
  for (const CursorShape shape :
       {CursorShape::kText, CursorShape::kCross, CursorShape::kHand, CursorShape::kHorizontal,
        CursorShape::kVertical, CursorShape::kHidden, CursorShape::kArrow, CursorShape::kText}) {
    host_->setCursor(shape);
    const char* reason = "";
    EXPECT_EQ(glfwGetError(&reason), GLFW_NO_ERROR) << reason;
  }
}

TEST_F(GlfwHostTest, WaitsEndByWake) {
  open();
  const auto start = steady_clock::now();
  host_->takeEvents();
  host_->wake();
  host_->takeEvents();  // must not lose it
  host_->waitForEvents(kPatience * 2);
  for (int i = 0; i < 20; ++i) {
    std::thread other([&] { host_->wake(); });
    host_->waitForEvents(kPatience * 2);
    other.join();
    host_->takeEvents();
  }
  EXPECT_LT(steady_clock::now() - start, kPatience);
  EXPECT_GT(host_->time(), 0.0);
}

// Nothing is drawn faster than the screen shows it, 60 times a second here, whatever the driver.
TEST_F(GlfwHostTest, SwapsAreLimited) {
  open();
  ASSERT_TRUE(host_->beginDrawing());
  host_->swap();
  const auto start = steady_clock::now();
  for (int i = 0; i < 12; ++i) host_->swap();
  EXPECT_GE(steady_clock::now() - start, std::chrono::milliseconds(12 * 12));
}

TEST_F(GlfwHostTest, TwoWindowsEndOnTheirOwn) {
  open({200, 100});
  auto second = openGlfwHost({.title = "second"}).value();
  EXPECT_TRUE(test::drawTriangle(*second));
  EXPECT_TRUE(test::drawTriangle(*host_));
  second.reset();
  EXPECT_TRUE(test::drawTriangle(*host_));
}

// Opening a window makes its context current, and so may other code: each draws into its own.
TEST_F(GlfwHostTest, DrawsIntoItsOwnContextWhateverIsCurrent) {
  open({200, 100});
  GLFWwindow* const first = glfwGetCurrentContext();
  EXPECT_TRUE(test::drawTriangle(*host_));
  const auto second = openGlfwHost({.title = "second"}).value();
  GLFWwindow* const other = glfwGetCurrentContext();
  ASSERT_NE(first, other);
  ASSERT_TRUE(host_->beginDrawing());
  EXPECT_EQ(glfwGetCurrentContext(), first);
  glfwMakeContextCurrent(other);
  host_->makeCurrent();
  EXPECT_EQ(glfwGetCurrentContext(), first);
  glfwMakeContextCurrent(nullptr);
  host_->swap();
  EXPECT_EQ(glfwGetCurrentContext(), first);
  second->makeCurrent();
  EXPECT_EQ(glfwGetCurrentContext(), other);
}

TEST_F(GlfwHostTest, TooOldOpenGlIsASentence) {
  const auto result =
      runProcess({VIDES_HOST_PROBE, "window", "64x48"}, {"MESA_GL_VERSION_OVERRIDE=2.1"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.errors, StartsWith("OpenGL 3.3 is needed; this is 2.1 ("));
}

TEST(GlfwHostWithoutScreen, IsASentence) {
  const auto unset = runProcess({VIDES_HOST_PROBE, "window", "64x48"}, {"DISPLAY"});
  EXPECT_EQ(unset.status, 1);
  EXPECT_THAT(unset.errors, StartsWith("no window can be opened: "));
  EXPECT_THAT(unset.errors, HasSubstr("DISPLAY"));
  const auto wrong = runProcess({VIDES_HOST_PROBE, "window", "64x48"}, {"DISPLAY=:47110"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.errors, StartsWith("no window can be opened: "));
}

}  // namespace
}  // namespace vides
