// SPDX-License-Identifier: MIT
// How the window's parts share usual screens: nothing must be scrolled, what grows grows.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <utility>

#include "app/drive/player.hpp"
#include "edit/texts.hpp"
#include "host/open_host.hpp"

namespace vides {
namespace {

struct Screen {
  int width, height;
  double scale;
  const char* language;
};
void PrintTo(const Screen& s, std::ostream* out) {
  *out << s.width << " x " << s.height << " at scale " << s.scale << ", " << s.language;
}

class Layouts : public testing::TestWithParam<Screen> {
 protected:
  void show(const Screen& screen) {
    player_.reset();
    OffscreenOptions options;
    options.size = {screen.width, screen.height};
    options.contentScale = screen.scale;
    auto host = openOffscreen(OffscreenKind::kOsmesa, options);
    ASSERT_TRUE(host) << host.error();
    host_ = std::move(*host);
    auto player = Player::create(*host_);
    ASSERT_TRUE(player) << player.error();
    player_ = std::move(*player);
    player_->perform(Command("language", screen.language));
    ASSERT_TRUE(player_->perform(
        Command("open", std::string(VIDES_SOURCE_DIR) + "/assets/flights/pyramid.vid")));
    for (int i = 0; i < 3; ++i) player_->frame();
  }
  Rect rectOf(const std::string& id) const {
    const Widget* widget = player_->editor().widgets().find(id);
    EXPECT_NE(widget, nullptr) << id;
    return widget != nullptr ? widget->rect : Rect();
  }
  std::unique_ptr<OffscreenHost> host_;
  std::unique_ptr<Player> player_;
};

TEST_P(Layouts, NothingMustBeScrolled) {
  show(GetParam());
  const float top = rectOf("view/timeline_splitter").centreY();
  EXPECT_LE(rectOf("zoom/value").bottom(), top);
  EXPECT_LE(rectOf("zoom/focal_length").bottom(), top);
  EXPECT_LE(rectOf("measures/turn_rate").bottom(), top);
  EXPECT_GE(rectOf("speed/curve").height, 30.0 * GetParam().scale);
  EXPECT_GE(rectOf("camera/sphere").height, 96.0 * GetParam().scale);
}

// What the camera sees is the result: from edge to edge of its panel.
TEST_P(Layouts, TheCamerasViewIsAsWideAsItsColumn) {
  show(GetParam());
  const Rect picture = rectOf("camera/picture");
  const float column = static_cast<float>(GetParam().width) - rectOf("view/picture").right();
  EXPECT_NEAR(picture.width, column - 16.0 * GetParam().scale, 2.0);
  EXPECT_NEAR(picture.height, picture.width * 9.0 / 16.0, 1.0);
}

INSTANTIATE_TEST_SUITE_P(
    UsualScreens, Layouts,
    testing::Values(Screen{960, 600, 1.0, "en"}, Screen{960, 600, 1.0, "de"},
                    Screen{1440, 900, 1.5, "de"}, Screen{1920, 1200, 2.0, "de"},
                    Screen{1280, 800, 1.0, "en"}, Screen{1366, 768, 1.0, "de"},
                    Screen{1440, 900, 1.0, "en"}, Screen{1920, 1080, 1.0, "de"},
                    Screen{1920, 1080, 1.5, "de"}, Screen{2560, 1440, 1.0, "en"},
                    Screen{2560, 1440, 1.5, "de"}, Screen{2560, 1440, 2.0, "en"},
                    Screen{3840, 2160, 2.0, "de"}));

using LargeWindow = Layouts;
TEST_F(LargeWindow, HasMoreOfWhatIsLookedAt) {
  show({1280, 800, 1.0, "en"});
  const Rect picture = rectOf("camera/picture"), curve = rectOf("speed/curve");
  const Rect sphere = rectOf("camera/sphere"), view = rectOf("view/picture");
  show({2560, 1440, 1.0, "en"});
  EXPECT_GT(rectOf("camera/picture").width, 1.5f * picture.width);
  EXPECT_GT(rectOf("camera/sphere").height, 1.3f * sphere.height);
  EXPECT_GT(rectOf("speed/curve").height, 2.0f * curve.height);
  EXPECT_GT(rectOf("view/picture").width, 2.0f * view.width);
  // A width that the user chose stays.
  auto setup = player_->editor().session().setup();
  for (const float chosen : {300.0f, 700.0f}) {
    setup.layout.right = chosen;
    player_->editor().session().setSetup(setup);
    for (int i = 0; i < 2; ++i) player_->frame();
    EXPECT_EQ(rectOf("camera/picture").width, chosen - 16.0f);
  }
}

// Formats from portrait to panorama, as Flight… sets them.
TEST_F(LargeWindow, OfAUsualColumnTheCamerasViewTakesTwoFifthsAtMost) {
  show({1280, 800, 1.0, "en"});
  const float column = rectOf("view/timeline_splitter").centreY() - 28.0f;
  const float wide = rectOf("camera/picture").width;
  for (const auto& [width, height] :
       {std::pair(1080, 1920), {1000, 1000}, {1600, 1200}, {3000, 500}}) {
    ASSERT_TRUE(player_->perform(Command("set-picture", width, height)));
    for (int i = 0; i < 2; ++i) player_->frame();
    const Rect picture = rectOf("camera/picture");
    EXPECT_EQ(picture.width, wide);
    EXPECT_LE(picture.height, 0.4f * column);
    const float whole = wide * static_cast<float>(height) / static_cast<float>(width);
    EXPECT_NEAR(picture.height, std::min(0.4f * column, whole), 4.0) << height;
    EXPECT_LE(rectOf("measures/turn_rate").bottom(), 28.0f + column);
  }
}

// The splitter goes where the pointer goes, and the room below the picture is the picture's.
TEST_F(LargeWindow, AColumnDraggedWiderGivesItsRoomToTheCamerasView) {
  show({1280, 800, 1.0, "en"});
  const Rect before = rectOf("camera/picture"), sphere = rectOf("camera/sphere");
  const Rect grip = rectOf("view/right_splitter");
  const double x = grip.centreX(), y = grip.centreY();
  player_->move(x, y);
  player_->button(PointerButton::kLeft, true);
  for (int step = 1; step <= 10; ++step) player_->move(x - 20.0 * step, y);
  player_->button(PointerButton::kLeft, false);
  for (int i = 0; i < 2; ++i) player_->frame();
  const Rect after = rectOf("camera/picture");
  EXPECT_EQ(after.width, before.width + 200.0f);
  EXPECT_GT(after.height, 1.4f * before.height);
  EXPECT_LT(rectOf("camera/sphere").height, sphere.height);
  EXPECT_LE(rectOf("measures/turn_rate").bottom(), rectOf("view/timeline_splitter").centreY());
}

// As much as fits, and never half a number.
TEST_P(Layouts, TheOutputLineIsNotCutInAPosition) {
  show(GetParam());
  player_->perform(Command("make-current", 2, 0));
  for (int i = 0; i < 2; ++i) player_->frame();
  std::string shown;
  bool cut = true;
  for (const DrawnText& text : player_->editor().widgets().texts()) {
    if (text.place.y < 28.0 * GetParam().scale && text.text.size() > shown.size())
      shown = text.text, cut = text.shortened;
  }
  EXPECT_NE(shown.find("\u22120"), std::string::npos) << shown;
  EXPECT_NE(shown.find("750"), std::string::npos) << shown;
  EXPECT_FALSE(cut) << shown;
}

}  // namespace
}  // namespace vides
