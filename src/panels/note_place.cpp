// SPDX-License-Identifier: MIT
// Places are tried from near to far.
#include "panels/note_place.hpp"

#include <algorithm>
#include <cmath>

namespace vides {
namespace {

constexpr float kAside = 16.0f, kBelow = 14.0f;
constexpr float kHandle = 9.0f;  // what is drawn around a handle, at most

int covered(const Rect& box, std::span<const Handle> handles, float margin) {
  return static_cast<int>(std::ranges::count_if(handles, [&](const Handle& handle) {
    const auto x = static_cast<float>(handle.pixel.x), y = static_cast<float>(handle.pixel.y);
    return x > box.x - margin && x < box.right() + margin && y > box.y - margin &&
           y < box.bottom() + margin;
  }));
}

}  // namespace

Rect notePlace(const Rect& room, const ImVec2& size, const ImVec2& pointer,
               std::span<const Handle> handles, float scale) {
  const auto at = [&](float x, float y) {
    const float right = std::max(room.x, room.right() - size.x);
    const float bottom = std::max(room.y, room.bottom() - size.y);
    return Rect{std::round(std::clamp(x, room.x, right)), std::round(std::clamp(y, room.y, bottom)),
                size.x, size.y};
  };
  Rect best{};
  int least = -1;
  for (const float away : {1.0f, 2.0f, 3.5f, 5.0f}) {
    const float aside = kAside * scale, below = kBelow * away * scale;
    const float xs[] = {pointer.x + aside, pointer.x - aside - size.x, pointer.x - size.x / 2};
    const float ys[] = {pointer.y + below, pointer.y - below - size.y};
    for (const float y : ys) {
      for (const float x : xs) {
        const Rect box = at(x, y);
        // Pushed back by the room's edge it may have come to lie under the pointer.
        const bool under = pointer.x > box.x - 4 * scale && pointer.x < box.right() + 4 * scale &&
                           pointer.y > box.y - 4 * scale && pointer.y < box.bottom() + 4 * scale;
        const int count = covered(box, handles, kHandle * scale) + (under ? 1 : 0);
        if (count == 0) return box;
        if (least >= 0 && count >= least) continue;
        least = count;
        best = box;
      }
    }
  }
  return best;
}

}  // namespace vides
