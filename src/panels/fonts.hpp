// SPDX-License-Identifier: MIT
// The typeface of the interface: Inter in two weights and two sizes, digits on one advance width.
//
// Inter is put into the program when it is built; a build without it takes the file from the system
// when it runs, and without that Dear ImGui's own bitmap typeface, which has fewer characters:
// shown() then writes the ones it lacks in plainer ones.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>

struct ImFont;
struct ImFontAtlas;

namespace vides {

inline constexpr double kLeastContentScale = 0.75;
inline constexpr double kMostContentScale = 3.0;

// The fonts of one atlas; valid as long as it is.
struct Fonts {
  ImFont* regular = nullptr;   // controls and text
  ImFont* semibold = nullptr;  // headings and values
  ImFont* small = nullptr;     // ruler and marks
  bool plain = false;          // Inter is missing
};

// An atlas and its fonts, for one content scale.
struct FontSet {
  struct AtlasEnd {
    void operator()(ImFontAtlas* atlas) const;
  };
  std::unique_ptr<ImFontAtlas, AtlasEnd> atlas;
  Fonts fonts;
  double scale = 0.0;
  std::set<char32_t> others;  // characters for which other fonts were asked, had or not
};

// For a content scale (clamped into the range above). On any thread, as long as there is no context
// of Dear ImGui's. The pixels are the renderer's to upload. `others`: characters beyond the
// typeface's, as names of files have them; they come from whatever font is installed.
FontSet buildFonts(double contentScale, const std::set<char32_t>& others = {});

// The text as the fonts can show it: unchanged with Inter; otherwise « … − and their like become
// plain ASCII.
std::string shown(const Fonts& fonts, std::string_view text);

}  // namespace vides
