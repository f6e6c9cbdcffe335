// SPDX-License-Identifier: MIT
// What all scripts of tests/scripts together operated is everything that there is to operate.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "app/drive/widget_list.hpp"
#include "edit/command_table.hpp"
#include "edit/shortcuts.hpp"
#include "host/open_host.hpp"

namespace vides {
namespace {

using Lines = std::set<std::string>;

// What each script wrote down, in a folder of its own.
Lines operatedByScripts() {
  Lines all;
  for (const auto& folder : std::filesystem::directory_iterator(VIDES_SCRIPT_FOLDERS)) {
    std::ifstream file(folder.path() / "operated.txt");
    for (std::string line; std::getline(file, line);) all.insert(line);
  }
  return all;
}

// Nothing that a script can operate: it says something only, or it waits for what this build lacks,
// or for what can't happen between two lines: a crash before the start, frames or scenes that
// are still at work, another program that changes the file (the tests of edit/ and kept_test do
// those).
bool restsAlways(const Widget& widget) {
  constexpr std::string_view kNever[] = {"menu/output/host", "question/recover", "question/forget",
                                         "question/later",   "question/stop",    "question/save-as",
                                         "view/stop_reading"};
  return widget.kind == WidgetKind::kText ||
         std::find(std::begin(kNever), std::end(kNever), widget.id) != std::end(kNever);
}

// Files in a list are as many as there are in the folder; the first stands for all.
std::string widgetName(const std::string& id) {
  return "widget " + (id.starts_with("chooser/file_") ? "chooser/file_0" : id);
}

Lines registered() {
  Lines all;
  for (const CommandSpecification& command : commandTable()) all.insert("command " + command.name);
  // Scripts wait for what is written and read: between two lines there is nothing to cancel.
  all.erase("command cancel-frames");
  all.erase("command cancel-reading");
  for (const Shortcut& shortcut : shortcutTable()) all.insert("shortcut " + scriptName(shortcut));
  const auto host = openOffscreen(OffscreenKind::kOsmesa, {});
  EXPECT_TRUE(host);
  const auto player = Player::create(**host);
  EXPECT_TRUE(player);
  for (const auto& [id, widget] : allWidgets(**player)) {
    if (!restsAlways(widget)) all.insert(widgetName(id));
  }
  return all;
}

std::string missing(const Lines& wanted, const Lines& there) {
  std::string text;
  for (const std::string& line : wanted) {
    if (!there.contains(line)) text += "  " + line + "\n";
  }
  return text;
}

TEST(Scripts, OperateEverythingThatIsRegistered) {
  const Lines operated = operatedByScripts();
  ASSERT_FALSE(operated.empty()) << "the scripts have not run: " << VIDES_SCRIPT_FOLDERS;
  const std::string left = missing(registered(), operated);
  EXPECT_TRUE(left.empty()) << "registered, but operated by no script:\n" << left;
}

}  // namespace
}  // namespace vides
