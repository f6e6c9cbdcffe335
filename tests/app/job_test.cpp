// SPDX-License-Identifier: MIT
// A stranger's first job, by pointer and keys in a real window: six keys with a stop and a pan,
// shapes, speeds, typed numbers, the frames written, the file opened again, and a crash survived.
#include <gmock/gmock.h>
#include <signal.h>

#include <set>

#include "app/window_fixture.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

class JobTest : public WindowTest {
 protected:
  static constexpr const char* kName = "my flight.vid";

  // As a stranger starts it: no file, no setup, nothing kept.
  void begin() override {
    ASSERT_TRUE(twin_->editor().session().beginWithSample(file("twin").string()));
    startProgram({});
    keyBoth(KeyboardKey::kN, {.control = true}, "ctrl+n");
    ASSERT_EQ(flight().keys.size(), 2u);
  }

  Session& session() const { return twin_->editor().session(); }
  const Flight& flight() const { return session().flight(); }
  std::filesystem::path fileOf(const std::string& who, const std::string& name) const {
    return folder_ / who / name;
  }
  std::string titleOfWindow() const { return xdotool("getwindowname " + std::to_string(window_)); }

  // Typed into a field that is clicked: in the window as text, in the twin as a script would.
  void typeBoth(const std::string& id, const std::string& windows, const std::string& twins) {
    for (int i = 0; i < 3; ++i) twin_->frame();
    const auto widget = twin_->bringIntoSight(id);
    ASSERT_TRUE(widget) << widget.error();
    const std::string at = std::to_string(std::lround(widget->rect.centreX())) + " " +
                           std::to_string(std::lround(widget->rect.centreY()));
    xdotool("mousemove " + at + " click 1");
    ASSERT_TRUE(fallsAsleep());
    xdotool("key ctrl+a");
    const auto typed = test::runProcess({"xdotool", "type", "--delay", "20", windows});
    ASSERT_EQ(typed.status, 0) << typed.errors;
    xdotool("key Return");
    const auto set = twin_->setWidget(id, twins);
    ASSERT_TRUE(set) << set.error();
    twin_->move(std::round(widget->rect.centreX()), std::round(widget->rect.centreY()));
    ASSERT_TRUE(fallsAsleep());
  }
  void typeBoth(const std::string& id, const std::string& text) { typeBoth(id, text, text); }

  // A click on the cross of a key makes it current.
  void chooseKey(std::size_t key) {
    const Vec2 place = placeOf(key);
    const long x = std::lround(place.x), y = std::lround(place.y);
    xdotool("mousemove " + std::to_string(x) + " " + std::to_string(y) + " mousedown 1 mouseup 1");
    twin_->click(static_cast<double>(x), static_cast<double>(y));
    ASSERT_TRUE(fallsAsleep());
    ASSERT_EQ(session().current().key, key);
  }

  // Six keys around the middle, each put there by the pointer.
  void layOut() {
    keyBoth(KeyboardKey::kI, {.shift = true}, "shift+i");
    keyBoth(KeyboardKey::k4, {}, "4");
    ASSERT_EQ(flight().keys.size(), 6u);
    const int right[] = {-60, -40, 10, 30, 50, 70};
    const int down[] = {40, -70, -90, 60, -60, 50};
    const PointerButton buttons[] = {PointerButton::kRight,  PointerButton::kRight,
                                     PointerButton::kLeft,   PointerButton::kRight,
                                     PointerButton::kMiddle, PointerButton::kRight};
    for (std::size_t key = 0; key < 6; ++key) {
      const Vec3 before = position(key);
      drag(buttons[key], placeOf(key), right[key], down[key]);
      EXPECT_NE(position(key), before) << "key " << key;
    }
    ASSERT_TRUE(fallsAsleep());
  }

  // The third key: the camera stops there for a second and a half and pans before it goes on.
  void stopAndPan() {
    chooseKey(2);
    keyBoth(KeyboardKey::kO, {}, "o");
    ASSERT_EQ(flight().keys[2].orientations.size(), 2u);
    typeBoth("orientation/aim_x", "0.5+0.3");
    typeBoth("orientation/aim_y", "-0.2");
    typeBoth("orientation/roll", "10");
    keyBoth(KeyboardKey::kPageUp, {.control = true}, "ctrl+Prior");
    typeBoth("speed/hold", "1.5");
    const Orientation& first = flight().keys[2].orientations[0];
    EXPECT_EQ(first.hold, 1.5);
    EXPECT_EQ(flight().keys[2].orientations[1].aim.x, 0.8);
    EXPECT_EQ(flight().keys[2].orientations[1].roll, 10.0);
    const Evaluation& evaluation = session().evaluation();
    std::set<SectionKind> kinds;
    for (std::int64_t i = 0; i < evaluation.sectionCount(); ++i) {
      kinds.insert(evaluation.section(i).kind);
    }
    EXPECT_TRUE(kinds.contains(SectionKind::kHold));
    EXPECT_TRUE(kinds.contains(SectionKind::kPan));
  }

