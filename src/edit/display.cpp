// SPDX-License-Identifier: MIT
// Names and colours of what the viewport shows (8-looks).
#include "edit/display.hpp"

#include <algorithm>

namespace vides {
namespace {

struct ElementFacts {
  std::string_view name;
  Colour colour;
  bool shown;
};

constexpr std::array<ElementFacts, kElements> kFacts = {{
    {"cube", {0x7c, 0x87, 0x94}, true},
    {"scene", {0xc3, 0xc9, 0xd0}, true},
    {"curve", {0x56, 0xb4, 0xe9}, true},
    {"current-section", {0xf2, 0xa3, 0x3a}, true},
    {"keys", {0xe6, 0xe8, 0xeb}, true},
    {"vpn", {0x33, 0xc0, 0x8d}, true},
    {"vup", {0xcc, 0x79, 0xa7}, true},
    {"vup-circle", {0xcc, 0x79, 0xa7}, true},
    {"aim", {0x33, 0xc0, 0x8d}, true},
    {"axes", {0x9a, 0xa3, 0xad}, true},
    {"grid", {0x34, 0x3a, 0x42}, false},
    {"cameras", {0x9a, 0xa3, 0xad}, false},
    {"tangents", {0xf2, 0xa3, 0x3a}, false},
    {"safe-frames", {0xe6, 0xe8, 0xeb}, false},
    {"thirds", {0xe6, 0xe8, 0xeb}, false},
}};

}  // namespace

std::string_view name(Element element) { return kFacts[static_cast<std::size_t>(element)].name; }

std::optional<Element> elementFromName(std::string_view name) {
  const auto found = std::find_if(kFacts.begin(), kFacts.end(),
                                  [&](const ElementFacts& facts) { return facts.name == name; });
  if (found == kFacts.end()) return std::nullopt;
  return static_cast<Element>(found - kFacts.begin());
}

Colour defaultColour(Element element) { return kFacts[static_cast<std::size_t>(element)].colour; }

Display::Display() {
  for (std::size_t i = 0; i < kElements; ++i) elements[i].shown = kFacts[i].shown;
}

}  // namespace vides
