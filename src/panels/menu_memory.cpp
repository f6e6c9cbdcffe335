// SPDX-License-Identifier: MIT
// Keys in menus: arrows, Enter, letters, Escape.
#include "panels/menu_memory.hpp"

#include <algorithm>
#include <utility>

namespace vides {
namespace {

// The first character of a label, small: letters of Latin scripts' two cases are one.
std::string firstLetter(std::string_view text) {
  std::size_t length = std::min<std::size_t>(1, text.size());
  while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) {
    ++length;
  }
  std::string letter(text.substr(0, length));
  if (letter.size() == 1 && letter[0] >= 'A' && letter[0] <= 'Z') letter[0] += 'a' - 'A';
  // U+00C0 to U+00DE: the small ones lie 32 behind.
  if (letter.size() == 2 && letter[0] == '\xC3' && static_cast<unsigned char>(letter[1]) < 0x9F) {
    letter[1] = static_cast<char>(letter[1] + 0x20);
  }
  return letter;
}

}  // namespace

void MenuMemory::opened(std::string_view menu) {
  shown = menu;
  main = further = Level();
  furtherOpen = operates = closes = false;
  neighbour = 0;
  lettered_.clear();
  // The first row, as soon as they are known.
  if (!std::exchange(byPointer, false)) main.marked = kFirst;
}

bool MenuMemory::holds(float x, float y) const {
  return bar.contains(x, y) || main.rect.contains(x, y) ||
         (furtherOpen && further.rect.contains(x, y));
}

void MenuMemory::mark(int step) {
  Level& level = top();
  const int count = static_cast<int>(level.rows.size());
  int at = level.marked < 0 ? (step > 0 ? -1 : count) : level.marked;
  for (int i = 0; i < count; ++i) {
    at = (at + step + count) % count;
    if (level.rows[static_cast<std::size_t>(at)].enabled) break;
  }
  level.marked = at;
  reveals = true;
}

void MenuMemory::markLetter(std::string_view letter) {
  Level& level = top();
  const int count = static_cast<int>(level.rows.size());
  for (int i = 1; i <= count; ++i) {
    const int at = (std::max(level.marked, -1) + i) % count;
    const Row& row = level.rows[static_cast<std::size_t>(at)];
    if (!row.enabled || firstLetter(row.label) != letter) continue;
    level.marked = at;
    reveals = true;
    return;
  }
}

void MenuMemory::key(const KeyChanged& change) {
  const bool plain = !change.modifiers.control && !change.modifiers.alt && !change.modifiers.super;
  if (!plain) return;
  Level& level = top();
  const bool marked = level.marked >= 0 && level.marked < static_cast<int>(level.rows.size());
  const bool opens = marked && level.rows[static_cast<std::size_t>(level.marked)].opens;
  switch (change.key) {
    case KeyboardKey::kUp:
      return mark(-1);
    case KeyboardKey::kDown:
      return mark(1);
    case KeyboardKey::kHome:
      level.marked = -1;
      return mark(1);
    case KeyboardKey::kEnd:
      level.marked = -1;
      return mark(-1);
    case KeyboardKey::kLeft:
      if (furtherOpen) {
        furtherOpen = false;
      } else {
        neighbour = -1;
      }
      return;
    case KeyboardKey::kRight:
      if (opens && !furtherOpen) {
        operates = true;
      } else {
        neighbour = 1;
      }
      return;
    case KeyboardKey::kEnter:
    case KeyboardKey::kPadEnter:
    case KeyboardKey::kSpace:
      operates = marked && !change.repeated;
      return;
    case KeyboardKey::kEscape:
      closes = !std::exchange(furtherOpen, false);
      return;
    case KeyboardKey::kF10:
      closes = true;
      return;
    default:
      break;
  }
  const std::string_view name = keyName(change.key);
  if (name.size() != 1) return;
  lettered_.assign(name.data(), name.size());
  markLetter(name);
}

void MenuMemory::typed(std::string_view text) {
  const std::string letter = firstLetter(text);
  const bool dealtWith = letter == lettered_;
  lettered_.clear();
  if (!dealtWith) markLetter(letter);
}

}  // namespace vides
