// SPDX-License-Identifier: MIT
// The file chooser's list.
#include "panels/chooser_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "panels/file_names.hpp"

namespace vides {
namespace {

constexpr float kRow = 24.0f;
constexpr float kSizeColumn = 72.0f;
constexpr float kDateColumn = 132.0f;

// The list's columns: names take what the others leave.
struct Columns {
  Rect name, size, date;
};
Columns columnsOf(const Ui& ui, const Rect& row) {
  const float pad = ui.px(8);
  const Rect date{row.right() - pad - ui.px(kDateColumn), row.y, ui.px(kDateColumn), row.height};
  const Rect size{date.x - 2 * pad - ui.px(kSizeColumn), row.y, ui.px(kSizeColumn), row.height};
  return {{row.x + pad, row.y, size.x - row.x - 3 * pad, row.height}, size, date};
}

// Sorts anew; what is chosen stays chosen.
void sortBy(ChooserMemory& memory, FolderOrder::By by) {
  std::string chosen;
  if (memory.selected >= 0) chosen = memory.entries[static_cast<std::size_t>(memory.selected)].name;
  memory.order.descending = memory.order.by == by && !memory.order.descending;
  memory.order.by = by;
  sortEntries(memory.entries, memory.order);
  const auto found = std::find_if(memory.entries.begin(), memory.entries.end(),
                                  [&](const FolderEntry& entry) { return entry.name == chosen; });
  if (memory.selected >= 0) memory.selected = static_cast<int>(found - memory.entries.begin());
  memory.reveal = true;
}

// The columns' names: a click sorts by one, another the other way round.
void columnHeads(Ui& ui, const Rect& row, ChooserMemory& memory) {
  using By = FolderOrder::By;
  const Columns columns = columnsOf(ui, row);
  const struct {
    const char* id;
    By by;
    const Rect& place;
    Align align;
  } all[] = {{"chooser/sort_name", By::kName, columns.name, Align::kLeft},
             {"chooser/sort_size", By::kSize, columns.size, Align::kRight},
             {"chooser/sort_date", By::kDate, columns.date, Align::kRight}};
  for (const auto& head : all) {
    const bool on = memory.order.by == head.by;
    const float side = ui.px(8);
    const Rect box{head.place.x - side, row.y, head.place.width + 2 * side, row.height};
    if (ui.columnHead(head.id, box, on, memory.order.descending, head.align)) {
      sortBy(memory, head.by);
    }
  }
}

// "812 B", "1.4 kB", "23 MB".
std::string sizeOf(const Ui& ui, std::uintmax_t bytes) {
  constexpr std::array<const char*, 5> kUnits = {"B", "kB", "MB", "GB", "TB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 999.5 && unit + 1 < kUnits.size(); ++unit) value /= 1000.0;
  return ui.number(value, unit > 0 && value < 9.95 ? 1 : 0) + " " + kUnits[unit];
}

// Day and time of day where the user is, in the language's order.
std::string dateOf(const Ui& ui, std::time_t time) {
  std::tm local{};
  if (localtime_r(&time, &local) == nullptr) return {};
  std::string months = ui.words("chooser.months");
  for (int i = 0; i < local.tm_mon; ++i) months.erase(0, months.find(' ') + 1);
  return ui.tell(
      Text("chooser.date", {fmt::format("{:02}", local.tm_mday), months.substr(0, months.find(' ')),
                            std::to_string(local.tm_year + 1900),
                            fmt::format("{:02}:{:02}", local.tm_hour, local.tm_min)}));
}

void drawEntry(Ui& ui, const Rect& row, const FolderEntry& entry, bool on) {
  const Columns columns = columnsOf(ui, row);
  ui.text(columns.name, shownName(ui, entry.name),
          {.weight = on ? Weight::kSemibold : Weight::kRegular, .mayShorten = true});
  const TextStyle quiet{.colour = on ? ColourRole::kText : ColourRole::kTextSecondary,
                        .align = Align::kRight};
  if (entry.folder) {
    ui.icon(Icon::kChevronRight, {columns.size.right() - ui.px(10), row.y, ui.px(16), row.height},
            ColourRole::kTextSecondary);
  } else {
    ui.text(columns.size, sizeOf(ui, entry.bytes), quiet);
  }
  if (entry.changed) ui.text(columns.date, dateOf(ui, *entry.changed), quiet);
}

}  // namespace

ChooserClick chooserList(Ui& ui, const Rect& all, ChooserMemory& memory) {
  ui.fill(all, ColourRole::kField, 3.0f);
  ui.edge(all);
  columnHeads(ui, {all.x, all.y, all.width, ui.px(kRow)}, memory);
  ui.fill({all.x, all.y + ui.px(kRow), all.width, std::max(1.0f, ui.px(1))}, ColourRole::kBorder);
  const float heads = ui.px(kRow + 1);
  const Rect box{all.x, all.y + heads, all.width, all.height - heads};
  if (memory.entries.empty()) {
    const bool any = memory.filter.find_first_not_of(" *") == std::string::npos;
    ui.text(
        {box.x + ui.px(8), box.y, box.width - ui.px(16), ui.px(kRow)},
        any ? ui.words("chooser.empty") : ui.tell(Text("chooser.nothing-fits", {memory.filter})),
        {.colour = ColourRole::kTextSecondary, .mayShorten = true});
  }
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  // Another folder begins at its top.
  const std::string id = "###chooser/list/" + memory.folder.string();
  ImGui::BeginChild(id.c_str(), {box.width, box.height}, false, ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float height = ui.px(kRow);
  ChooserClick click;
  for (int i = 0; i < static_cast<int>(memory.entries.size()); ++i) {
    const FolderEntry& entry = memory.entries[static_cast<std::size_t>(i)];
    // As wide as the heads; the bar that scrolls it stands in the margin.
    const Rect row{from.x, from.y + static_cast<float>(i) * height, box.width, height};
    const auto state = ui.area("chooser/file_" + std::to_string(i), row, entry.name);
    const bool on = i == memory.selected;
    if (on || state.hovered) {
      ui.fill(row, on ? ColourRole::kControlActive : ColourRole::kControlHovered, 3.0f);
    }
    if (ImGui::IsRectVisible({row.x, row.y}, {row.right(), row.bottom()})) {
      drawEntry(ui, row, entry, on);
    }
    if (state.pressed || state.doubleClicked) click = {i, state.doubleClicked};
  }
  ImGui::SetCursorScreenPos(from);
  ImGui::Dummy({1.0f, std::max(1.0f, height * static_cast<float>(memory.entries.size()))});
  if (memory.reveal && memory.selected >= 0) {
    const float top = static_cast<float>(memory.selected) * height;
    if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
    if (top + height > ImGui::GetScrollY() + box.height)
      ImGui::SetScrollY(top + height - box.height);
  }
  memory.reveal = false;
  ImGui::EndChild();
  return click;
}

}  // namespace vides
