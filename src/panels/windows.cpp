// SPDX-License-Identifier: MIT
// Windows over the editor: the question that must be answered, the list of shortcuts.
#include "panels/windows.hpp"

#include <algorithm>
#include <cmath>

#include "edit/command_table.hpp"
#include "edit/shortcuts.hpp"

namespace vides {
namespace {

// In the middle of the screen, with a heading; `content` draws into what is left.
void window(Ui& ui, const char* id, float width, float height, const std::string& heading,
            const std::function<void(const Rect&)>& content) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float w = std::min(ui.px(width), screen.x);
  const float h = std::min(ui.px(height), screen.y);
  ImGui::SetNextWindowPos({std::round((screen.x - w) / 2), std::round((screen.y - h) / 2)});
  ImGui::SetNextWindowSize({w, h});
  ImGui::SetNextWindowFocus();
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
  const ImVec2 corner = ImGui::GetWindowPos();
  const Rect all{corner.x, corner.y, w, h};
  ui.outline(all, ColourRole::kBorder, 6.0f);
  const Rect inner = all.inset(ui.px(16));
  ui.text({inner.x, inner.y, inner.width, ui.px(24)}, heading, {.weight = Weight::kSemibold});
  content({inner.x, inner.y + ui.px(32), inner.width, inner.height - ui.px(32)});
  ImGui::End();
}

void question(Ui& ui, const Session& session, Actions& actions) {
  const Question& asked = *session.question();
  const std::string words = ui.tell(asked.text);
  const auto count = static_cast<int>(asked.choices.size());
  const float wanted = ui.textWidth(words, Weight::kSemibold) / ui.scale() + 40.0f;
  window(ui, "###question", std::clamp(wanted, 380.0f, 900.0f), 100.0f, words,
         [&](const Rect& room) {
           const Rect row{room.x, room.bottom() - ui.px(26), room.width, ui.px(26)};
           const std::vector<Rect> places = split(ui, row, count, 8.0f);
           for (std::size_t i = 0; i < asked.choices.size(); ++i) {
             if (ui.button("question/" + asked.choices[i], places[i],
                           ui.words("answer." + asked.choices[i]), {})) {
               actions.run(Command("answer", asked.choices[i]));
             }
           }
         });
}

void shortcuts(Ui& ui, const Texts& texts, Actions& actions) {
  const auto& table = shortcutTable();
  constexpr float kRow = 20.0f;
  const std::size_t half = (table.size() + 1) / 2;
  const float height = kRow * static_cast<float>(half) + 110.0f;
  window(ui, "###shortcuts", 860.0f, height, ui.words("menu/help/shortcuts"),
         [&](const Rect& room) {
           const std::vector<Rect> columns = split(ui, room, 2, 32.0f);
           for (std::size_t i = 0; i < table.size(); ++i) {
             const Rect& column = columns[i / half];
             const float y = column.y + ui.px(kRow) * static_cast<float>(i % half);
             const std::string keys = shown(table[i], texts);
             const float width = ui.textWidth(keys, Weight::kSemibold);
             ui.text({column.x, y, column.width - width - ui.px(8), ui.px(kRow)},
                     texts.tell(titleOf(table[i].command, texts)),
                     {.colour = ColourRole::kTextSecondary, .mayShorten = true});
             ui.text({column.right() - width, y, width, ui.px(kRow)}, keys,
                     {.weight = Weight::kSemibold, .align = Align::kRight});
           }
           const float width = ui.px(110);
           if (ui.button("shortcuts/close",
                         {room.right() - width, room.bottom() - ui.px(26), width, ui.px(26)})) {
             actions.run(Command("close-window", "shortcuts"));
           }
         });
}

}  // namespace

bool hasWindow(std::string_view name) { return name == "shortcuts"; }

bool canRun(const Session& session, std::string_view commandLine) {
  const std::string_view name = commandLine.substr(0, commandLine.find(' '));
  if (findCommand(name) == nullptr || !session.available(name)) return false;
  // Commands that ask for a file open the chooser.
  if (commandLine == "open" || commandLine == "import-scene" || commandLine == "save-as") {
    return hasWindow("chooser-open");
  }
  if (commandLine == "save" && session.path().empty()) return hasWindow("chooser-save");
  return name != "show-window" || hasWindow(commandLine.substr(name.size() + 1));
}

void windows(Ui& ui, const Session& session, const Texts& texts, Actions& actions) {
  if (session.windowOpen("shortcuts")) shortcuts(ui, texts, actions);
  if (session.question()) question(ui, session, actions);
}

}  // namespace vides
