// SPDX-License-Identifier: MIT
// The table of colours: a row for each role, a column for each theme.
#include "scene/theme.hpp"

#include <algorithm>

namespace vides {
namespace {

struct Row {
  ColourRole role;
  std::string_view name;
  std::uint32_t dark, light, highContrast;
};

using R = ColourRole;

// After Okabe and Ito, so that colour-blind eyes tell them apart; darker on the light ground.
constexpr std::array<Row, kColourRoles> kTable{{
    {R::kWindow, "window", 0x15181c, 0xdde1e6, 0x000000},
    {R::kColumn, "column", 0x1e2126, 0xe9ecef, 0x000000},
    {R::kPanel, "panel", 0x262a30, 0xf7f8fa, 0x0c0c0c},
    {R::kControl, "control", 0x343a42, 0xdfe3e8, 0x1f1f1f},
    {R::kControlHovered, "control_hovered", 0x3e454f, 0xd3d8df, 0x333333},
    {R::kControlActive, "control_active", 0x4d5661, 0xc3cad3, 0x4a4a4a},
    {R::kBorder, "border", 0x30353d, 0xc4cad1, 0xb0b0b0},
    {R::kField, "field", 0x191c20, 0xffffff, 0x000000},
    {R::kEdge, "edge", 0x343a42, 0x868f99, 0x9a9a9a},
    {R::kViewportTop, "viewport_top", 0x1b1e25, 0xf4f6f8, 0x000000},
    {R::kViewportBottom, "viewport_bottom", 0x14171b, 0xe8ebef, 0x000000},
    {R::kPicture, "picture", 0x101316, 0xf1f3f5, 0x000000},
    {R::kPictureBars, "picture_bars", 0x1b1e22, 0xdde1e6, 0x1a1a1a},
    {R::kText, "text", 0xe6e8eb, 0x1b1f24, 0xffffff},
    {R::kTextSecondary, "text_secondary", 0x9ba4ae, 0x4f5964, 0xe0e0e0},
    {R::kTextDisabled, "text_disabled", 0x767f8a, 0x757e89, 0x9a9a9a},
    {R::kTextOnAccent, "text_on_accent", 0x15181c, 0xffffff, 0x000000},
    {R::kSlider, "slider", 0x8b97a3, 0x66717d, 0xffffff},
    {R::kSliderTrack, "slider_track", 0x3b424b, 0xc3cad2, 0x5a5a5a},
    {R::kSliderHandle, "slider_handle", 0xffffff, 0x2b3138, 0xffffff},
    {R::kError, "error", 0xff8f6b, 0xa83200, 0xffa38a},
    {R::kAccent, "accent", 0xf2a33a, 0xa85500, 0xffc240},
    {R::kCurve, "curve", 0x56b4e9, 0x0068a6, 0x7ccaff},
    {R::kKey, "key", 0xf2f4f6, 0x14181d, 0xffffff},
    {R::kKeySelected, "key_selected", 0xc9d2db, 0x3a434d, 0xffffff},
    {R::kAim, "aim", 0x33c08d, 0x00795a, 0x3de8a8},
    {R::kUp, "up", 0xcc79a7, 0xa33f78, 0xff9ad0},
    {R::kScene, "scene", 0xc3c9d0, 0x4a525b, 0xf0f0f0},
    {R::kCube, "cube", 0x7c8794, 0x6c7681, 0xc0c0c0},
    {R::kGrid, "grid", 0x58616c, 0xa3acb6, 0x808080},
    {R::kAxisX, "axis_x", 0xe5654f, 0xc0341d, 0xff6f5c},
    {R::kAxisY, "axis_y", 0x6cc24a, 0x3c7d1e, 0x7dff4f},
    {R::kAxisZ, "axis_z", 0x5a9cf0, 0x1f62c4, 0x6b9dff},
    {R::kGhost, "ghost", 0x5f6975, 0x939ca6, 0xa0a0a0},
    {R::kPlayhead, "playhead", 0xdfe4e9, 0x2b3138, 0xffffff},
    {R::kHandleFill, "handle_fill", 0x15181c, 0xffffff, 0x000000},
    {R::kGuide, "guide", 0x3a4149, 0xc9cfd6, 0x7a7a7a},
    {R::kMove, "move", 0x235a82, 0xa9d2ef, 0x0a5a94},
    {R::kPan, "pan", 0x1a6148, 0xa5dcc8, 0x006b4a},
    {R::kRoll, "roll", 0x74406a, 0xe3bdd8, 0x8a2f78},
    {R::kZoom, "zoom", 0x62591c, 0xded58f, 0x6b5f00},
    {R::kHold, "hold", 0x474e57, 0xc9ced5, 0x505050},
}};

constexpr bool inOrder() {
  for (std::size_t i = 0; i < kTable.size(); ++i) {
    if (static_cast<std::size_t>(kTable[i].role) != i) return false;
  }
  return true;
}
static_assert(inOrder(), "a row for each role, in the order of the roles");

constexpr Theme column(std::uint32_t Row::*values) {
  Theme result;
  for (std::size_t i = 0; i < kTable.size(); ++i) result.colours[i] = colour(kTable[i].*values);
  return result;
}

constexpr Theme kDarkTheme = column(&Row::dark);
constexpr Theme kLightTheme = column(&Row::light);
constexpr Theme kHighContrastTheme = column(&Row::highContrast);

constexpr std::array<std::string_view, 3> kThemeNames{"dark", "light", "high_contrast"};

}  // namespace

const Theme& theme(ThemeKind kind) {
  switch (kind) {
    case ThemeKind::kLight:
      return kLightTheme;
    case ThemeKind::kHighContrast:
      return kHighContrastTheme;
    case ThemeKind::kDark:
      break;
  }
  return kDarkTheme;
}

std::string_view name(ColourRole role) { return kTable[static_cast<std::size_t>(role)].name; }
std::string_view name(ThemeKind kind) { return kThemeNames[static_cast<std::size_t>(kind)]; }

std::optional<ColourRole> colourRole(std::string_view name) {
  const auto found = std::ranges::find(kTable, name, &Row::name);
  if (found == kTable.end()) return std::nullopt;
  return found->role;
}

std::optional<ThemeKind> themeKind(std::string_view name) {
  const auto found = std::ranges::find(kThemeNames, name);
  if (found == kThemeNames.end()) return std::nullopt;
  return static_cast<ThemeKind>(found - kThemeNames.begin());
}

bool isElement(ColourRole role) {
  return role == R::kAccent || (role >= R::kCurve && role <= R::kPlayhead);
}

ColourRole roleOf(SectionKind kind) {
  switch (kind) {
    case SectionKind::kMove:
      return R::kMove;
    case SectionKind::kPan:
      return R::kPan;
    case SectionKind::kRoll:
      return R::kRoll;
    case SectionKind::kZoom:
      return R::kZoom;
    case SectionKind::kHold:
      break;
  }
  return R::kHold;
}

}  // namespace vides
