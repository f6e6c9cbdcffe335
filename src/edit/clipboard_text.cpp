// SPDX-License-Identifier: MIT
// Keys to and from the clipboard.
#include "edit/clipboard_text.hpp"

#include <algorithm>
#include <charconv>

#include "edit/flight_edits.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

constexpr std::string_view kCountMember = "\"x_vides_keys\"";

// How many of the keys were copied: all, where the text doesn't tell.
std::size_t countOf(const Flight& pasted) {
  const std::size_t all = pasted.keys.size();
  if (!pasted.extras.flight) return all;
  for (const auto& [name, value] : *pasted.extras.flight) {
    if (name != kCountMember) continue;
    std::size_t count = all;
    std::from_chars(value.data(), value.data() + value.size(), count);
    return std::clamp<std::size_t>(count, 1, all);
  }
  return all;
}

}  // namespace

std::string clipboardText(const Flight& flight, const KeySelection& keys) {
  Flight copy = flight;
  std::vector<KeyPointer> list;
  list.reserve(std::max<std::size_t>(keys.size(), 2));
  for (const std::size_t k : keys.keys()) list.emplace_back(flight.keys[k]);
  if (list.size() == 1) list.push_back(list.front());
  copy.keys = KeyList(list);
  copy.scene.clear();
  copy.extras.flight = std::make_shared<const ExtraMembers>(
      ExtraMembers{{std::string(kCountMember), std::to_string(keys.size())}});
  return writeVid(copy);
}

tl::expected<std::vector<Key>, Text> keysFromClipboard(std::string_view text,
                                                       const Flight& flight) {
  if (text.empty()) return tl::unexpected(Text("refusal.clipboard-empty"));
  auto pasted = readVid(text);
  if (!pasted) return tl::unexpected(Text("refusal.clipboard", {pasted.error().front()}));
  const std::size_t count = countOf(*pasted);
  const std::array<Shape, kPresets> presets = pasted->presets;
  auto placed = inSpace(*pasted, flight.space);
  if (!placed) return tl::unexpected(placed.error());
  std::vector<Key> keys;
  keys.reserve(count);
  placed->keys.forEach(0, count, [&](const Key& from) {
    Key key = from;
    const int preset = key.shape.preset;
    if (preset != KeyShape::kOwn) {
      const auto i = static_cast<std::size_t>(preset);
      if (!(presets[i] == flight.presets[i])) {
        key.shape.preset = KeyShape::kOwn;
        key.shape.own = presets[i];
      }
    }
    keys.push_back(std::move(key));
  });
  return keys;
}

}  // namespace vides
