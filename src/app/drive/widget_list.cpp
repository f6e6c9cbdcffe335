// SPDX-License-Identifier: MIT
// Every widget that the editor has.
#include "app/drive/widget_list.hpp"

#include "edit/command_table.hpp"
#include "panels/menu_bar.hpp"

namespace vides {

std::map<std::string, Widget> allWidgets(Player& player) {
  std::map<std::string, Widget> all;
  const auto collect = [&] {
    for (const auto& [id, widget] : player.editor().widgets().widgets()) all[id] = widget;
  };
  // One that is on screen at times only.
  const auto add = [&](const std::string& id, std::string label, WidgetKind kind) {
    Widget& widget = all[id];
    widget.id = id;
    widget.label = std::move(label);
    widget.kind = kind;
  };
  player.frame();
  collect();
  for (const Menu& menu : menus()) {
    for (const MenuEntry& entry : menu.entries) {
      if (entry.id.empty()) continue;
      add(entry.id, player.editor().label(entry.id), WidgetKind::kMenuItem);
    }
  }
  const CommandSpecification* show = findCommand("show-window");
  for (const std::string& window : show->arguments.front().choices) {
    player.perform(Command("show-window", window));
    player.frame();
    collect();
    // What stands on a page of its own.
    const auto shown = player.editor().widgets().widgets();
    for (const auto& [id, widget] : shown) {
      if (!id.starts_with(window + "/page_")) continue;
      player.clickWidget(id);
      player.frame();
      collect();
    }
    player.perform(Command("close-window", window));
  }
  // The row of a scene, here one that is missing.
  player.perform(Command("add-scene", "missing.obj"));
  player.perform(Command("show-window", "scene"));
  player.frame();
  collect();
  player.perform(Command("close-window", "scene"));
  player.perform(Command("undo"));
  for (const UpAxis axis : kUpAxes) {
    add("import/up_" + std::string(name(axis)), std::string(name(axis)), WidgetKind::kToggle);
  }
  add("import/up", player.editor().label("import/up"), WidgetKind::kChoice);
  for (const char* id : {"import/fly_round", "import/close"}) {
    add(id, player.editor().label(id), WidgetKind::kButton);
  }
  // The answers to all questions: which are asked depends on what happened.
  for (const char* answer : {"save", "discard", "cancel", "overwrite", "save-as", "enlarge",
                             "recover", "forget", "later", "stop", "again", "replace"}) {
    add(std::string("question/") + answer,
        player.editor().words(Text(std::string("answer.") + answer)), WidgetKind::kButton);
  }
  for (const char* id : {"view/reading", "view/stop_reading"}) {
    const bool text = std::string_view(id) == "view/reading";
    add(id, player.editor().label(id), text ? WidgetKind::kText : WidgetKind::kButton);
  }
  return all;
}

}  // namespace vides
