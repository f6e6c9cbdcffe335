// SPDX-License-Identifier: MIT
// Windows over the editor: the question that must be answered, how many keys, the shortcuts.
#include "panels/windows.hpp"

#include <algorithm>

#include "edit/command_table.hpp"
#include "panels/flight_window.hpp"
#include "panels/frames_window.hpp"
#include "panels/help_window.hpp"
#include "panels/window_frame.hpp"

namespace vides {
namespace {

// Whether a window is the one that takes the keyboard.
bool isTop(const Session& session, std::string_view name) {
  return !session.question() && session.windows().back() == name;
}

// How many keys `Pos ++` inserts: one click.
void insertKeys(Ui& ui, const Session& session, Actions& actions) {
  constexpr int kMost = 10;
  const bool top = isTop(session, "insert-keys");
  const WindowFrame frame{"###insert-keys", 420.0f, 132.0f, ui.words("position.how-many"), top};
  windowFrame(ui, frame, [&](const Rect& room) {
    const std::vector<Rect> counts = split(ui, {room.x, room.y, room.width, ui.px(26)}, kMost);
    for (int i = 1; i <= kMost; ++i) {
      const std::string number = std::to_string(i);
      if (ui.button("position/insert_" + number, counts[static_cast<std::size_t>(i - 1)], number,
                    {})) {
        actions.run(Command("close-window", "insert-keys"));
        actions.run(Command("insert-keys", i));
      }
    }
    const float width = ui.px(110);
    if (ui.button("position/insert_cancel",
                  {room.right() - width, room.bottom() - ui.px(26), width, ui.px(26)})) {
      actions.run(Command("close-window", "insert-keys"));
    }
  });
}

// What Enter answers: what loses nothing.
std::string_view answerOfEnter(const Question& asked) {
  switch (asked.kind) {
    case Question::Kind::kUnsaved:
    case Question::Kind::kOutsideCube:
    case Question::Kind::kRecover:
      return asked.choices.front();
    case Question::Kind::kChangedOnDisk:
    case Question::Kind::kFramesExist:
    case Question::Kind::kWritingFrames:
      return "cancel";
  }
  return "cancel";
}

void question(Ui& ui, const Session& session, Actions& actions) {
  const Question& asked = *session.question();
  const std::string words = ui.tell(asked.text);
  const auto count = static_cast<int>(asked.choices.size());
  const float wanted = ui.textWidth(words, Weight::kSemibold) / ui.scale() + 40.0f;
  windowFrame(
      ui,
      {"###question", std::clamp(wanted, 380.0f, 900.0f), 100.0f, words, true, true, true, 380.0f},
      [&](const Rect& room) {
        const Rect row{room.x, room.bottom() - ui.px(26), room.width, ui.px(26)};
        const std::vector<Rect> places = split(ui, row, count, 8.0f);
        for (std::size_t i = 0; i < asked.choices.size(); ++i) {
          const bool enter = asked.choices[i] == answerOfEnter(asked);
          const bool clicked = ui.button("question/" + asked.choices[i], places[i],
                                         ui.words("answer." + asked.choices[i]), {.enter = enter});
          if (clicked || (enter && ui.enterPressed())) {
            actions.run(Command("answer", asked.choices[i]));
          }
        }
      });
}

}  // namespace

bool hasWindow(std::string_view name) {
  constexpr std::string_view kWindows[] = {"shape",    "speed",     "flight",     "frames",
                                           "settings", "shortcuts", "insert-keys"};
  return isChooser(name) ||
         std::find(std::begin(kWindows), std::end(kWindows), name) != std::end(kWindows);
}

bool canRun(const Session& session, std::string_view commandLine) {
  const std::string_view name = commandLine.substr(0, commandLine.find(' '));
  if (findCommand(name) == nullptr || !session.available(name)) return false;
  // Commands that ask for a file open the chooser.
  if (commandLine == "open" || commandLine == "import-scene" || commandLine == "save-as" ||
      commandLine == "load-setup" || commandLine == "save-setup") {
    return hasWindow("chooser-open");
  }
  if (commandLine == "save" && session.path().empty()) return hasWindow("chooser-save");
  return name != "show-window" || hasWindow(commandLine.substr(name.size() + 1));
}

void windows(Ui& ui, const Session& session, const Texts& texts, WindowsMemory& memory,
             Actions& actions) {
  if (session.windowOpen("speed")) speedWindow(ui, session, memory.speed, actions);
  if (session.windowOpen("shape")) shapeWindow(ui, session, memory.shape, actions);
  if (session.windowOpen("flight")) flightWindow(ui, session, memory.flight, actions);
  if (session.windowOpen("frames")) framesWindow(ui, session, memory.frames, actions);
  if (session.windowOpen("insert-keys")) insertKeys(ui, session, actions);
  if (session.windowOpen("shortcuts")) helpWindow(ui, session, texts, actions);
  if (session.windowOpen("settings")) settingsWindow(ui, session, memory.settings, actions);
  chooser(ui, session, memory.chooser, actions);
  if (session.question()) question(ui, session, actions);
}

}  // namespace vides
