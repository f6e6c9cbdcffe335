// SPDX-License-Identifier: MIT
// fontconfig, looked for when the program runs: without it the program is all but as good.
#include "panels/installed_font.hpp"

#include <dlfcn.h>

#include <memory>
#include <optional>

#include "io/read_file.hpp"

namespace vides {
namespace {

constexpr std::size_t kMostFonts = 4;
constexpr std::size_t kMostBytes = std::size_t{64} << 20;

// What we use of fontconfig/fontconfig.h; its structures are only handed on.
struct Fontconfig {
  void* (*createCharacters)();
  int (*addCharacter)(void* characters, unsigned character);
  int (*hasCharacter)(const void* characters, unsigned character);
  void (*destroyCharacters)(void* characters);
  void* (*createPattern)();
  int (*addCharacters)(void* pattern, const char* object, const void* characters);
  int (*addBool)(void* pattern, const char* object, int value);
  int (*substitute)(void* configuration, void* pattern, int kind);
  void (*substituteDefaults)(void* pattern);
  void* (*match)(void* configuration, void* pattern, int* result);
  int (*getString)(const void* pattern, const char* object, int n, unsigned char** value);
  int (*getInteger)(const void* pattern, const char* object, int n, int* value);
  int (*getCharacters)(const void* pattern, const char* object, int n, void** value);
  void (*destroyPattern)(void* pattern);
};

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

// Stays loaded: it keeps what it has read of the fonts.
std::optional<Fontconfig> fontconfig() {
  void* const library = dlopen("libfontconfig.so.1", RTLD_LAZY | RTLD_LOCAL);
  Fontconfig f{};
  const bool whole = library != nullptr && find(library, "FcCharSetCreate", f.createCharacters) &&
                     find(library, "FcCharSetAddChar", f.addCharacter) &&
                     find(library, "FcCharSetHasChar", f.hasCharacter) &&
                     find(library, "FcCharSetDestroy", f.destroyCharacters) &&
                     find(library, "FcPatternCreate", f.createPattern) &&
                     find(library, "FcPatternAddCharSet", f.addCharacters) &&
                     find(library, "FcPatternAddBool", f.addBool) &&
                     find(library, "FcConfigSubstitute", f.substitute) &&
                     find(library, "FcDefaultSubstitute", f.substituteDefaults) &&
                     find(library, "FcFontMatch", f.match) &&
                     find(library, "FcPatternGetString", f.getString) &&
                     find(library, "FcPatternGetInteger", f.getInteger) &&
                     find(library, "FcPatternGetCharSet", f.getCharacters) &&
                     find(library, "FcPatternDestroy", f.destroyPattern);
  return whole ? std::optional(f) : std::nullopt;
}

std::optional<InstalledFont> oneFontFor(const Fontconfig& f, const std::set<char32_t>& characters) {
  const std::unique_ptr<void, void (*)(void*)> wanted(f.createCharacters(), f.destroyCharacters);
  for (const char32_t c : characters) f.addCharacter(wanted.get(), static_cast<unsigned>(c));
  const std::unique_ptr<void, void (*)(void*)> pattern(f.createPattern(), f.destroyPattern);
  f.addCharacters(pattern.get(), "charset", wanted.get());
  f.addBool(pattern.get(), "scalable", 1);
  f.substitute(nullptr, pattern.get(), 0);
  f.substituteDefaults(pattern.get());
  int result = 0;
  const std::unique_ptr<void, void (*)(void*)> font(f.match(nullptr, pattern.get(), &result),
                                                    f.destroyPattern);
  unsigned char* file = nullptr;
  void* covered = nullptr;
  InstalledFont found;
  if (!font || f.getString(font.get(), "file", 0, &file) != 0 ||
      f.getCharacters(font.get(), "charset", 0, &covered) != 0) {
    return std::nullopt;
  }
  for (const char32_t c : characters) {
    if (f.hasCharacter(covered, static_cast<unsigned>(c)) != 0) found.characters.insert(c);
  }
  auto bytes = readRegularFile(reinterpret_cast<const char*>(file), kMostBytes);
  if (!bytes || found.characters.empty()) return std::nullopt;
  f.getInteger(font.get(), "index", 0, &found.number);
  found.bytes = std::move(*bytes);
  return found;
}

}  // namespace

std::vector<InstalledFont> installedFontsFor(std::set<char32_t> characters) {
  std::vector<InstalledFont> fonts;
  const std::optional<Fontconfig> f = fontconfig();
  while (f && !characters.empty() && fonts.size() < kMostFonts) {
    auto font = oneFontFor(*f, characters);
    if (!font) break;
    for (const char32_t c : font->characters) characters.erase(c);
    fonts.push_back(std::move(*font));
  }
  return fonts;
}

}  // namespace vides
