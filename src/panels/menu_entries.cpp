// SPDX-License-Identifier: MIT
// The table of the menus.
#include "panels/menu_entries.hpp"

#include <utility>

#include "panels/file_names.hpp"
#include "panels/windows.hpp"

namespace vides {
namespace {

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

MenuItem itemOf(const Ui& ui, const MenuEntry& item, const Session& session, const Layout& layout) {
  if (item.id.empty()) return {};
  const bool isLayout = item.command.empty();
  const bool nothingToDo = item.command == "revert" && !session.differsFromFile();
  MenuItem made{{item.id, labelOf(ui, session, item.id)}, {}, item.command, {}};
  made.row.enabled = isLayout || (canRun(session, item.command) && !nothingToDo);
  if (item.id == "menu/file/recent") {
    made.row.enabled = !session.recentFiles().empty();
    made.row.opens = true;
  } else {
    made.style.on = ticked(item.id, session, layout);
    if (!isLayout) made.style.keys = ui.hint(item.command);
  }
  return made;
}

}  // namespace

std::vector<MenuItem> itemsOf(const Ui& ui, const Menu& menu, const Session& session,
                              const Layout& layout) {
  std::vector<MenuItem> items;
  for (const MenuEntry& item : menu.entries) {
    items.push_back(itemOf(ui, item, session, layout));
  }
  return items;
}

std::vector<MenuItem> recentItems(Ui& ui, const Session& session) {
  std::vector<MenuItem> items;
  for (const std::string& file : session.recentFiles()) {
    const std::string id = "menu/file/recent_" + std::to_string(items.size());
    items.push_back({{id, shownName(ui, file)}, {}, {}, Command("open", file)});
  }
  return items;
}

void choose(const MenuItem& item, const Layout& layout, Actions& actions) {
  actions.menu = std::string();
  if (item.recent) return actions.run(*item.recent);
  if (layoutEntry(item.row.id, layout, actions)) return;
  if (auto command = parseCommand(item.command)) actions.run(std::move(*command));
}

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
        {"menu/file/scene", "show-window scene"},
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

}  // namespace vides
