// SPDX-License-Identifier: MIT
// The whole editor without a screen: sizes and scales, texts in their boxes, what it looks like.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "app/drive/player.hpp"
#include "edit/camera_tools.hpp"
#include "host/open_host.hpp"
#include "io/vid_writer.hpp"
#include "panels/ui.hpp"
#include "support/files.hpp"
#include "support/offscreen.hpp"
#include "support/picture_check.hpp"
#include "support/process.hpp"

namespace vides {
namespace {

struct Stage {
  std::unique_ptr<OffscreenHost> host;
  std::unique_ptr<Player> player;
};

Stage stage(PixelSize size, double scale, OffscreenKind kind = OffscreenKind::kOsmesa) {
  OffscreenOptions options;
  options.size = size;
  options.contentScale = scale;
  Stage result;
  auto host = openOffscreen(kind, options);
  EXPECT_TRUE(host) << host.error();
  result.host = std::move(*host);
  auto player = Player::create(*result.host);
  EXPECT_TRUE(player) << player.error();
  result.player = std::move(*player);
  return result;
}

void openPyramid(Player& player) {
  const std::string file = std::string(VIDES_SOURCE_DIR) + "/assets/flights/pyramid.vid";
  ASSERT_TRUE(player.perform(Command("open", file)));
  ASSERT_TRUE(player.perform(Command("make-current", 2, 0)));
  for (int i = 0; i < 5; ++i) player.frame();
}

// Dear ImGui divides by zero where a rectangle is 2.000001 pixels wide and round.
TEST(Ui, ARoundingIsNoneOrAtLeastHalfAPixel) {
  for (float width = 0.0f; width < 3.5f; width = std::nextafter(width + 1e-5f, 4.0f)) {
    const float rounding = roundingOf({0.0f, 0.0f, width, 20.0f}, 2.0f);
    ASSERT_TRUE(rounding == 0.0f || rounding >= 0.5f) << width;
    ASSERT_EQ(roundingOf({0.0f, 0.0f, 20.0f, width}, 2.0f), rounding) << width;
  }
  EXPECT_EQ(roundingOf({0.0f, 0.0f, 20.0f, 20.0f}, 2.0f), 2.0f);
}

TEST(Editor, LooksAsItDid) {
  Stage one = stage({1280, 800}, 1.0);
  openPyramid(*one.player);
  EXPECT_TRUE(test::equalsBaseline(one.player->picture().value(), "window_1280x800"));
  Stage two = stage({1920, 1200}, 2.0);
  openPyramid(*two.player);
  EXPECT_TRUE(test::equalsBaseline(two.player->picture().value(), "window_1920x1200_scale_2"));
}

constexpr PictureTolerance kThroughEgl{.share = kEglShare};

struct WholeWindow {
  PixelSize size;
  double scale;
  const char* baseline;
};
constexpr WholeWindow kWindows[] = {{{1280, 800}, 1.0, "window_1280x800"},
                                    {{1920, 1200}, 2.0, "window_1920x1200_scale_2"}};

TEST(Editor, LooksTheSameThroughEgl) {
  if (!test::hasEgl()) GTEST_SKIP() << "no EGL here";
  for (const WholeWindow& window : kWindows) {
    Stage one = stage(window.size, window.scale, OffscreenKind::kEgl);
    openPyramid(*one.player);
    EXPECT_TRUE(test::equalsBaseline(one.player->picture().value(), window.baseline, kThroughEgl));
  }
}

TEST(Screenshot, OfTheWholeWindowIsTheSameThroughEgl) {
  if (!test::hasEgl()) GTEST_SKIP() << "no EGL here";
  const test::TemporaryFolder folder;
  const auto taken = [&](const char* offscreen, const char* size, const char* scale) {
    const std::string file = (folder / "window.png").string();
    const auto run = test::runProcess(
        {VIDES_PROGRAM, "screenshot", VIDES_SOURCE_DIR "/assets/flights/pyramid.vid",
         "--whole-window", "--offscreen", offscreen, "--size", size, "--scale", scale, "-o", file});
    EXPECT_EQ(run.status, 0) << run.errors;
    return readPng(file).value();
  };
  for (const auto& [size, scale] : {std::pair("1280x800", "1"), std::pair("1920x1200", "2")}) {
    EXPECT_TRUE(test::equalsPicture(taken("egl", size, scale), taken("osmesa", size, scale),
                                    std::string("screenshot_egl_") + size, kThroughEgl));
  }
}

Picture baselineOf(const WholeWindow& window) {
  return readPng(std::string(VIDES_SOURCE_DIR) + "/tests/baselines/" + window.baseline + ".png")
      .value();
}

// The picture with the view's camera moved by one pixel differs from the baseline.
void expectSeesOnePixel(const WholeWindow& window, OffscreenKind kind,
                        const PictureTolerance& tolerance) {
  Stage one = stage(window.size, window.scale, kind);
  openPyramid(*one.player);
  Editor& editor = one.player->editor();
  const Rect seen = editor.viewport();
  const PixelRectangle pixels{static_cast<double>(seen.x), static_cast<double>(seen.y),
                              static_cast<double>(seen.width), static_cast<double>(seen.height)};
  ViewState view = editor.session().view();
  view.view = panned(view.view, pixels, {1.0, 0.0});
  editor.session().setView(view);
  one.player->frame();
  const PictureDifference moved =
      comparePictures(one.player->picture().value(), baselineOf(window), tolerance);
  EXPECT_FALSE(moved.equal) << moved.sentence;
  EXPECT_TRUE(moved.sameSize);
}

TEST(Editor, TheBaselinesSeeTheCameraMovedByOnePixel) {
  for (const WholeWindow& window : kWindows) {
    expectSeesOnePixel(window, OffscreenKind::kOsmesa, {});
    // The share of pixels alone sees it, too.
    expectSeesOnePixel(window, OffscreenKind::kOsmesa, {.square = 256});
  }
}

TEST(Editor, TheBaselinesSeeTheCameraMovedByOnePixelThroughEgl) {
  if (!test::hasEgl()) GTEST_SKIP() << "no EGL here";
  for (const WholeWindow& window : kWindows) {
    expectSeesOnePixel(window, OffscreenKind::kEgl, kThroughEgl);
  }
}

// Of more than a separator.
bool isWord(const std::string& text) {
  return std::count_if(text.begin(), text.end(), [](char c) { return c != ' '; }) >= 3;
}

// Each word of the window, painted over with the colour beside it, is noticed; hardly one of them
// has so many pixels that their share of the window tells.
void expectNoticesEveryWord(const WholeWindow& window) {
  Stage one = stage(window.size, window.scale);
  openPyramid(*one.player);
  const Picture whole = one.player->picture().value();
  std::size_t words = 0, seenByShare = 0;
  for (const DrawnText& text : one.player->editor().widgets().texts()) {
    if (!isWord(text.text) || text.place.empty()) continue;
    Picture without = whole;
    const auto left = static_cast<int>(text.place.x), top = static_cast<int>(text.place.y);
    const int right = std::min(whole.width, static_cast<int>(std::ceil(text.place.right())));
    const int bottom = std::min(whole.height, static_cast<int>(std::ceil(text.place.bottom())));
    for (int y = top; y < bottom; ++y) {
      const auto ground = whole.pixel(std::max(left - 1, 0), y);
      for (int x = left; x < right; ++x) {
        std::copy(ground.begin(), ground.end(), without.pixel(x, y).begin());
      }
    }
    const PictureDifference difference = comparePictures(without, whole);
    EXPECT_FALSE(difference.equal) << '"' << text.text << "\": " << difference.sentence;
    ++words;
    if (difference.share > PictureTolerance().share) ++seenByShare;
  }
  EXPECT_GT(words, 40u);
  EXPECT_LT(seenByShare, words / 4);
}

TEST(Editor, EveryWordThatIsMissingIsNoticed) {
  for (const WholeWindow& window : kWindows) expectNoticesEveryWord(window);
}

// A flight of more frames than a display frame has time for is measured where that is seen, and all
// at once where nobody waits for the next display frame.
TEST(Editor, LongFlightsAreMeasuredWhereItIsShown) {
  const auto begin = [](Stage& one, bool shown) {
    Layout layout;
    layout.rightShown = layout.timelineShown = shown;
    one.player->editor().setLayout(layout);
    ASSERT_TRUE(one.player->perform(Command("set-duration", 2000.0)));
    for (int i = 0; i < 8; ++i) one.player->frame();
  };
  const auto speed = [](const Stage& one) {
    const Widget* const widget = one.player->editor().widgets().find("measures/speed");
    return widget == nullptr ? "nothing" : widget->value;
  };
  Stage one = stage({960, 600}, 1.0);
  begin(one, false);
  EXPECT_FALSE(one.player->wantsFrame());
  begin(one, true);
  EXPECT_TRUE(one.player->unfinished());
  EXPECT_EQ(speed(one), "\u2026");
  int frames = 0;
  while (one.player->unfinished() && frames < 100) {
    one.player->frame();
    ++frames;
  }
  EXPECT_GT(frames, 3);
  EXPECT_LT(frames, 100);
  EXPECT_NE(speed(one), "\u2026");

  Stage two = stage({960, 600}, 1.0);
  begin(two, true);
  std::int64_t last = 0;
  two.player->editor().finishMeasures([&](std::int64_t done, std::int64_t all) {
    EXPECT_GT(done, last);
    EXPECT_LE(done, all);
    last = done;
  });
  EXPECT_GT(last, 40000);
  two.player->frame();
  EXPECT_FALSE(two.player->unfinished());
  EXPECT_EQ(speed(two), speed(one));
}

// Whoever draws a speed curve sees what it does to the ghost cameras along the flight's curve.
TEST(Editor, TheSpeedWindowLeavesTheCurveToBeSeen) {
  for (const PixelSize size :
       {PixelSize{960, 600}, PixelSize{1280, 800}, PixelSize{1920, 1200}, PixelSize{2560, 1440}}) {
    Stage one = stage(size, 1.0);
    openPyramid(*one.player);
    ASSERT_TRUE(one.player->perform(*parseCommand("language de")));
    ASSERT_TRUE(one.player->perform(*parseCommand("show-window speed")));
    one.player->frame();
    Editor& editor = one.player->editor();
    const Rect seen = editor.viewport();
    const ViewProjection view =
        viewProjection(editor.session().view().view,
                       {static_cast<double>(seen.x), static_cast<double>(seen.y),
                        static_cast<double>(seen.width), static_cast<double>(seen.height)});
    const auto top = static_cast<double>(editor.widgets().find("speed/heading")->rect.y);
    const Evaluation& evaluation = editor.session().evaluation();
    for (std::size_t piece = 0; piece < evaluation.pieceCount(); ++piece) {
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        EXPECT_LT(view.project(evaluation.piecePoint(piece, share))->y, top - 8.0)
            << size.width << " x " << size.height << ", piece " << piece;
      }
    }
    for (const DrawnText& text : editor.widgets().texts()) {
      EXPECT_LE(text.width, text.box + 0.5f) << text.text << ", " << size.width;
    }
  }
}

TEST(Editor, AFreeViewInTheViewportsPlaceLooksAsItDid) {
  Stage one = stage({960, 600}, 1.0);
  one.player->frame();
  for (const char* line : {"swap-views", "fly-turn 10 -5", "show-element thirds on"}) {
    ASSERT_TRUE(one.player->perform(*parseCommand(line))) << line;
  }
  one.player->frame();
  EXPECT_TRUE(test::equalsBaseline(one.player->picture().value(), "window_free_view_960x600"));
}

// The handle under the pointer is the one of this picture: it comes into the viewport in one step,
// the picture changes under it while it rests, and it leaves.
TEST(Editor, TheHandleUnderThePointerIsShown) {
  Stage one = stage({1280, 800}, 1.0);
  openPyramid(*one.player);
  Editor& editor = one.player->editor();
  const auto picture = [&] { return one.player->picture().value(); };
  const auto drawnAnew = [&](const char* view) {
    EXPECT_TRUE(one.player->perform(Command("view", view)));
    one.player->frame();
    return picture();
  };
  const Rect seen = editor.viewport();
  const Picture iso = drawnAnew("iso"), front = drawnAnew("front");
  const PixelRectangle pixels{static_cast<double>(seen.x), static_cast<double>(seen.y),
                              static_cast<double>(seen.width), static_cast<double>(seen.height)};
  const Vec2 key = *viewProjection(editor.session().view().view, pixels)
                        .project(editor.session().flight().keys[3].position);
  one.player->move(key.x, key.y);
  one.player->frame();
  EXPECT_NE(picture(), front);
  EXPECT_EQ(drawnAnew("iso"), iso);  // there is nothing under it in this view
  EXPECT_NE(drawnAnew("front"), front);
  one.player->move(4.0, 230.0);  // between two panels
  EXPECT_EQ(picture(), front);
}

// A folded column takes the small picture away: nothing is there to be hit, or drawn.
TEST(Editor, WithoutItsColumnTheSmallPictureIsNowhere) {
  Stage one = stage({960, 600}, 1.0);
  Editor& editor = one.player->editor();
  ASSERT_TRUE(one.player->perform(Command("swap-views")));
  EXPECT_FALSE(editor.viewport().empty());
  Layout layout = editor.layout();
  layout.rightShown = false;
  editor.setLayout(layout);
  one.player->frame();
  EXPECT_TRUE(editor.viewport().empty());
  EXPECT_EQ(editor.widgets().find("view/picture"), nullptr);
  EXPECT_NE(editor.widgets().find("camera/picture"), nullptr);
  ASSERT_TRUE(one.player->perform(Command("swap-views")));
  EXPECT_FALSE(editor.viewport().empty());
}

TEST(Editor, SplittersResizeAndFold) {
  Stage one = stage({1280, 800}, 1.0);
  Player& player = *one.player;
  player.frame();
  const auto drag = [&](const std::string& splitter, double dx, double dy) {
    const Widget* const widget = player.editor().widgets().find(splitter);
    ASSERT_NE(widget, nullptr) << splitter;
    const double x = static_cast<double>(widget->rect.centreX()) - 2.0;
    const double y = static_cast<double>(widget->rect.centreY()) - 2.0;
    player.move(x, y);
    player.button(PointerButton::kLeft, true);
    player.move(x + dx, y + dy);
    player.button(PointerButton::kLeft, false);
    player.frame();
  };
  const Rect before = player.editor().viewport();
  drag("view/left_splitter", 40.0, 0.0);
  drag("view/right_splitter", -30.0, 0.0);
  drag("view/timeline_splitter", 0.0, -20.0);
  const Rect after = player.editor().viewport();
  EXPECT_EQ(after.x, before.x + 40.0f);
  EXPECT_EQ(after.right(), before.right() - 30.0f);
  EXPECT_EQ(after.bottom(), before.bottom() - 20.0f);
}

// What is kept of the view at the end is where it was going.
TEST(Editor, QuittingEndsAGlide) {
  const Stage one = stage({1280, 800}, 1.0);
  one.host->makeCurrent();
  const auto editor = Editor::create(one.host->gl(), {});
  ASSERT_TRUE(editor) << editor.error();
  const auto turn = [&] { return (*editor)->session().view().view.turn; };
  ASSERT_TRUE((*editor)->run(Command("view", "front")));
  EXPECT_NE(turn(), 0.0);  // on its way
  ASSERT_TRUE((*editor)->run(Command("quit")));
  FrameInput input;
  input.size = {1280, 800};
  input.time = 0.01;
  ASSERT_TRUE(one.host->beginDrawing());
  EXPECT_TRUE((*editor)->frame(input).quit);
  EXPECT_EQ(turn(), 0.0);
}

TEST(Editor, WalkingAsksForDisplayFrames) {
  Stage one = stage({1280, 800}, 1.0);
  Player& player = *one.player;
  player.frame();
  const Rect at = player.editor().widgets().find("camera/picture")->rect;
  player.move(static_cast<double>(at.centreX()), static_cast<double>(at.centreY()));
  player.button(PointerButton::kRight, true);
  player.key(KeyboardKey::kW, true);
  const Vec3 before = player.editor().session().camera().viewReferencePoint;
  for (int i = 0; i < 20; ++i) player.frame();
  EXPECT_TRUE(player.unfinished());
  const Vec3 after = player.editor().session().camera().viewReferencePoint;
  EXPECT_NEAR(glm::length(after - before), 20 / 60.0 * CameraTools::kWalkPerSecond, 1e-9);
  player.key(KeyboardKey::kW, false);
  player.button(PointerButton::kRight, false);
  for (int i = 0; i < 60 && player.wantsFrame(); ++i) player.frame();
  EXPECT_FALSE(player.wantsFrame());
}

// Frames are written beside the window, which goes on: 50 million would take it a minute.
TEST(Editor, GoesOnWhileFramesAreWritten) {
  const test::TemporaryFolder folder;
  Stage one = stage({1280, 800}, 1.0);
  one.player.reset();
  one.player = std::move(*Player::create(*one.host, false));
  Player& player = *one.player;
  Session& session = player.editor().session();
  for (const std::string& line :
       {std::string("set-duration 50000"), std::string("set-frame-rate 1000"),
        "frames-file \"" + (folder / "frames.csv").string() + "\"",
        std::string("show-window frames"), std::string("write-frames")}) {
    ASSERT_TRUE(player.perform(*parseCommand(line))) << line;
  }
  player.frame();
  ASSERT_NE(session.frameJob(), nullptr);
  EXPECT_NE(player.editor().widgets().find("frames/progress"), nullptr);
  EXPECT_FALSE(player.editor().widgets().find("frames/write")->enabled);
  EXPECT_TRUE(player.unfinished());  // how far it is goes on being shown
  ASSERT_TRUE(player.perform(Command("set-zoom", 40.0)));
  EXPECT_EQ(session.currentOrientation().zoom, 40.0);
  ASSERT_TRUE(player.clickWidget("frames/cancel"));
  session.finishFrames();
  player.frame();
  EXPECT_EQ(session.frameJob(), nullptr);
  EXPECT_EQ(player.editor().widgets().find("frames/progress"), nullptr);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// A large scene is read beside the window, too, which shows how far it is.
TEST(Editor, GoesOnWhileASceneIsRead) {
  const test::TemporaryFolder folder;
  // Takes many times as long to read as a click does, but not to draw.
  std::string scene = "v 0 0 0\nv 976 330 0.125\np 1 2\n";
  for (int i = 0; i < 12000000; ++i) scene += "vn 0 0 1\n";
  test::writeAll(folder / "large.obj", scene);
  Stage one = stage({960, 600}, 1.0);
  one.player.reset();
  one.player = std::move(*Player::create(*one.host, false));
  Player& player = *one.player;
  Session& session = player.editor().session();
  const auto wait = [&] {
    while (session.reading()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    player.frame();
  };
  const Command import("import-scene", (folder / "large.obj").string());
  player.frame();
  ASSERT_TRUE(player.perform(import));
  player.frame();
  ASSERT_TRUE(session.reading());
  EXPECT_TRUE(player.unfinished());  // how far it is goes on being shown
  EXPECT_NE(player.editor().widgets().find("view/reading"), nullptr);
  ASSERT_TRUE(player.clickWidget("view/stop_reading"));
  wait();
  EXPECT_EQ(session.output().text.key, "output.import-cancelled");
  EXPECT_TRUE(session.flight().scene.empty());
  EXPECT_EQ(player.editor().widgets().find("view/stop_reading"), nullptr);

  ASSERT_TRUE(player.perform(import));
  ASSERT_TRUE(player.perform(Command("set-zoom", 40.0)));  // meanwhile
  EXPECT_EQ(session.currentOrientation().zoom, 40.0);
  wait();
  EXPECT_EQ(session.history().steps(), 2u);
  EXPECT_EQ(session.scenes().size(), 1u);
}

// In bytes, of this process.
std::size_t residentMemory() {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0;
  file >> pages >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// A software driver puts drawing aside until it is made to draw.
TEST(Editor, DisplayFramesLeaveNothingBehind) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer keeps what is freed";
#endif
  Stage one = stage({1280, 800}, 1.0);
  const auto draw = [&](int frames) {
    for (int i = 0; i < frames; ++i) {
      ASSERT_TRUE(one.player->perform(Command("set-zoom", 1.0 + i % 90)));
      one.player->frame();
    }
  };
  draw(10);
  const std::size_t before = residentMemory();
  draw(40);
  EXPECT_LT(residentMemory(), before + (std::size_t{48} << 20));  // the pictures alone: 160 MB
}

// So many keys on a spiral in the cube.
Flight spiral(int count) {
  Flight flight = newFlight();
  std::vector<KeyPointer> keys;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    Key key = flight.keys[0];
    key.position = {0.8 * std::cos(40.0 * share), 1.6 * share - 0.8, 0.8 * std::sin(40.0 * share)};
    keys.emplace_back(std::move(key));
  }
  flight.keys = KeyList(std::move(keys));
  return flight;
}

// "31.12 s", "1:04.52", "2:21:17.80"
double secondsOf(const std::string& words) {
  double seconds = 0.0;
  std::istringstream parts(words);
  for (std::string part; std::getline(parts, part, ':');)
    seconds = 60.0 * seconds + std::stod(part);
  return seconds;
}

// What a drag has changed is shown in the display frame of the pointer's event: curve, length,
// frames.
TEST(Editor, EverythingFollowsADragInTheSameDisplayFrame) {
  for (const int count : {2, 10000}) {
    SCOPED_TRACE(count);
    const test::TemporaryFolder folder;
    const std::string file = (folder / "spiral.vid").string();
    ASSERT_EQ(saveVid(spiral(count), file), std::nullopt);
    Stage one = stage({1280, 800}, 1.0);
    Player& player = *one.player;
    ASSERT_TRUE(player.perform(Command("open", file)));
    const std::size_t key = count == 2 ? 1 : 5000;
    ASSERT_TRUE(player.perform(Command("make-current", static_cast<int>(key), 0)));
    for (int i = 0; i < 5; ++i) player.frame();
    const Session& session = player.editor().session();
    const auto measure = [&](const char* id) { return player.editor().widgets().find(id)->value; };
    const Rect rect = player.editor().viewport();
    const auto seen = [&] {
      const Picture all = one.host->picture().value();
      std::vector<std::uint8_t> bytes;
      for (int y = static_cast<int>(rect.y); y < static_cast<int>(rect.bottom()); ++y) {
        for (int x = static_cast<int>(rect.x); x < static_cast<int>(rect.right()); ++x) {
          const auto pixel = all.pixel(x, y);
          bytes.insert(bytes.end(), pixel.begin(), pixel.end());
        }
      }
      return bytes;
    };
    const PixelRectangle pixels{static_cast<double>(rect.x), static_cast<double>(rect.y),
                                static_cast<double>(rect.width), static_cast<double>(rect.height)};
    const Vec2 place = viewProjection(session.view().view, pixels)
                           .project(session.flight().keys[key].position)
                           .value();
    player.move(place.x, place.y);
    player.button(PointerButton::kLeft, true);
    player.move(place.x + 12.0, place.y);
    auto before = seen();
    for (const double by : {40.0, -60.0, 90.0}) {
      const Vec3 from = session.flight().keys[key].position;
      player.move(place.x + by, place.y - 20.0);
      ASSERT_NE(session.flight().keys[key].position, from);
      const Evaluation fresh(session.flight());
      const double frames = static_cast<double>(fresh.frameCount());
      EXPECT_NEAR(std::stod(measure("measures/length")), fresh.length(),
                  count == 2 ? 5.1e-4 : 0.051)
          << by;
      EXPECT_NEAR(secondsOf(measure("measures/duration")), frames / session.flight().frameRate,
                  0.0101)
          << by;
      const auto now = seen();
      EXPECT_NE(now, before) << by;
      // Nothing comes later.
      player.frame();
      player.frame();
      EXPECT_EQ(seen(), now) << by;
      before = now;
    }
  }
}

TEST(Editor, SamePixelsTwice) {
  Stage a = stage({960, 600}, 1.0);
  Stage b = stage({960, 600}, 1.0);
  openPyramid(*a.player);
  openPyramid(*b.player);
  EXPECT_EQ(a.player->picture().value(), b.player->picture().value());
}

// Nobody sees a window that fills only with its second picture, or that blinks when it changes.
TEST(Editor, EachPictureIsWhole) {
  Stage one = stage({1280, 800}, 1.0);
  const std::string file = std::string(VIDES_SOURCE_DIR) + "/assets/flights/pyramid.vid";
  ASSERT_TRUE(one.player->editor().run(Command("open", file)));
  const auto settled = [&] {
    for (int i = 0; i < 5; ++i) one.player->frame();
    return one.player->picture().value();
  };
  one.player->frame();
  const Picture first = one.player->picture().value();
  EXPECT_EQ(first, settled());
  ASSERT_TRUE(one.host->resize({1280, 800}, 1.5));  // other columns, other pictures in them
  one.player->frame();
  const Picture changed = one.player->picture().value();
  EXPECT_NE(changed, first);
  EXPECT_EQ(changed, settled());
}

TEST(Editor, BearsEverySizeAndScale) {
  Stage one = stage({1280, 800}, 1.0);
  openPyramid(*one.player);
  for (const PixelSize size : {PixelSize{1, 1}, PixelSize{0, 0}, PixelSize{16000, 100},
                               PixelSize{100, 2000}, PixelSize{960, 600}}) {
    for (const double scale : {0.75, 1.0, 1.5, 3.0}) {
      ASSERT_TRUE(one.host->resize(size, scale)) << size.width << " x " << size.height;
      one.player->move(size.width / 2.0, size.height / 2.0);
      one.player->frame();
      const auto picture = one.player->picture();
      ASSERT_TRUE(picture) << picture.error();
      EXPECT_EQ(picture->width, size.width);
    }
  }
}

TEST(Editor, TextsFitTheirBoxes) {
  for (const char* language : {"en", "de"}) {
    for (const PixelSize size : {PixelSize{960, 600}, PixelSize{1280, 800}}) {
      for (const int scale : {1, 2}) {
        Stage one = stage({size.width * scale, size.height * scale}, scale);
        one.player->perform(Command("language", language));
        openPyramid(*one.player);
        ASSERT_GT(one.player->editor().widgets().texts().size(), 50u);
        for (const DrawnText& text : one.player->editor().widgets().texts()) {
          EXPECT_LE(text.width, text.box + 0.5f)
              << '"' << text.text << "\" in " << language << " at " << size.width << " x "
              << size.height << ", scale " << scale;
        }
      }
    }
  }
}

TEST(Editor, WantsNoFrameWhenNothingHappens) {
  Stage one = stage({1280, 800}, 1.0);
  openPyramid(*one.player);
  one.player->move(5, 700);
  for (int i = 0; i < 60; ++i) one.player->frame();
  EXPECT_FALSE(one.player->wantsFrame());
  one.player->perform(Command("play"));
  EXPECT_TRUE(one.player->wantsFrame());
}

}  // namespace
}  // namespace vides
