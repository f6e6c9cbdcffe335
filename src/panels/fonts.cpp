// SPDX-License-Identifier: MIT
// The typeface of the interface.
#include "panels/fonts.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "panels/installed_font.hpp"

#ifdef VIDES_EMBEDDED_FONTS
#include "fonts_embedded.hpp"
#endif

namespace vides {
namespace {

// Heights of a line of Dear ImGui's, in pixels at content scale 1; Inter's em is 0.826 of it.
constexpr float kTextHeight = 16.0f;
constexpr float kSmallHeight = 13.5f;

// Latin with its accents, Greek and Cyrillic for names, dashes, quotes, …, the narrow space, −.
constexpr std::array<ImWchar, 17> kTextRanges = {0x0020, 0x002F, 0x003A, 0x024F, 0x0370, 0x03FF,
                                                 0x0400, 0x045F, 0x2010, 0x2026, 0x202F, 0x203A,
                                                 0x20AC, 0x20AC, 0x2190, 0x2212, 0};
constexpr std::array<ImWchar, 13> kInterfaceRanges = {0x0020, 0x002F, 0x003A, 0x017F, 0x2010,
                                                      0x2026, 0x202F, 0x202F, 0x2039, 0x203A,
                                                      0x2190, 0x2212, 0};
constexpr std::array<ImWchar, 3> kDigitRange = {'0', '9', 0};

#ifdef VIDES_EMBEDDED_FONTS
std::optional<std::string> inter(const char* weight) {
  const bool regular = std::string_view(weight) == "Regular";
  return std::string(regular ? fonts::kInterRegularOtf : fonts::kInterSemiBoldOtf);
}
#else
std::optional<std::string> inter(const char* weight) {
  for (const char* folder : {"/usr/share/fonts/opentype/inter", "/usr/share/fonts/truetype/inter",
                             "/usr/share/fonts/inter", "/usr/local/share/fonts/inter"}) {
    for (const char* ending : {".otf", ".ttf"}) {
      const auto file = std::filesystem::path(folder) / (std::string("Inter-") + weight + ending);
      std::ifstream stream(file, std::ios::binary);
      if (!stream) continue;
      std::string bytes{std::istreambuf_iterator<char>(stream), {}};
      if (!bytes.empty()) return bytes;
    }
  }
  return std::nullopt;
}
#endif

void add(ImFontAtlas& atlas, std::string& bytes, float size, const ImFontConfig& settings,
         const ImWchar* ranges) {
  ImFontConfig config = settings;
  config.FontDataOwnedByAtlas = false;
  atlas.AddFontFromMemoryTTF(bytes.data(), static_cast<int>(bytes.size()), size, &config, ranges);
}

// The widest digit's advance.
float digitAdvance(std::string& bytes, float size) {
  ImFontAtlas atlas;
  add(atlas, bytes, size, {}, kDigitRange.data());
  atlas.Build();
  float widest = 0.0f;
  for (const ImFontGlyph& glyph : atlas.Fonts[0]->Glyphs) {
    if (glyph.Codepoint >= '0' && glyph.Codepoint <= '9') widest = std::max(widest, glyph.AdvanceX);
  }
  return std::round(widest);
}

// Digits first: of two merged ranges the first one's glyph stays.
ImFont* addWithEqualDigits(ImFontAtlas& atlas, std::string& bytes, float size,
                           const ImWchar* ranges) {
  ImFontConfig config;
  config.OversampleH = size < 24.0f ? 3 : 2;
  config.OversampleV = 1;
  config.GlyphMinAdvanceX = config.GlyphMaxAdvanceX = digitAdvance(bytes, size);
  add(atlas, bytes, size, config, kDigitRange.data());
  config.GlyphMinAdvanceX = 0.0f;
  config.GlyphMaxAdvanceX = ImFontConfig().GlyphMaxAdvanceX;
  config.MergeMode = true;
  add(atlas, bytes, size, config, ranges);
  return atlas.Fonts.back();
}

// Other fonts' signs for characters that the typeface lacks, merged into the font added last. The
// ranges are read when the atlas is built.
class OtherFonts {
 public:
  explicit OtherFonts(const std::set<char32_t>& characters)
      : fonts_(installedFontsFor(characters)) {
    for (const InstalledFont& font : fonts_) {
      std::vector<ImWchar>& ranges = ranges_.emplace_back();
      for (const char32_t c : font.characters)
        ranges.insert(ranges.end(), 2, static_cast<ImWchar>(c));
      ranges.push_back(0);
    }
  }
  void addTo(ImFontAtlas& atlas, float size) {
    for (std::size_t i = 0; i < fonts_.size(); ++i) {
      ImFontConfig config;
      config.MergeMode = true;
      config.FontNo = fonts_[i].number;
      add(atlas, fonts_[i].bytes, size, config, ranges_[i].data());
    }
  }

 private:
  std::vector<InstalledFont> fonts_;
  std::vector<std::vector<ImWchar>> ranges_;
};

Fonts buildPlain(ImFontAtlas& atlas, float scale) {
  Fonts result;
  const auto make = [&](float height) {
    ImFontConfig config;
    config.SizePixels = std::max(8.0f, std::round(height * scale));
    return atlas.AddFontDefault(&config);
  };
  result.regular = result.semibold = make(13.0f);
  result.small = make(12.0f);
  result.plain = true;
  return result;
}

}  // namespace

void FontSet::AtlasEnd::operator()(ImFontAtlas* atlas) const { delete atlas; }

FontSet buildFonts(double contentScale, const std::set<char32_t>& others) {
  FontSet result;
  result.others = others;
  result.scale = std::clamp(contentScale, kLeastContentScale, kMostContentScale);
  const auto scale = static_cast<float>(result.scale);
  result.atlas.reset(new ImFontAtlas);
  ImFontAtlas& atlas = *result.atlas;
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight | ImFontAtlasFlags_NoMouseCursors;
  auto regular = inter("Regular");
  auto semibold = inter("SemiBold");
  if (!regular || !semibold) {
    result.fonts = buildPlain(atlas, scale);
    atlas.Build();
    return result;
  }
  const float text = std::round(kTextHeight * scale);
  const float small = std::round(kSmallHeight * scale);
  OtherFonts otherFonts(others);
  result.fonts.regular = addWithEqualDigits(atlas, *regular, text, kTextRanges.data());
  otherFonts.addTo(atlas, text);
  result.fonts.semibold = addWithEqualDigits(atlas, *semibold, text, kTextRanges.data());
  otherFonts.addTo(atlas, text);
  result.fonts.small = addWithEqualDigits(atlas, *regular, small, kInterfaceRanges.data());
  atlas.Build();
  // The typefaces' bytes are ours and end here; the atlas is built and needs them no more.
  atlas.ClearInputData();
  return result;
}

std::string shown(const Fonts& fonts, std::string_view text) {
  std::string result(text);
  if (!fonts.plain) return result;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kPlainer = {{
      {"\u2212", "-"},
      {"\u2026", "..."},
      {"\u2013", "-"},
      {"\u2014", "-"},
      {"\u2018", "'"},
      {"\u2019", "'"},
      {"\u201e", "\""},
      {"\u202f", " "},
  }};
  for (const auto& [from, to] : kPlainer) {
    for (std::size_t at = result.find(from); at != std::string::npos; at = result.find(from, at)) {
      result.replace(at, from.size(), to);
      at += to.size();
    }
  }
  return result;
}

}  // namespace vides
