// SPDX-License-Identifier: MIT
// What the viewport shows and in which colours: the part of the setup that commands change.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "io/problem_text.hpp"

namespace vides {

// Everything that has a colour and can be hidden.
enum class Element : std::uint8_t {
  kCube,
  kScene,
  kCurve,
  kCurrentSection,
  kKeys,
  kVpn,
  kVup,
  kVupCircle,
  kAim,
  kAxes,
  kGrid,
  kCameras,
  kTangents,
  kSafeFrames,
  kThirds,
};
inline constexpr std::size_t kElements = 15;

// As in commands and setups: "cube", "current-section", …
std::string_view name(Element element);
std::optional<Element> elementFromName(std::string_view name);

// Red, green, blue, 0 to 255.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Colour&) const = default;
};
Colour defaultColour(Element element);

enum class Units { kCube, kScene };

struct ElementDisplay {
  bool shown = true;
  std::optional<Colour> colour;  // of the theme where there is none
  bool operator==(const ElementDisplay&) const = default;
};

struct Display {
  Display();
  std::array<ElementDisplay, kElements> elements;
  Units units = Units::kCube;  // in which panels show and take positions
  Language language = Language::kEnglish;

  const ElementDisplay& of(Element element) const {
    return elements[static_cast<std::size_t>(element)];
  }
  ElementDisplay& of(Element element) { return elements[static_cast<std::size_t>(element)]; }
  bool operator==(const Display&) const = default;
};

}  // namespace vides
