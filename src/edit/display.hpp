// SPDX-License-Identifier: MIT
// What is shown, in which colours, units and language: the part of the setup that commands change.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flight/limits.hpp"
#include "io/problem_text.hpp"
#include "scene/theme.hpp"
#include "scene/viewport_scene.hpp"

namespace vides {

// Chosen content scales; 0 stands for the screen's own.
inline constexpr Range kContentScale{0.5, 4.0};
// A ghost camera every so many frames; whole.
inline constexpr Range kGhostEvery{1, 100000};

// Of the grid and of snapping, in cube units.
inline constexpr Range kGridSteps{0.001, 0.5};

// An element whose size can be chosen, by its name in commands and setups.
struct ElementSize {
  std::string_view name;
  double ElementSizes::*size;
  Range range;   // pixels at content scale 1
  int decimals;  // that a slider gives
};
inline constexpr ElementSize kElementSizes[] = {{"curve", &ElementSizes::curve, {1.0, 6.0}, 1},
                                                {"lines", &ElementSizes::lines, {0.6, 4.0}, 1},
                                                {"handles", &ElementSizes::handles, {5.0, 16.0}, 1},
                                                {"ghosts", &ElementSizes::ghosts, {8.0, 48.0}, 0}};

enum class Units { kCube, kScene };

struct Display {
  ShownElements shown;
  ElementSizes sizes;
  double gridStep = kGridStep;
  bool thirds = false;
  bool safeFrames = false;
  bool sliders = true;  // the three around the viewport
  ThemeKind theme = ThemeKind::kDark;
  std::array<std::optional<Colour>, kColourRoles> colours;  // chosen instead of the theme's
  Units units = Units::kCube;  // in which panels show and take positions
  Language language = Language::kEnglish;
  double contentScale = 0.0;  // chosen instead of the screen's; 0: the screen's
  bool glide = true;          // view changes by key take 150 ms

  bool operator==(const Display&) const = default;
};

// The theme with the chosen colours in it.
Theme themeOf(const Display& display);

// What can be shown and hidden, by the names in commands and setups: "cube", "ghosts", …
const std::vector<std::string_view>& switchNames();
// The switch of that name; null for other names.
bool* switchOf(Display& display, std::string_view name);

}  // namespace vides
