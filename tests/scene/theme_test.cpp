// SPDX-License-Identifier: MIT
// The table of colours: what 8-looks fixes, and that everything can be read on what it stands on.
#include "scene/theme.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace vides {
namespace {

using R = ColourRole;

constexpr ThemeKind kKinds[] = {ThemeKind::kDark, ThemeKind::kLight, ThemeKind::kHighContrast};
constexpr R kSurfaces[] = {R::kWindow, R::kColumn,      R::kPanel,          R::kControl,
                           R::kField,  R::kViewportTop, R::kViewportBottom, R::kPicture};

TEST(Colours, ContrastAsWcagDefinesIt) {
  EXPECT_DOUBLE_EQ(contrastRatio(colour(0x000000), colour(0xffffff)), 21.0);
  EXPECT_DOUBLE_EQ(contrastRatio(colour(0x777777), colour(0x777777)), 1.0);
  // The grey that just misses 4.5 : 1 on white (WebAIM's example), and the one that reaches it.
  EXPECT_NEAR(contrastRatio(colour(0x777777), colour(0xffffff)), 4.48, 0.005);
  EXPECT_NEAR(contrastRatio(colour(0xffffff), colour(0x767676)), 4.54, 0.005);
}

TEST(Colours, MixAndFade) {
  EXPECT_EQ(mix(colour(0x000000), colour(0xffffff), 0.5), colour(0x808080));
  EXPECT_EQ(mix(colour(0x102030), colour(0xffffff), -1.0), colour(0x102030));
  EXPECT_EQ(mix(colour(0x102030), colour(0xff0000), 2.0), colour(0xff0000));
  EXPECT_EQ(faded(colour(0x102030), 0.5), (Colour{0x10, 0x20, 0x30, 128}));
}

TEST(Theme, DarkIsAsTheLooksSay) {
  const Theme& dark = theme(ThemeKind::kDark);
  EXPECT_EQ(dark[R::kWindow], colour(0x15181c));
  EXPECT_EQ(dark[R::kColumn], colour(0x1e2126));
  EXPECT_EQ(dark[R::kPanel], colour(0x262a30));
  EXPECT_EQ(dark[R::kControl], colour(0x343a42));
  EXPECT_EQ(dark[R::kAccent], colour(0xF2A33A));
  EXPECT_EQ(dark[R::kText], colour(0xe6e8eb));
  // One step brighter than the sketch's 9aa3ad, which has 4.49 : 1 on controls.
  EXPECT_EQ(dark[R::kTextSecondary], colour(0x9ba4ae));
  EXPECT_EQ(dark[R::kCurve], colour(0x56B4E9));
  EXPECT_EQ(dark[R::kAim], colour(0x33C08D));
  EXPECT_EQ(dark[R::kUp], colour(0xCC79A7));
  EXPECT_EQ(dark[R::kScene], colour(0xc3c9d0));
  EXPECT_EQ(dark[R::kCube], colour(0x7c8794));
}

TEST(Theme, TextCanBeReadOnEverySurface) {
  for (const ThemeKind kind : kKinds) {
    const Theme& t = theme(kind);
    for (const R surface : kSurfaces) {
      EXPECT_GE(contrastRatio(t[R::kText], t[surface]), 4.5) << name(kind) << name(surface);
      EXPECT_GE(contrastRatio(t[R::kTextSecondary], t[surface]), 4.5)
          << name(kind) << " " << name(surface);
    }
    for (const R control : {R::kControlHovered, R::kControlActive}) {
      EXPECT_GE(contrastRatio(t[R::kText], t[control]), 4.5) << name(kind) << name(control);
    }
    for (const R bar : {R::kMove, R::kPan, R::kRoll, R::kZoom, R::kHold}) {
      EXPECT_GE(contrastRatio(t[R::kText], t[bar]), 4.5) << name(kind) << " " << name(bar);
    }
    EXPECT_GE(contrastRatio(t[R::kTextOnAccent], t[R::kAccent]), 4.5) << name(kind);
    for (const R surface : {R::kWindow, R::kColumn, R::kPanel, R::kViewportTop}) {
      EXPECT_GE(contrastRatio(t[R::kError], t[surface]), 4.5) << name(kind) << name(surface);
    }
  }
}

// Greyed texts need not be read at a glance, but they must be readable.
TEST(Theme, GreyedTextIsReadable) {
  for (const ThemeKind kind : kKinds) {
    const Theme& t = theme(kind);
    for (const R surface : {R::kWindow, R::kColumn, R::kPanel}) {
      EXPECT_GE(contrastRatio(t[R::kTextDisabled], t[surface]), 3.0) << name(kind) << name(surface);
    }
    // As buttons are greyed.
    const Colour greyed = mix(t[R::kPanel], t[R::kControl], 0.4);
    EXPECT_GE(contrastRatio(t[R::kTextDisabled], greyed), 2.8) << name(kind);
  }
}

// What tells a control from what it stands on, and its state: sliders, knobs, ticks and their
// squares (slider on field and panel), the windows' edges; in light and high contrast, where the
// grounds are all but alike, the edges of buttons and fields too.
TEST(Theme, ControlsStandOut) {
  for (const ThemeKind kind : kKinds) {
    const Theme& t = theme(kind);
    for (const R surface :
         {R::kWindow, R::kColumn, R::kPanel, R::kViewportTop, R::kViewportBottom, R::kField}) {
      for (const R role : {R::kSlider, R::kSliderHandle, R::kText, R::kAccent}) {
        EXPECT_GE(contrastRatio(t[role], t[surface]), 3.0)
            << name(kind) << " " << name(role) << " on " << name(surface);
      }
    }
    EXPECT_GE(contrastRatio(t[R::kSliderHandle], t[R::kSliderTrack]), 3.0) << name(kind);
    for (const R handle : {R::kText, R::kAccent, R::kAim, R::kUp}) {
      EXPECT_GE(contrastRatio(t[handle], t[R::kHandleFill]), 3.0) << name(kind) << name(handle);
    }
    if (kind == ThemeKind::kDark) continue;
    for (const R surface : {R::kPanel, R::kField}) {
      EXPECT_GE(contrastRatio(t[R::kEdge], t[surface]), 3.0) << name(kind) << " " << name(surface);
    }
  }
}

TEST(Theme, WhatIsDrawnStandsOutFromTheGround) {
  for (const ThemeKind kind : kKinds) {
    const Theme& t = theme(kind);
    for (const R ground : {R::kViewportTop, R::kViewportBottom}) {
      for (const R role : {R::kAccent, R::kCurve, R::kKey, R::kAim, R::kUp, R::kScene, R::kCube,
                           R::kAxisX, R::kAxisY, R::kAxisZ, R::kPlayhead}) {
        EXPECT_GE(contrastRatio(t[role], t[ground]), 3.0) << name(kind) << " " << name(role);
      }
    }
  }
}

TEST(Theme, NamesLeadBack) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kColourRoles; ++i) {
    const auto role = static_cast<R>(i);
    EXPECT_EQ(colourRole(name(role)), role);
    names.insert(name(role));
  }
  EXPECT_EQ(names.size(), kColourRoles);
  EXPECT_EQ(colourRole("beige"), std::nullopt);
  for (const ThemeKind kind : kKinds) EXPECT_EQ(themeKind(name(kind)), kind);
  EXPECT_EQ(themeKind(""), std::nullopt);
}

TEST(Theme, EachKindOfSectionHasItsColour) {
  const Theme& t = theme(ThemeKind::kDark);
  std::set<std::string> colours;
  for (const SectionKind kind : {SectionKind::kMove, SectionKind::kPan, SectionKind::kRoll,
                                 SectionKind::kZoom, SectionKind::kHold}) {
    const Colour& c = t[roleOf(kind)];
    colours.insert(std::to_string(c.red) + "," + std::to_string(c.green) + "," +
                   std::to_string(c.blue));
    EXPECT_EQ(name(roleOf(kind)), name(kind));
  }
  EXPECT_EQ(colours.size(), 5u);
}

}  // namespace
}  // namespace vides
