// SPDX-License-Identifier: MIT
// The list of shortcuts and of the mouse's ways, in up to three columns.
#include "panels/help_window.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "edit/shortcuts.hpp"
#include "panels/menu_bar.hpp"
#include "panels/window_frame.hpp"

namespace vides {
namespace {

constexpr int kMostColumns = 3;
constexpr float kColumn = 290.0f;
constexpr float kBetweenColumns = 24.0f;
constexpr float kRow = 18.0f;
constexpr float kBetween = 9.0f;  // groups

struct Line {
  std::string what, how;
};
struct Group {
  std::string heading;
  std::vector<Line> lines;
  float height() const { return kRow * static_cast<float>(lines.size() + 1) + kBetween; }
};

// As its menu entry has it, where there is one.
std::string titleFor(const Ui& ui, const Texts& texts, const Command& command) {
  const std::string line = format(command);
  for (const Menu& menu : menus()) {
    for (const MenuEntry& entry : menu.entries) {
      if (!entry.id.empty() && entry.command == line) return ui.words(entry.id);
    }
  }
  return texts.tell(titleOf(command, texts));
}

// Several keys of one command share its line.
std::vector<Group> keyGroups(const Ui& ui, const Texts& texts) {
  std::vector<Group> groups;
  std::string name;
  const Command* last = nullptr;
  for (const Shortcut& shortcut : shortcutTable()) {
    if (groups.empty() || shortcut.group != name) {
      name = shortcut.group;
      groups.push_back({texts.tell(Text("shortcuts." + name)), {}});
    }
    std::vector<Line>& lines = groups.back().lines;
    const std::string keys = shown(shortcut, texts);
    if (last != nullptr && *last == shortcut.command) {
      lines.back().how += ", " + keys;
    } else {
      lines.push_back({titleFor(ui, texts, shortcut.command), keys});
    }
    last = &shortcut.command;
  }
  return groups;
}

Group mouseGroup(const Ui& ui, const std::string& name, const std::vector<const char*>& ways) {
  Group group{ui.words(name + ".heading"), {}};
  for (const char* way : ways) {
    const std::string key = name + "." + way;
    group.lines.push_back({ui.words(key), ui.words(key + ".how")});
  }
  return group;
}

std::vector<Group> allGroups(const Ui& ui, const Texts& texts) {
  std::vector<Group> groups = keyGroups(ui, texts);
  groups.push_back(mouseGroup(
      ui, "mouse",
      {"turn", "pan", "size", "x", "y", "z", "axis", "snap", "select", "box", "insert", "view"}));
  groups.push_back(mouseGroup(ui, "flying", {"turn", "move", "roll", "dolly", "zoom", "walk"}));
  return groups;
}

// Which column each group stands in, in their order, so that the longest column is as short as can
// be: the least height that the groups fit in one after the other.
std::vector<int> columnsOf(const std::vector<Group>& groups, int count, float& height) {
  for (float most = kRow;; most += 1.0f) {
    std::vector<int> columns;
    int column = 0;
    float used = 0.0f;
    for (const Group& group : groups) {
      if (used > 0.0f && used + group.height() > most) {
        ++column;
        used = 0.0f;
      }
      used += group.height();
      if (used > most) column = count;  // not even alone
      columns.push_back(column);
    }
    if (column >= count) continue;
    height = most;
    return columns;
  }
}

void drawGroup(Ui& ui, const Group& group, Rect row) {
  ui.text(row, group.heading, {.weight = Weight::kSemibold});
  for (const Line& line : group.lines) {
    row.y += row.height;
    const float width = ui.textWidth(line.how);
    ui.text({row.x, row.y, row.width - width - ui.px(8), row.height}, line.what,
            {.colour = ColourRole::kTextSecondary});
    ui.text({row.right() - width, row.y, width, row.height}, line.how);
  }
}

}  // namespace

void helpWindow(Ui& ui, const Session& session, const Texts& texts, Actions& actions) {
  const std::vector<Group> groups = allGroups(ui, texts);
  const auto widthOf = [](int columns) {
    return static_cast<float>(columns) * (kColumn + kBetweenColumns) - kBetweenColumns + 32.0f;
  };
  int count = kMostColumns;
  while (count > 1 && ui.px(widthOf(count)) > ui.workArea().width) --count;
  float height = 0.0f;
  const std::vector<int> columns = columnsOf(groups, count, height);
  const bool top = !session.question() && session.windows().back() == "shortcuts";
  WindowFrame frame{"###shortcuts", widthOf(count), height + 48.0f, ui.words("menu/help/shortcuts"),
                    top};
  frame.close = "shortcuts/close";
  const bool stays = windowFrame(ui, frame, [&](const Rect& room) {
    const std::vector<Rect> places = split(ui, room, count, kBetweenColumns);
    std::vector<float> y(places.size(), room.y);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const auto column = static_cast<std::size_t>(columns[i]);
      drawGroup(ui, groups[i], {places[column].x, y[column], places[column].width, ui.px(kRow)});
      y[column] += ui.px(groups[i].height());
    }
  });
  if (!stays) actions.run(Command("close-window", "shortcuts"));
}

}  // namespace vides
