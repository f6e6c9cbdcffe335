// SPDX-License-Identifier: MIT
// What the window keeps from one run to the next: the setup, the recently opened files.
#include <gmock/gmock.h>

#include "app/window_fixture.hpp"
#include "edit/recent_files.hpp"
#include "edit/setup.hpp"

namespace vides {
namespace {

class KeptTest : public WindowTest {
 protected:
  std::string setupFile() const { return (folder_ / "config/vides/setup.json").string(); }
  std::string recentFile() const { return (folder_ / "state/vides/recent.json").string(); }
  void begin() override {}
};

TEST_F(KeptTest, TheSetupIsThereAgain) {
  startProgram({file("window").string()});
  EXPECT_FALSE(std::filesystem::exists(setupFile()));  // as built in
  clickBoth("menu/settings");
  clickBoth("menu/settings/german");
  // Without waiting for the end.
  ASSERT_TRUE(waitUntil([&] { return readSetupFile(setupFile()).has_value(); }));
  vides::Setup wanted;
  wanted.display.language = Language::kGerman;
  EXPECT_EQ(readSetupFile(setupFile()).value(), wanted);
  xdotool("key 1");  // the view from the front is kept at the end only
  closeProgram();
  wanted.turn = wanted.tilt = 0.0;
  EXPECT_EQ(readSetupFile(setupFile()).value(), wanted);
  EXPECT_EQ(readRecentFilesFile(recentFile()), std::vector{file("window").string()});

  // As another theme shows best.
  wanted.display.theme = ThemeKind::kLight;
  ASSERT_EQ(saveSetup(wanted, setupFile()), std::nullopt);
  startProgram({});
  twin_->editor().session().setSetup(wanted);
  ASSERT_TRUE(twin_->editor().session().beginWithSample(file("twin").string()));
  twin_->move(640, 790);
  xdotool("mousemove 640 790");
  ASSERT_TRUE(fallsAsleep());
  for (int i = 0; i < 60; ++i) twin_->frame();
  PictureTolerance tolerance;
  tolerance.share = kEglShare;
  EXPECT_TRUE(test::equalsPicture(peer_.screenshot(window_), twin_->picture().value(),
                                  "window_with_setup", tolerance));
  const auto written = std::filesystem::last_write_time(setupFile());
  closeProgram();
  EXPECT_EQ(std::filesystem::last_write_time(setupFile()), written);  // nothing was changed
}

TEST_F(KeptTest, ABrokenSetupIsReplacedAndKept) {
  std::filesystem::create_directories(folder_ / "config/vides");
  test::writeAll(setupFile(),
                 "{\"format\": \"vides-setup\", \"version\": 1, \"theme\": \"beige\"}");
  startProgram({file("window").string()});
  // The message stands where the flight's name was: the twin says so too.
  twin_->editor().session().say(
      MessageKind::kError,
      Text("output.setup-replaced", {setupFile(), readSetupFile(setupFile()).error().front()}));
  twin_->move(640, 790);
  xdotool("mousemove 640 790");
  ASSERT_TRUE(fallsAsleep());
  for (int i = 0; i < 60; ++i) twin_->frame();
  PictureTolerance tolerance;
  tolerance.share = kEglShare;
  EXPECT_TRUE(test::equalsPicture(peer_.screenshot(window_), twin_->picture().value(),
                                  "window_with_broken_setup", tolerance));
  clickBoth("menu/settings");
  clickBoth("menu/settings/german");
  closeProgram();
  EXPECT_EQ(readSetupFile(setupFile())->display.language, Language::kGerman);
  EXPECT_THAT(test::readAll(setupFile() + ".broken"), testing::HasSubstr("beige"));
}

}  // namespace
}  // namespace vides
