// SPDX-License-Identifier: MIT
// The menu that is open, and the further one beside it: over everything, by pointer and keys.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/menu_bar.hpp"

namespace vides {
namespace {

constexpr float kRowHeight = 24.0f;
constexpr float kLineHeight = 9.0f;
constexpr float kMenuPadding = 6.0f;  // above and below rows
constexpr float kRowInset = 8.0f;     // of a row's words
constexpr float kBetween = 28.0f;     // from names to keys
constexpr float kTick = 16.0f;

// Pixels that its rows need.
ImVec2 sizeOf(const Ui& ui, const std::vector<MenuItem>& entries) {
  float names = 0.0f, keys = 0.0f, height = 2 * ui.px(kMenuPadding);
  for (const MenuItem& entry : entries) {
    names = std::max(names, ui.textWidth(entry.row.label));
    keys = std::max(keys, ui.textWidth(entry.style.keys));
    height += ui.px(entry.row.id.empty() ? kLineHeight : kRowHeight);
  }
  return {std::ceil(names) + std::ceil(keys) + ui.px(kBetween) + ui.px(kTick) +
              2 * ui.px(kRowInset + kMenuPadding),
          height};
}

// One menu, with the row that was chosen: -1 for none.
int menuLevel(Ui& ui, const char* id, ImVec2 at, const std::vector<MenuItem>& entries,
              MenuMemory& memory, MenuMemory::Level& level) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = ui.px(4);
  ImVec2 size = sizeOf(ui, entries);
  size.x = std::min(size.x, screen.x - 2 * margin);
  at.x = std::max(margin, std::min(at.x, screen.x - margin - size.x));
  const float height = std::min(size.y, screen.y - margin - at.y);
  level.rect = {at.x, at.y, size.x, height};
  level.rows.clear();
  for (const MenuItem& entry : entries) {
    if (!entry.row.id.empty()) level.rows.push_back(entry.row);
  }
  const auto first = std::find_if(level.rows.begin(), level.rows.end(),
                                  [](const MenuMemory::Row& row) { return row.enabled; });
  if (level.marked == MenuMemory::kFirst)
    level.marked = static_cast<int>(first - level.rows.begin());
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize({size.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(5));
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar(2);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  ImGui::PushClipRect({at.x, at.y}, {at.x + size.x, at.y + height}, false);
  ui.outline(level.rect, ColourRole::kBorder, 5.0f);
  ImGui::PopClipRect();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float inset = ui.px(kMenuPadding);
  float y = from.y + inset;
  int chosen = -1, index = 0;
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  const bool moves = delta.x != 0.0f || delta.y != 0.0f;
  for (const MenuItem& entry : entries) {
    if (entry.row.id.empty()) {
      const float middle = std::round(y + ui.px(kLineHeight) / 2);
      ui.fill({from.x + inset, middle, size.x - 2 * inset, std::max(1.0f, ui.px(1))},
              ColourRole::kBorder);
      y += ui.px(kLineHeight);
      continue;
    }
    const Rect rect{from.x + inset, y, size.x - 2 * inset, ui.px(kRowHeight)};
    y += rect.height;
    Ui::MenuRow style = entry.style;
    style.enabled = entry.row.enabled;
    style.opens = entry.row.opens;
    style.open = entry.row.opens && memory.furtherOpen;
    style.inset = ui.px(kRowInset);
    const bool over = ImGui::IsMouseHoveringRect({rect.x, rect.y}, {rect.right(), rect.bottom()});
    // A pointer that rests leaves to the keys what is marked.
    if (over && moves && ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) {
      level.marked = style.enabled ? index : -1;
    }
    style.marked = level.marked == index && style.enabled;
    if (style.marked && memory.reveals) {
      ImGui::ScrollToRect(ImGui::GetCurrentWindow(),
                          {rect.x, rect.y - inset, rect.right(), rect.bottom() + inset},
                          ImGuiScrollFlags_KeepVisibleEdgeY);
    }
    // Also of a press on the menu's name that is let go here.
    const bool dragged = over && style.enabled && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                         !ImGui::IsItemActive() &&
                         memory.bar.contains(ImGui::GetIO().MouseClickedPos[0].x,
                                             ImGui::GetIO().MouseClickedPos[0].y);
    if (ui.menuRow(entry.row.id, rect, entry.row.label, style) || dragged) chosen = index;
    ++index;
  }
  ImGui::SetCursorScreenPos(from);
  ImGui::Dummy({1.0f, size.y});
  ImGui::End();
  return chosen;
}

const MenuItem& rowAt(const std::vector<MenuItem>& entries, int index) {
  for (const MenuItem& entry : entries) {
    if (!entry.row.id.empty() && index-- == 0) return entry;
  }
  return entries.front();
}

// The open menu, over everything.
void openMenu(Ui& ui, const Menu& menu, const ImVec2& at, const Session& session,
              const Layout& layout, MenuMemory& memory, Actions& actions) {
  const bool operates = std::exchange(memory.operates, false);
  const std::vector<MenuItem> entries = itemsOf(ui, menu, session, layout);
  int chosen = menuLevel(ui, "###menu", at, entries, memory, memory.main);
  const auto isRecent = [&](int row) { return row >= 0 && rowAt(entries, row).row.opens; };
  if (operates && !memory.furtherOpen) chosen = memory.main.marked;
  if (chosen >= 0 && !rowAt(entries, chosen).row.enabled) chosen = -1;
  // Moving onto the row opens what it opens, moving to another one closes it.
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  if ((delta.x != 0.0f || delta.y != 0.0f) && memory.main.rect.contains(pointer.x, pointer.y)) {
    const bool wanted = isRecent(memory.main.marked);
    if (wanted != memory.furtherOpen) memory.further = {};
    memory.furtherOpen = wanted;
  }
  if (isRecent(chosen)) {
    if (!memory.furtherOpen) memory.further = {};
    if (operates) memory.further.marked = MenuMemory::kFirst;
    memory.furtherOpen = true;
  } else if (chosen >= 0) {
    choose(rowAt(entries, chosen), layout, actions);
  }
  if (!memory.furtherOpen) {
    memory.reveals = false;
    return;
  }
  const std::vector<MenuItem> files = recentItems(ui, session);
  if (files.empty()) {
    memory.furtherOpen = false;
    return;
  }
  const bool had = !memory.further.rows.empty();
  const Widget* const row = ui.registry().find("menu/file/recent");
  const ImVec2 beside(memory.main.rect.right() - ui.px(2),
                      (row != nullptr ? row->rect.y : at.y) - ui.px(kMenuPadding));
  int file = menuLevel(ui, "###menu/further", beside, files, memory, memory.further);
  if (operates && had) file = memory.further.marked;
  memory.reveals = false;
  if (file >= 0) choose(rowAt(files, file), layout, actions);
}

// The window that has the keyboard, which the menu gives back to it.
ImGuiID focusedWindow() {
  const ImGuiWindow* const window = ImGui::GetCurrentContext()->NavWindow;
  return window != nullptr ? window->RootWindow->ID : 0;
}

void giveFocusBack(ImGuiID id) {
  ImGuiWindow* const window = ImGui::FindWindowByID(id);
  if (window != nullptr && window->WasActive) ImGui::FocusWindow(window);
}

}  // namespace

void openMenu(Ui& ui, const Session& session, const Layout& layout, MenuMemory& memory,
              Actions& actions) {
  const std::string& now = session.menu();
  if (now != memory.shown) {
    if (memory.shown.empty()) memory.focusBefore = focusedWindow();
    memory.opened(now);
    if (now.empty()) giveFocusBack(memory.focusBefore);
  }
  const auto menu = std::find_if(menus().begin(), menus().end(),
                                 [&](const Menu& each) { return each.id == now; });
  const Widget* const name = ui.registry().find(now);
  if (menu == menus().end() || name == nullptr) return;
  // Rows' words begin under the menu's name.
  const float words = name->rect.centreX() - ui.textWidth(name->label) / 2;
  const float left = std::round(words) - ui.px(kRowInset + kMenuPadding);
  openMenu(ui, *menu, {left, name->rect.bottom()}, session, layout, memory, actions);
}

}  // namespace vides
