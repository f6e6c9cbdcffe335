// SPDX-License-Identifier: MIT
// Notes beside the pointer: near it, inside the picture, over no handle while there is a place.
#include "panels/note_place.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace vides {
namespace {

constexpr Rect kRoom{300.0f, 30.0f, 640.0f, 600.0f};
constexpr ImVec2 kSize{220.0f, 24.0f};

Handle handleAtPixel(double x, double y) { return {{}, {x, y}, 10.0}; }

bool covers(const Rect& box, const Handle& handle) {
  return box.contains(static_cast<float>(handle.pixel.x), static_cast<float>(handle.pixel.y));
}

TEST(NotePlace, BelowAndBesideThePointer) {
  const Rect box = notePlace(kRoom, kSize, {500.0f, 300.0f}, {}, 1.0f);
  EXPECT_EQ(box.x, 516.0f);
  EXPECT_EQ(box.y, 314.0f);
  EXPECT_EQ(box.width, kSize.x);
}

TEST(NotePlace, KeepsOffWhatIsPointedAtAndOffOtherKeys) {
  // The pointed one, and others all along where the note would stand.
  std::vector<Handle> handles = {handleAtPixel(500, 300)};
  for (int i = 0; i < 10; ++i) handles.push_back(handleAtPixel(520.0 + 20.0 * i, 326.0));
  const Rect box = notePlace(kRoom, kSize, {500.0f, 300.0f}, handles, 1.0f);
  for (const Handle& handle : handles) EXPECT_FALSE(covers(box, handle));
  EXPECT_FALSE(box.contains(500.0f, 300.0f));
}

TEST(NotePlace, StaysInThePictureInItsCorners) {
  for (const ImVec2 pointer :
       {ImVec2(305, 35), ImVec2(935, 35), ImVec2(305, 625), ImVec2(935, 625)}) {
    const Handle pointed =
        handleAtPixel(static_cast<double>(pointer.x), static_cast<double>(pointer.y));
    const Rect box = notePlace(kRoom, kSize, pointer, {&pointed, 1}, 1.0f);
    EXPECT_GE(box.x, kRoom.x);
    EXPECT_GE(box.y, kRoom.y);
    EXPECT_LE(box.right(), kRoom.right());
    EXPECT_LE(box.bottom(), kRoom.bottom());
    EXPECT_FALSE(covers(box, pointed));
  }
}

TEST(NotePlace, WhereHandlesAreEverywhereItStandsSomewhere) {
  std::vector<Handle> handles;
  for (int x = 300; x < 940; x += 15) {
    for (int y = 30; y < 630; y += 15) handles.push_back(handleAtPixel(x, y));
  }
  const Rect box = notePlace(kRoom, kSize, {500.0f, 300.0f}, handles, 1.0f);
  EXPECT_EQ(box.width, kSize.x);
  EXPECT_GE(box.x, kRoom.x);
}

}  // namespace
}  // namespace vides
