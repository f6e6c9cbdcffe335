// SPDX-License-Identifier: MIT
// A stranger's first job in the window, by pointer and keys: a flight of six keys with a stop and a
// pan, shapes, speeds, typed numbers; saved, exported, opened again, and recovered after a kill.
#include <gmock/gmock.h>
#include <signal.h>

#include "app/window_fixture.hpp"
#include "io/vid_reader.hpp"

namespace vides {
namespace {

class JobTest : public WindowTest {
 protected:
  // New, in both.
  void begin() override {
    startProgram({file("window").string()});
    keyBoth(KeyboardKey::kN, {.control = true}, "ctrl+n");
  }

  void typeBoth(const std::string& text) {
    twin_->type(text);
    xdotool("type --delay 30 -- " + text);
    ASSERT_TRUE(fallsAsleep());
  }
  void enterBoth() { keyBoth(KeyboardKey::kEnter, {}, "Return"); }
  void tabBoth() { keyBoth(KeyboardKey::kTab, {}, "Tab"); }
  // A field is opened by a click; its number is selected as a whole.
  void replaceBoth(const std::string& id, const std::string& text) {
    clickBoth(id);
    keyBoth(KeyboardKey::kA, {.control = true}, "ctrl+a");
    typeBoth(text);
  }

  // A name that is typed into the chooser: each has a file of its own.
  void nameEach(const std::string& name) {
    keyBoth(KeyboardKey::kA, {.control = true}, "ctrl+a");
    twin_->type((folder_ / "twin" / name).string());
    xdotool("type --delay 10 -- " + (folder_ / "window" / name).string());
    ASSERT_TRUE(fallsAsleep());
    enterBoth();
  }
  std::string fileOf(const std::string& whose, const std::string& name) const {
    const auto path = folder_ / whose / name;
    return std::filesystem::exists(path) ? test::readAll(path) : std::string();
  }
  void expectAlike(const std::string& name) {
    const std::string wanted = fileOf("twin", name);
    EXPECT_FALSE(wanted.empty()) << name;
    EXPECT_TRUE(waitUntil([&] { return fileOf("window", name) == wanted; }))
        << name << ":\n"
        << fileOf("window", name) << "\nand should be\n"
        << wanted;
  }
  const Flight& flight() const { return twin_->editor().session().flight(); }
};

TEST_F(JobTest, AFlightFromNothingToItsFrames) {
  // Six keys: "insert how many", then four.
  keyBoth(KeyboardKey::kI, {.shift = true}, "shift+i");
  clickBoth("position/insert_4");
  ASSERT_EQ(flight().keys.size(), 6u);
  // One is dragged, another one typed: from field to field with Tab, the last one a sum.
  keyBoth(KeyboardKey::kHome, {}, "Home");
  drag(PointerButton::kRight, placeOf(2), 24, -31);
  ASSERT_TRUE(fallsAsleep());
  EXPECT_NE(position(2).y, 0.2);
  keyBoth(KeyboardKey::kPageDown, {}, "Next");
  replaceBoth("position/x", "0.25");
  tabBoth();
  typeBoth("-0.4");
  tabBoth();
  typeBoth("0.1+0.2");
  enterBoth();
  EXPECT_EQ(position(3), Vec3(0.25, -0.4, 0.1 + 0.2));
  // The stop, and a second orientation that looks elsewhere: the pan.
  replaceBoth("speed/hold", "0.8");
  enterBoth();
  keyBoth(KeyboardKey::kO, {}, "o");
  replaceBoth("orientation/aim_x", "0.5");
  tabBoth();
  typeBoth("0.25");
  enterBoth();
  ASSERT_EQ(flight().keys[3].orientations.size(), 2u);
  EXPECT_EQ(flight().keys[3].orientations[0].hold, 0.8);
  EXPECT_EQ(flight().keys[3].orientations[1].aim, Vec3(0.5, 0.25, 0.0));
  // A shape for the current key, a value of its own for all of them at once.
  clickBoth("position/change");
  clickBoth("shape/preset_2");
  clickBoth("shape/ok");
  EXPECT_EQ(flight().keys[3].shape.preset, 2);
  keyBoth(KeyboardKey::kA, {.control = true}, "ctrl+a");
  replaceBoth("orientation/roll", "5");
  enterBoth();
  EXPECT_EQ(flight().keys[5].orientations[0].roll, 5.0);
  EXPECT_EQ(flight().keys[3].orientations[1].roll, 5.0);
  // Speeds: an ease, and one value of the curve; Escape closes the window and nothing else.
  clickBoth("speed/edit");
  clickBoth("speed/ease_in_out_sine");
  replaceBoth("speed/v4", "*0.9");
  enterBoth();
  keyBoth(KeyboardKey::kEscape, {}, "Escape");
  EXPECT_TRUE(twin_->editor().session().windows().empty());
  // The menus by keys: what was done last is undone, and redone.
  keyBoth(KeyboardKey::kF10, {}, "F10");
  keyBoth(KeyboardKey::kRight, {}, "Right");
  enterBoth();
  keyBoth(KeyboardKey::kY, {.control = true}, "ctrl+y");

  // Saved under a name, also while a number is being typed.
  replaceBoth("zoom/focal_length", "35");
  keyBoth(KeyboardKey::kS, {.control = true}, "ctrl+s");
  nameEach("job.vid");
  expectAlike("job.vid");
  // Exported, through the window.
  clickBoth("menu/output");
  clickBoth("menu/output/frames");
  clickBoth("frames/format_csv");
  clickBoth("frames/choose");
  nameEach("job.csv");
  clickBoth("frames/write");
  keyBoth(KeyboardKey::kEscape, {}, "Escape");
  expectAlike("job.csv");

  // Something else, then opened again.
  keyBoth(KeyboardKey::kN, {.control = true}, "ctrl+n");
  keyBoth(KeyboardKey::kO, {.control = true}, "ctrl+o");
  nameEach("job.vid");
  ASSERT_EQ(flight().keys.size(), 6u);
  expectOnScreen("window_job");

  // Killed with something unsaved, the next start has it.
  replaceBoth("zoom/focal_length", "50");
  enterBoth();
  ASSERT_TRUE(waitUntil([&] {
    std::error_code none;
    for (const auto& entry :
         std::filesystem::directory_iterator(folder_ / "state/vides/recovery", none)) {
      if (entry.path().extension() == ".vid" && entry.file_size(none) > 0) return true;
    }
    return false;
  }));
  ASSERT_EQ(::kill(program_->id(), SIGKILL), 0);
  ASSERT_TRUE(waitUntil([&] { return program_->ended().has_value(); }));
  program_.reset();
  startProgram({});
  xdotool("key Return");  // Recover
  ASSERT_TRUE(fallsAsleep());
  keyBoth(KeyboardKey::kS, {.control = true}, "ctrl+s");
  expectAlike("job.vid");
  closeProgram();
}

}  // namespace
}  // namespace vides
