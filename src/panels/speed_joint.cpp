// SPDX-License-Identifier: MIT
// Jumps and stops at a section's ends.
#include "panels/speed_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vides {
namespace {

std::string speedValue(const Ui& ui, double value) {
  return ui.number(value, std::abs(value - std::round(value)) < 0.05 ? 0 : 1);
}

}  // namespace

std::string jointWords(const Ui& ui, const Joint& joint, SectionEnd end, double own, float room) {
  if (!joint.stops() && !joint.jumps) return "";
  // As `vides info` tells the largest one.
  const std::string change = fmt::format("{} %", ui.number(100.0 * joint.change, 1));
  std::vector<std::string> forms;
  if (joint.stops()) {
    forms = {fmt::format("{} \u00b7 {}", ui.words("speed.stops"), change), ui.words("speed.stops")};
  } else {
    const bool start = end == SectionEnd::kStart;
    const std::string numbers =
        fmt::format("{} \u2192 {}", speedValue(ui, start ? joint.asFast : own),
                    speedValue(ui, start ? own : joint.asFast));
    forms = {fmt::format("{} {} \u00b7 {}", ui.words("speed.jump"), numbers, change),
             fmt::format("{} \u00b7 {}", numbers, change),
             fmt::format("{} {}", ui.words("speed.jump"), change)};
  }
  const auto fits = std::find_if(forms.begin(), forms.end(), [&](const std::string& words) {
    return ui.textWidth(words, Weight::kSmall) <= room;
  });
  return fits != forms.end() ? *fits : forms.back();
}

void jointNote(Ui& ui, std::string_view id, const Rect& curve, const Joint& joint, SectionEnd end,
               double own) {
  const float aside = ui.px(8);
  const float room = std::floor(curve.width / 2 - aside);
  const std::string words = jointWords(ui, joint, end, own, room);
  if (words.empty()) return;
  const bool start = end == SectionEnd::kStart;
  const bool below = own > 0.5 * (kMinSpeed + kMaxSpeed);
  const float height = ui.px(14);
  const Rect box{start ? curve.x + aside : curve.right() - aside - room,
                 below ? curve.bottom() - height : curve.y, room, height};
  ui.text(box, words,
          {.colour = joint.jumps ? ColourRole::kError : ColourRole::kTextSecondary,
           .weight = Weight::kSmall,
           .align = start ? Align::kLeft : Align::kRight,
           .mayShorten = true});
  ui.shows(id, box, words);
}

std::string whyNoMatch(const Ui& ui, const Joint& joint, SectionEnd end) {
  switch (joint.meeting) {
    case Joint::Meeting::kRests:
      return ui.words("refusal.match-rest");
    case Joint::Meeting::kOtherKind:
      return ui.words("refusal.match-kind");
    case Joint::Meeting::kNothing:
      return ui.words(joint.value ? "refusal.match-nothing-moves" : "refusal.no-neighbour");
    case Joint::Meeting::kGoesOn:
      break;
  }
  if (joint.jumps) return "";
  return ui.words(end == SectionEnd::kStart ? "speed.no-jump-before" : "speed.no-jump-after");
}

std::string beyondWords(const Ui& ui, const Joint& joint) {
  if (!joint.value) return "";
  const std::string value = speedValue(ui, *joint.value);
  const bool goesOn = joint.meeting == Joint::Meeting::kGoesOn;
  if (!goesOn || speedValue(ui, joint.asFast) == value) return value;
  return fmt::format("{} ({})", value, ui.number(joint.asFast, joint.asFast < 10.0 ? 1 : 0));
}

void idleNote(Ui& ui, const Rect& row, std::int64_t turns) {
  if (turns == 0) return;
  const std::string whole = ui.tell(Text("speed.idle", {turns}));
  const float room = row.width - ui.px(12);
  const bool fits = ui.textWidth(whole, Weight::kSmall) <= room;
  const std::string words = fits ? whole : ui.tell(Text("speed.idle-brief", {turns}));
  // The curve runs behind it.
  const float width = std::min(room, ui.textWidth(words, Weight::kSmall) + ui.px(8));
  const Rect box{std::round(row.centreX() - width / 2), row.y, width, row.height};
  ui.fill(box, ColourRole::kPanel, 3.0f);
  ui.text(box, words, {.weight = Weight::kSmall, .align = Align::kCentre, .mayShorten = true});
  ui.shows("speed/idle", row, whole);
}

void drawJoint(Ui& ui, const Joint& joint, const JointPlace& at) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (joint.stops()) {
    const ImU32 ink = ui.colour(ColourRole::kTextSecondary);
    const float foot = ui.px(5);
    list.AddLine({at.x, at.own}, {at.x, at.bottom}, ink, 2.0f * ui.scale());
    list.AddLine({at.x - foot, at.bottom}, {at.x + foot, at.bottom}, ink, 2.0f * ui.scale());
  } else if (joint.jumps) {
    list.AddLine({at.x, at.own}, {at.x, at.asFast}, ui.colour(ColourRole::kError),
                 2.0f * ui.scale());
  }
}

}  // namespace vides
