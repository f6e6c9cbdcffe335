// SPDX-License-Identifier: MIT
// The display's switches by their names.
#include "edit/display.hpp"

namespace vides {
namespace {

struct Switch {
  std::string_view name;
  bool* (*of)(Display& display);
};

constexpr Switch kSwitches[] = {
    {"cube", [](Display& d) { return &d.shown.cube; }},
    {"grid", [](Display& d) { return &d.shown.grid; }},
    {"scene", [](Display& d) { return &d.shown.scene; }},
    {"scene-points", [](Display& d) { return &d.shown.sceneAsPoints; }},
    {"curve", [](Display& d) { return &d.shown.curve; }},
    {"keys", [](Display& d) { return &d.shown.keys; }},
    {"numbers", [](Display& d) { return &d.shown.numbers; }},
    {"aim", [](Display& d) { return &d.shown.aim; }},
    {"up", [](Display& d) { return &d.shown.up; }},
    {"up-circle", [](Display& d) { return &d.shown.upCircle; }},
    {"axes", [](Display& d) { return &d.shown.axes; }},
    {"ghosts", [](Display& d) { return &d.shown.ghosts; }},
    {"playhead", [](Display& d) { return &d.shown.playhead; }},
    {"tangents", [](Display& d) { return &d.shown.tangents; }},
    {"plane-squares", [](Display& d) { return &d.shown.planeSquares; }},
    {"thirds", [](Display& d) { return &d.thirds; }},
    {"safe-frames", [](Display& d) { return &d.safeFrames; }},
    {"sliders", [](Display& d) { return &d.sliders; }},
    {"glide", [](Display& d) { return &d.glide; }},
};

}  // namespace

Theme themeOf(const Display& display) {
  Theme result = theme(display.theme);
  for (std::size_t i = 0; i < kColourRoles; ++i) {
    if (display.colours[i]) result.colours[i] = *display.colours[i];
  }
  return result;
}

const std::vector<std::string_view>& switchNames() {
  static const std::vector<std::string_view> kNames = [] {
    std::vector<std::string_view> list;
    for (const Switch& s : kSwitches) list.push_back(s.name);
    return list;
  }();
  return kNames;
}

bool* switchOf(Display& display, std::string_view name) {
  for (const Switch& s : kSwitches) {
    if (s.name == name) return s.of(display);
  }
  return nullptr;
}

}  // namespace vides
