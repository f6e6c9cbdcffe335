// SPDX-License-Identifier: MIT
// The menus, the output line, the flight's name.
#include "panels/menu_bar.hpp"

#include <algorithm>
#include <cmath>

#include "panels/file_names.hpp"
#include "panels/windows.hpp"

namespace vides {
namespace {

constexpr float kLeastOutput = 320.0f;

// A tick stands before what is on.
bool ticked(std::string_view id, const Session& session, const Layout& layout) {
  const EditorView& view = session.view().view;
  if (id == "menu/view/perspective") return view.type == ProjectionType::Perspective;
  if (id == "menu/view/camera") return session.view().throughCamera;
  if (id == "menu/view/swap") return session.view().swapped;
  if (id == "menu/view/left_column") return layout.leftShown;
  if (id == "menu/view/right_column") return layout.rightShown;
  if (id == "menu/view/timeline") return layout.timelineShown;
  if (id == "menu/view/sliders") return session.display().sliders;
  if (id == "menu/view/full_screen") return session.fullScreen();
  if (id == "menu/settings/english") return session.display().language == Language::kEnglish;
  if (id == "menu/settings/german") return session.display().language != Language::kEnglish;
  return false;
}

// Entries that fold parts of the window, which the session knows nothing of.
bool layoutEntry(std::string_view id, Layout layout, Actions& actions) {
  if (id == "menu/view/left_column") {
    layout.leftShown = !layout.leftShown;
  } else if (id == "menu/view/right_column") {
    layout.rightShown = !layout.rightShown;
  } else if (id == "menu/view/timeline") {
    layout.timelineShown = !layout.timelineShown;
  } else {
    return false;
  }
  actions.layout = layout;
  return true;
}

std::string labelOf(const Ui& ui, const Session& session, const std::string& id) {
  if (id == "menu/edit/undo") {
    if (const auto name = session.undoName()) return ui.tell(*name);
  }
  if (id == "menu/edit/redo") {
    if (const auto name = session.redoName()) return ui.tell(*name);
  }
  return ui.words(id);
}

void entry(Ui& ui, const MenuEntry& item, const Session& session, const Layout& layout,
           Actions& actions) {
  const bool isLayout = item.command.empty();
  const bool nothingToDo = item.command == "revert" && !session.differsFromFile();
  const bool enabled = isLayout || (canRun(session, item.command) && !nothingToDo);
  const std::string label = labelOf(ui, session, item.id);
  const bool tick = ticked(item.id, session, layout);
  const std::string keys = isLayout ? std::string() : ui.hint(item.command);
  // Dear ImGui greys nothing in our style. It leaves room for the keys, left-aligned and before the
  // tick's: they are written at the right end of that room.
  ImGui::PushStyleColor(ImGuiCol_Text,
                        ui.colour(enabled ? ColourRole::kText : ColourRole::kTextDisabled));
  ImGui::PushStyleColor(ImGuiCol_TextDisabled, 0);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float tickRoom = std::floor(ImGui::GetFontSize() * 1.2f);
  const float end = at.x + ImGui::GetContentRegionAvail().x - tickRoom;
  const bool chosen =
      ImGui::MenuItem((label + "###" + item.id).c_str(), keys.c_str(), tick, enabled);
  ImGui::PopStyleColor(2);
  const float keysWidth = ui.textWidth(keys);
  ui.text({end - keysWidth, at.y, keysWidth, ImGui::GetTextLineHeight()}, keys,
          {.colour = enabled ? ColourRole::kTextSecondary : ColourRole::kTextDisabled});
  ui.note(item.id, label, WidgetKind::kMenuItem, enabled, tick ? "on" : "");
  if (!chosen) return;
  if (isLayout) {
    static_cast<void>(layoutEntry(item.id, layout, actions));
  } else if (auto command = parseCommand(item.command)) {
    actions.run(std::move(*command));
  }
}

void recentFiles(Ui& ui, const Session& session, Actions& actions) {
  const auto& files = session.recentFiles();
  const std::string words = ui.words("menu/file/recent");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect rect{at.x, at.y, ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight()};
  const bool open = ImGui::BeginMenu((words + "###menu/file/recent").c_str(), !files.empty());
  ui.menu("menu/file/recent", rect, words, !files.empty(), open);
  if (!open) return;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string id = "menu/file/recent_" + std::to_string(i);
    if (nameEntry(ui, id, files[i])) actions.run(Command("open", files[i]));
    ui.note(id, files[i], WidgetKind::kMenuItem, true);
  }
  ImGui::EndMenu();
}

void entries(Ui& ui, const Menu& menu, const Session& session, const Layout& layout,
             Actions& actions) {
  for (const MenuEntry& item : menu.entries) {
    if (item.id.empty()) {
      ImGui::Separator();
    } else if (item.id == "menu/file/recent") {
      recentFiles(ui, session, actions);
    } else {
      entry(ui, item, session, layout, actions);
    }
  }
}

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

const std::vector<Menu>& menus() {
  static const std::vector<Menu> table = {
      {"menu/file",
       {{"menu/file/new", "new"},
        {"menu/file/open", "open"},
        {"menu/file/recent", ""},
        {"", ""},
        {"menu/file/save", "save"},
        {"menu/file/save_as", "save-as"},
        {"menu/file/revert", "revert"},
        {"", ""},
        {"menu/file/import", "import-scene"},
        {"menu/file/flight", "show-window flight"},
        {"", ""},
        {"menu/file/quit", "quit"}}},
      {"menu/edit",
       {{"menu/edit/undo", "undo"},
        {"menu/edit/redo", "redo"},
        {"", ""},
        {"menu/edit/cut", "cut"},
        {"menu/edit/copy", "copy"},
        {"menu/edit/paste", "paste"},
        {"menu/edit/duplicate", "duplicate-keys"},
        {"menu/edit/delete", "delete-keys"},
        {"menu/edit/select_all", "select-all"},
        {"", ""},
        {"menu/edit/insert_at_playhead", "insert-at-playhead"}}},
      {"menu/view",
       {{"menu/view/front", "view front"},
        {"menu/view/side", "view side"},
        {"menu/view/top", "view top"},
        {"menu/view/iso", "view iso"},
        {"menu/view/opposite", "view-opposite"},
        {"menu/view/camera", "view-camera"},
        {"", ""},
        {"menu/view/perspective", "perspective"},
        {"menu/view/frame_selection", "frame-selection"},
        {"menu/view/frame_all", "frame-all"},
        {"menu/view/swap", "swap-views"},
        {"", ""},
        {"menu/view/left_column", ""},
        {"menu/view/right_column", ""},
        {"menu/view/timeline", ""},
        {"menu/view/sliders", "show-element sliders"},
        {"", ""},
        {"menu/view/full_screen", "full-screen"}}},
      {"menu/output",
       {{"menu/output/frames", "show-window frames"}, {"menu/output/host", "hand-over"}}},
      {"menu/settings",
       {{"menu/settings/display", "show-window settings"},
        {"", ""},
        {"menu/settings/english", "language en"},
        {"menu/settings/german", "language de"},
        {"", ""},
        {"menu/settings/load", "load-setup"},
        {"menu/settings/save", "save-setup"}}},
      {"menu/help", {{"menu/help/shortcuts", "show-window shortcuts"}}},
  };
  return table;
}

float menuBar(Ui& ui, const Session& session, const OutputLine& output, const Layout& layout,
              Actions& actions) {
  if (!ImGui::BeginMenuBar()) return 0.0f;
  const ImVec2 corner = ImGui::GetWindowPos();
  const float height = ImGui::GetFrameHeight();
  const float width = ImGui::GetWindowWidth();
  float menusEnd = 0.0f;
  const float spacing = menuSpacing(ui, width, menusEnd);
  // Where what is left of the bar is too short to say anything, the output line stands below it.
  const float below = width - menusEnd < ui.px(kLeastOutput) ? ui.px(22) : 0.0f;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(spacing, ui.px(8)));
  float end = corner.x;
  for (const Menu& menu : menus()) {
    const std::string label = ui.words(menu.id);
    const float begin = ImGui::GetCursorScreenPos().x;
    // Entries begin under the menu's name: Dear ImGui opens the menu half a spacing and a pixel
    // before the place of the name, which itself begins half a spacing behind it.
    const float half = std::floor(spacing / 2.0f);
    const float opens = std::max(0.0f, begin - 1.0f - half);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(begin + half - opens, ui.px(8)));
    const bool open = ImGui::BeginMenu((label + "###" + menu.id).c_str());
    if (open) {
      entries(ui, menu, session, layout, actions);
      ImGui::EndMenu();
    }
    ImGui::PopStyleVar();
    end = ImGui::GetCursorScreenPos().x - ImGui::GetStyle().ItemSpacing.x;
    ui.menu(menu.id, {begin, corner.y, end - begin, height}, label, true, open);
  }
  ImGui::PopStyleVar();
  const Rect row{corner.x, corner.y + height, width, below};
  if (below > 0.0f) ImGui::PushClipRect({row.x, row.y}, {row.right(), row.bottom()}, false);
  outputLine(ui, {end, corner.y, corner.x + width - end, height}, row, session, output);
  if (below > 0.0f) ImGui::PopClipRect();
  ImGui::EndMenuBar();
  return below;
}

}  // namespace vides
