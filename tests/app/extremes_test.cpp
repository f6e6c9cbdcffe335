// SPDX-License-Identifier: MIT
// Numbers that nobody means: whatever commands, flights and pointers say, display frames are drawn.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "app/drive/player.hpp"
#include "edit/command_table.hpp"
#include "host/open_host.hpp"

namespace vides {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array kExtremes = {1e308,  -1e308,     1e15,
                                  -1e15,  1e6,        0.0,
                                  5e-324, -kInfinity, std::numeric_limits<double>::quiet_NaN()};

class Extremes : public testing::Test {
 protected:
  void SetUp() override {
    auto host = openOffscreen(OffscreenKind::kOsmesa, {.size = {960, 600}});
    ASSERT_TRUE(host) << host.error();
    host_ = std::move(*host);
    auto player = Player::create(*host_);
    ASSERT_TRUE(player) << player.error();
    player_ = std::move(*player);
  }
  // Everything is a number still, and the next display frame is drawn.
  void check() {
    for (int i = 0; i < 2; ++i) player_->frame();
    const Session& session = player_->editor().session();
    const EditorView& view = session.view().view;
    const Camera camera = session.camera();
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(std::abs(view.target[i]), 1e6);
      EXPECT_LE(std::abs(camera.viewReferencePoint[i]), 1e6);
      EXPECT_TRUE(std::isfinite(camera.viewPlaneNormal[i]));
    }
    EXPECT_TRUE(std::isfinite(view.turn) && std::isfinite(view.tilt) && std::isfinite(view.size));
  }

  std::unique_ptr<OffscreenHost> host_;
  std::unique_ptr<Player> player_;
};

// Defect 4: this aborted where labels are placed.
TEST_F(Extremes, AViewFromNowhere) {
  for (const char* projection : {"off", "on"}) {
    ASSERT_TRUE(player_->perform(Command("perspective", projection)));
    for (const double far : kExtremes) {
      SCOPED_TRACE(far);
      player_->perform(Command("set-view", 32, 22, 1, far, far, far));
      check();
      player_->perform(Command("set-view", far, far, far, 0, 0, -far));
      check();
    }
  }
}

// All numbers of every command at once, and each alone beside small ones.
TEST_F(Extremes, EveryCommandTakesOrRefusesThem) {
  for (const CommandSpecification& specification : commandTable()) {
    const auto isNumber = [](const ArgumentSpecification& a) {
      return a.kind == ArgumentKind::kNumber || a.kind == ArgumentKind::kIndex;
    };
    if (std::none_of(specification.arguments.begin(), specification.arguments.end(), isNumber)) {
      continue;
    }
    SCOPED_TRACE(specification.name);
    for (const double extreme : kExtremes) {
      Command command(specification.name);
      for (const ArgumentSpecification& argument : specification.arguments) {
        if (isNumber(argument)) {
          command.add(extreme);
        } else {
          command.add(argument.choices.empty() ? "a" : argument.choices.front());
        }
      }
      player_->perform(command);
      if (player_->editor().session().question()) player_->perform(Command("answer", "cancel"));
    }
    check();
    while (player_->perform(Command("undo"))) continue;
  }
}

TEST_F(Extremes, PointersFromNowhere) {
  for (const double x : kExtremes) {
    for (const double y : {0.0, 300.0, 1e308, kInfinity}) {
      player_->move(x, y);
      player_->event(WheelTurned{y, x});
      player_->button(PointerButton::kLeft, true);
      player_->move(y, x);
      player_->button(PointerButton::kLeft, false);
    }
  }
  check();
  // Dragged from a handle and from the timeline to anywhere.
  for (const char* id : {"view/picture", "timeline/track", "camera/picture", "view/size"}) {
    const Widget* const widget = player_->editor().widgets().find(id);
    if (widget == nullptr) continue;
    for (const double far : kExtremes) {
      player_->move(static_cast<double>(widget->rect.centreX()),
                    static_cast<double>(widget->rect.centreY()));
      player_->button(PointerButton::kLeft, true);
      player_->move(far, -far);
      player_->button(PointerButton::kLeft, false);
    }
    check();
  }
}

// The file format has no bounds for lenses.
TEST_F(Extremes, LensesThatNobodyGrinds) {
  for (const double sensor : {1e-300, 36.0, 1e300}) {
    for (const double focal : {1e-300, 1e-12, 1e12, 1e300}) {
      Flight flight = newFlight();
      flight.lens.sensorWidth = sensor;
      flight.lens.focalLengthAtZoom1 = focal;
      flight.lens.focalLengthAtZoom100 = 1.0;
      player_->editor().session().recover(flight, "");
      player_->perform(Command("view", "camera"));
      check();
      player_->perform(Command("show-window", "speed"));
      check();
    }
  }
}

}  // namespace
}  // namespace vides
