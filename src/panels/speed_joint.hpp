// SPDX-License-Identifier: MIT
// What the speed does at a section's start and end, in words and drawn beside the speed curve.
#pragma once

#include <string>
#include <string_view>

#include "evaluate/joint.hpp"
#include "panels/ui.hpp"

namespace vides {

// "jump 50 → 1 · 97.9 %" (the value that would go on, the section's own; in the order of time),
// "stops here · 100.0 %", or shorter where there is no room; nothing where the speed goes on.
std::string jointWords(const Ui& ui, const Joint& joint, SectionEnd end, double own, float room);
// The same in the corner of `curve`, within which the curve is, that its end leaves free; `own` is
// the value of that end. Told as `id`.
void jointNote(Ui& ui, std::string_view id, const Rect& curve, const Joint& joint, SectionEnd end,
               double own);
// Why the value can't be matched: for the button; empty where it can.
std::string whyNoMatch(const Ui& ui, const Joint& joint, SectionEnd end);
// The neighbour's end value, and in brackets the value here that is as fast, where they differ.
std::string beyondWords(const Ui& ui, const Joint& joint);

// Says that a section has nothing to do, where its roll differs by whole turns and nothing else:
// in the middle of the row, as speed/idle.
void idleNote(Ui& ui, const Rect& row, std::int64_t turns);

// Where speeds stand in a curve's area: the joint's x, y of speed 0 and of a value.
struct JointPlace {
  float x = 0.0f;
  float bottom = 0.0f;
  float own = 0.0f;     // y of the section's own value
  float asFast = 0.0f;  // y of the value that would go on
};
// The line of a jump, or of a stop down to its foot.
void drawJoint(Ui& ui, const Joint& joint, const JointPlace& at);

}  // namespace vides
