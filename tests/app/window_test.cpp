// SPDX-License-Identifier: MIT
// What a hand does in the program's window ends up in the file, and nothing happens without it.
#include <set>

#include "app/window_fixture.hpp"

namespace vides {
namespace {

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

  expectOnScreen("window_on_screen");

  // Nothing is unsaved: the window goes without a question.
  closeProgram();
}

TEST_F(WindowTest, FliesTheCameraAndPlays) {
  const Session& session = twin_->editor().session();
  const Widget* picture = twin_->editor().widgets().find("camera/picture");
  ASSERT_NE(picture, nullptr);
  const Vec2 middle{static_cast<double>(picture->rect.centreX()),
                    static_cast<double>(picture->rect.centreY())};
  const Camera before = session.camera();
  // Left turns, middle moves sideways: each makes a free view, which U takes over.
  for (const auto button : {PointerButton::kLeft, PointerButton::kMiddle}) {
    drag(button, middle, 24, 10);
    ASSERT_TRUE(session.freeCamera());
    keyBoth(KeyboardKey::kU, {}, "u");
    EXPECT_FALSE(session.freeCamera());
    expectSavedAlike(button == PointerButton::kLeft ? "turned" : "moved");
  }
  EXPECT_GT(glm::length(session.camera().viewPlaneNormal - before.viewPlaneNormal), 0.03);
  EXPECT_GT(glm::length(session.camera().viewReferencePoint - before.viewReferencePoint), 0.01);
  // A view that Escape leaves changes nothing.
  drag(PointerButton::kLeft, middle, -30, 12);
  keyBoth(KeyboardKey::kEscape, {}, "Escape");
  keyBoth(KeyboardKey::kU, {}, "u");
  expectOnScreen("window_flown");

  // Through the last section: picture after picture by itself, until the end.
  keyBoth(KeyboardKey::kEnd, {.control = true}, "ctrl+End");
  keyBoth(KeyboardKey::kLeft, {.shift = true}, "shift+Left");
  const std::int64_t from = session.frame();
  twin_->tap(KeyboardKey::kSpace, {});
  xdotool("key space");
  std::set<std::vector<std::uint8_t>> seen;
  EXPECT_TRUE(waitUntil([&] {
    seen.insert(peer_->screenshot(window_).rgba);
    return seen.size() > 5;
  }));
  while (session.playback().playing()) twin_->frame();
  EXPECT_GT(session.frame(), from + 20);
  EXPECT_EQ(session.frame(), session.evaluation().frameCount() - 1);
  expectOnScreen("window_played");
  closeProgram();
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