  void shapes() {
    chooseKey(1);
    clickBoth("position/change");
    clickBoth("shape/preset_3");
    clickBoth("shape/ok");
    EXPECT_EQ(flight().keys[1].shape.preset, 3);
    chooseKey(3);
    typeBoth("position/tension", "0.4");
    EXPECT_EQ(shapeOf(flight(), flight().keys[3]).tension, 0.4);
  }

  void speeds() {
    chooseKey(4);
    clickBoth("speed/curve");
    clickBoth("speed/ease_in_out_sine");
    keyBoth(KeyboardKey::kEscape, {}, "Escape");
    EXPECT_LT(flight().keys[4].orientations[0].speed[0], 50.0);
    chooseKey(0);
    typeBoth("speed/duration", "2.5");
    EXPECT_EQ(flight().keys[0].orientations[0].duration, 2.5);
    typeBoth("zoom/value", "30");
    typeBoth("position/x", "-0.75");
    EXPECT_EQ(position(0).x, -0.75);
    EXPECT_EQ(flight().keys[0].orientations[0].zoom, 30.0);
  }

  void saveUnderName() {
    keyBoth(KeyboardKey::kS, {.shift = true, .control = true}, "ctrl+shift+s");
    typeBoth("chooser/name", fileOf("window", kName).string(), fileOf("twin", kName).string());
    ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(fileOf("window", kName)); }));
    ASSERT_TRUE(std::filesystem::exists(fileOf("twin", kName)));
    EXPECT_EQ(test::readAll(fileOf("window", kName)), test::readAll(fileOf("twin", kName)));
    EXPECT_THAT(titleOfWindow(), testing::HasSubstr(kName));
  }

  void writeFrames() {
    clickBoth("menu/output");
    clickBoth("menu/output/frames");
    clickBoth("frames/format");
    clickBoth("frames/format_csv");
    clickBoth("frames/write");
    const auto written = fileOf("window", "my flight.csv");
    ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(written); }));
    const auto program = test::runProcess(
        {VIDES_PROGRAM, "frames", fileOf("window", kName).string(), "--format", "csv"});
    ASSERT_EQ(program.status, 0) << program.errors;
    EXPECT_EQ(test::readAll(written), program.output);
  }

  std::vector<std::filesystem::path> kept() const {
    std::vector<std::filesystem::path> files;
    std::error_code none;
    for (const auto& entry :
         std::filesystem::directory_iterator(folder_ / "state/vides/recovery", none)) {
      if (entry.path().extension() == ".vid") files.push_back(entry.path());
    }
    return files;
  }

  // Killed in the middle of an edit, the next start gives it back.
  void survive() {
    chooseKey(5);
    typeBoth("position/y", "*2");
    ASSERT_TRUE(waitUntil([&] {
      return kept().size() == 1 && readVidFile(kept().front().string())->keys == flight().keys;
    }));
    ASSERT_EQ(::kill(program_->id(), SIGKILL), 0);
    ASSERT_TRUE(waitUntil([&] { return program_->ended().has_value(); }));
    program_.reset();
    const Flight work = flight();
    startProgram({});
    session().offerRecovery(work, fileOf("window", kName).string(), "2026-11-29 10:15");
    clickBoth("question/recover");
    xdotool("key ctrl+s");
    EXPECT_TRUE(
        waitUntil([&] { return test::readAll(fileOf("window", kName)) == writeVid(work); }));
    EXPECT_TRUE(waitUntil([&] { return kept().empty(); }));
  }
};

TEST_F(JobTest, AStrangersFirstFlight) {
  ASSERT_NO_FATAL_FAILURE(layOut());
  ASSERT_NO_FATAL_FAILURE(stopAndPan());
  ASSERT_NO_FATAL_FAILURE(shapes());
  ASSERT_NO_FATAL_FAILURE(speeds());
  ASSERT_NO_FATAL_FAILURE(saveUnderName());
  expectOnScreen("job_saved");
  ASSERT_NO_FATAL_FAILURE(writeFrames());
  closeProgram();

  startProgram({fileOf("window", kName).string()});
  ASSERT_TRUE(twin_->perform(Command("open", fileOf("twin", kName).string())));
  expectOnScreen("job_opened_again");
  ASSERT_NO_FATAL_FAILURE(survive());
  closeProgram();
}

}  // namespace
}  // namespace vides
