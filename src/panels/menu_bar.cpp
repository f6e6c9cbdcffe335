// SPDX-License-Identifier: MIT
// The names of the menus, the output line, the flight's name.
#include "panels/menu_bar.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vides {
namespace {

constexpr float kLeastOutput = 320.0f;

// As it is, or the first of its shorter forms that has room.
std::string fitting(const Ui& ui, Text text, float room) {
  std::string words = ui.tell(text);
  const std::string key = text.key;
  for (const char* form : {"#short", "#shorter", "#shortest"}) {
    if (ui.textWidth(words) <= room || ui.words(key + form).empty()) break;
    text.key = key + form;
    words = ui.tell(text);
  }
  return words;
}

// The file's name at the right of the bar; the output line before it, or in a row of its own.
void outputLine(Ui& ui, const Rect& bar, const Rect& row, const Session& session,
                const OutputLine& output) {
  const float pad = ui.px(12);
  // The file's name and whether it is saved; the window's title says so in words of its own.
  const std::string& path = session.path();
  const std::string file = path.substr(path.rfind('/') + 1);
  const std::string title =
      (file.empty() ? ui.words("title.untitled") : file) + (session.modified() ? " \u2022" : "");
  const bool own = !row.empty();
  const float most = own ? bar.width - 2 * pad : bar.width * 0.4f;
  const float titleWidth = std::min(ui.textWidth(title, Weight::kSemibold), std::max(0.0f, most));
  const Rect titleBox{bar.right() - pad - titleWidth, bar.y, titleWidth, bar.height};
  ui.text(titleBox, title,
          {.weight = Weight::kSemibold, .align = Align::kRight, .mayShorten = true});
  const bool wrong = output.kind == MessageKind::kRefusal || output.kind == MessageKind::kError;
  const Rect box =
      own ? Rect{row.x + pad, row.y, row.width - 2 * pad, row.height}
          : Rect{bar.x + ui.px(32), bar.y, titleBox.x - pad - ui.px(36) - bar.x, bar.height};
  if (box.width > ui.px(20)) {
    ui.text(box, fitting(ui, output.text, box.width),
            {.colour = wrong                               ? ColourRole::kError
                       : output.kind == MessageKind::kDone ? ColourRole::kText
                                                           : ColourRole::kTextSecondary,
             .align = own ? Align::kLeft : Align::kRight,
             .mayShorten = true});
  }
}

// From one menu's label to the next: closer where the window is narrow. The menus' end in `end`.
float menuSpacing(const Ui& ui, float width, float& end) {
  constexpr float kLeastTitle = 60.0f;
  float labels = 0.0f;
  for (const Menu& menu : menus()) labels += ui.textWidth(ui.words(menu.id));
  const auto gaps = 2.0f * static_cast<float>(menus().size());
  const float room = (width - labels - ui.px(kLeastTitle)) / gaps;
  const float spacing = std::floor(std::clamp(room, ui.px(4), ui.px(16)));
  end = labels + spacing * gaps;
  return spacing;
}

}  // namespace

float menuBar(Ui& ui, const Session& session, const OutputLine& output, float height,
              MenuMemory& memory, Actions& actions) {
  const ImVec2 corner = ImGui::GetWindowPos();
  const float width = ImGui::GetWindowWidth();
  ui.fill({corner.x, corner.y, width, height}, ColourRole::kWindow);
  float menusEnd = 0.0f;
  const float spacing = menuSpacing(ui, width, menusEnd);
  // Where what is left of the bar is too short to say anything, the output line stands below it.
  const float below = width - menusEnd < ui.px(kLeastOutput) ? ui.px(22) : 0.0f;
  const std::string& now = session.menu();
  const auto open = [&](const std::string& menu) { actions.menu = menu; };
  if (std::exchange(memory.closes, false)) open({});
  float end = corner.x + ui.px(8);
  std::size_t index = 0;
  for (const Menu& menu : menus()) {
    const std::string label = ui.words(menu.id);
    const Rect name{end, corner.y, std::floor(ui.textWidth(label) + spacing), height};
    const bool isOpen = now == menu.id;
    if (ui.menuName(menu.id, name, label, {.open = isOpen})) {
      if (!isOpen || !std::exchange(memory.byHover, false)) open(isOpen ? std::string() : menu.id);
      memory.byHover = false;
      memory.byPointer = true;
    } else if (!now.empty() && !isOpen &&
               ImGui::IsMouseHoveringRect({name.x, name.y}, {name.right(), name.bottom()}) &&
               (ImGui::GetIO().MouseDelta.x != 0.0f || ImGui::GetIO().MouseDelta.y != 0.0f)) {
      memory.byHover = memory.byPointer = true;
      open(menu.id);
    }
    if (isOpen && memory.neighbour != 0) {
      const std::size_t count = menus().size();
      const int step = std::exchange(memory.neighbour, 0);
      open(menus()[(index + count + static_cast<std::size_t>(step + static_cast<int>(count))) %
                   count]
               .id);
    }
    end = name.right();
    ++index;
  }
  memory.bar = {corner.x, corner.y, end - corner.x, height};
  const Rect row{corner.x, corner.y + height, width, below};
  outputLine(ui, {end, corner.y, corner.x + width - end, height}, row, session, output);
  return below;
}

}  // namespace vides
