// SPDX-License-Identifier: MIT
// Every colour of the editor by what it means (8-looks): one table for the drawing and the panels.
//
// Dark, light and high contrast come from the same table. A setup may overwrite single roles, by
// their text names.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "evaluate/section.hpp"
#include "scene/colour.hpp"

namespace vides {

enum class ColourRole : std::uint8_t {
  // Surfaces, from the window to what is pressed.
  kWindow,
  kColumn,
  kPanel,
  kControl,
  kControlHovered,
  kControlActive,   // pressed, or a toggle that is on
  kBorder,          // hairlines between surfaces
  kField,           // ground of typed values and of small graphs
  kEdge,            // line around controls and windows; of controls only where it differs from them
  kViewportTop,     // the viewport's ground, fading downwards …
  kViewportBottom,  // … to this
  kPicture,         // ground of the camera's picture
  kPictureBars,     // what is left of its rectangle
  // Text and neutral controls.
  kText,
  kTextSecondary,  // labels, units
  kTextDisabled,
  kTextOnAccent,
  kSlider,        // the filled part of a slider
  kSliderTrack,   // the rest of it
  kSliderHandle,  // its knob
  kError,         // what went wrong, in the output line
  kAccent,        // current, and nothing else
  // What the viewport draws.
  kCurve,
  kKey,
  kKeySelected,  // the mark around a selected key
  kAim,          // VPN
  kUp,           // VUP
  kScene,
  kCube,
  kGrid,  // the reference grid on the cube's floor
  kAxisX,
  kAxisY,
  kAxisZ,
  kGhost,       // ghost cameras
  kPlayhead,    // the playhead and its camera
  kHandleFill,  // the dark centre of rings
  kGuide,       // thirds and safe frames
  // Sections in the timeline, by kind.
  kMove,
  kPan,
  kRoll,
  kZoom,
  kHold,
  kCount
};

inline constexpr std::size_t kColourRoles = static_cast<std::size_t>(ColourRole::kCount);

enum class ThemeKind : std::uint8_t { kDark, kLight, kHighContrast };

struct Theme {
  std::array<Colour, kColourRoles> colours{};

  const Colour& operator[](ColourRole role) const {
    return colours[static_cast<std::size_t>(role)];
  }
  Colour& operator[](ColourRole role) { return colours[static_cast<std::size_t>(role)]; }
  bool operator==(const Theme&) const = default;
};

// One of the built-in themes.
const Theme& theme(ThemeKind kind);

// Stable text names for files: "curve", "text_secondary"; "dark", "light", "high_contrast".
std::string_view name(ColourRole role);
std::string_view name(ThemeKind kind);
std::optional<ColourRole> colourRole(std::string_view name);
std::optional<ThemeKind> themeKind(std::string_view name);

// Whether the user may choose the colour (Settings → colours): the elements that the viewport
// draws.
bool isElement(ColourRole role);

// Of a section's bar in the timeline.
ColourRole roleOf(SectionKind kind);

}  // namespace vides
