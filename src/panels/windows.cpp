// SPDX-License-Identifier: MIT
// Windows over the editor: the question that must be answered, how many keys, the shortcuts.
#include "panels/windows.hpp"

#include <algorithm>

#include "edit/command_table.hpp"
#include "panels/flight_window.hpp"
#include "panels/frames_window.hpp"
#include "panels/help_window.hpp"
#include "panels/scene_window.hpp"
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
  const std::size_t key = session.current().key;
  const std::size_t next = (key + 1) % session.flight().keys.size();
  WindowFrame frame{"###insert-keys", 420.0f, 120.0f,
                    ui.tell(Text("position.how-many", {key + 1, next + 1})), top};
  frame.wraps = true;
  frame.detail = ui.words("position.how-many.more");
  frame.close = "position/insert_close";
  const auto close = [&] { actions.run(Command("close-window", "insert-keys")); };
  const bool stays = windowFrame(
      ui, frame,
      [&](const Rect& room) {
        const std::vector<Rect> counts =
            split(ui, {room.x, room.y, room.width, ui.px(kWindowButtons)}, kMost);
        for (int i = 1; i <= kMost; ++i) {
          const std::string number = std::to_string(i);
          if (ui.button("position/insert_" + number, counts[static_cast<std::size_t>(i - 1)],
                        number, {})) {
            close();
            actions.run(Command("insert-keys", i));
          }
        }
      },
      [&](const Rect& row) {
        if (ui.button("position/insert_cancel", lastButtons(ui, row, 1)[0])) close();
      });
  if (!stays) close();
}

// What Enter answers: what loses nothing.
std::string_view answerOfEnter(const Question& asked) {
  switch (asked.kind) {
    case Question::Kind::kUnsaved:
    case Question::Kind::kOutsideCube:
    case Question::Kind::kRecover:
    case Question::Kind::kSceneAgain:
    case Question::Kind::kScenesFound:
      return asked.choices.front();
    case Question::Kind::kChangedOnDisk:
    case Question::Kind::kFramesExist:
    case Question::Kind::kWritingFrames:
      return "cancel";
  }
  return "cancel";
}

// What loses something stands apart from the rest; empty where nothing does.
std::string_view losingAnswer(const Question& asked) {
  switch (asked.kind) {
    case Question::Kind::kUnsaved:
      return "discard";
    case Question::Kind::kChangedOnDisk:
    case Question::Kind::kFramesExist:
      return "overwrite";
    case Question::Kind::kRecover:
      return "forget";
    case Question::Kind::kWritingFrames:
      return "stop";
    case Question::Kind::kOutsideCube:
    case Question::Kind::kSceneAgain:
    case Question::Kind::kScenesFound:
      break;
  }
  return {};
}

// The answers from left to right: what loses something, apart from it the rest, of which the one
// that goes on is the last.
struct Answers {
  std::vector<std::string> ids, labels;
  bool apart = false;
};
Answers answersOf(const Ui& ui, const Question& asked) {
  Answers answers;
  const std::string_view losing = losingAnswer(asked);
  for (const std::string& choice : asked.choices) {
    if (choice == losing) {
      answers.ids.push_back(choice);
      answers.apart = true;
    }
  }
  for (auto choice = asked.choices.rbegin(); choice != asked.choices.rend(); ++choice) {
    if (*choice != losing) answers.ids.push_back(*choice);
  }
  for (const std::string& id : answers.ids) answers.labels.push_back(ui.words("answer." + id));
  return answers;
}

constexpr float kBetweenAnswers = 8.0f;
constexpr float kApart = 24.0f;

// Pixels, of the buttons side by side.
std::vector<float> widthsOf(const Ui& ui, const Answers& answers, float& all) {
  std::vector<float> widths;
  all = ui.px(kBetweenAnswers) * static_cast<float>(answers.ids.size() - 1);
  if (answers.apart) all += ui.px(kApart - kBetweenAnswers);
  for (const std::string& label : answers.labels) {
    widths.push_back(std::max(ui.px(kLastButton), ui.textWidth(label) + ui.px(24)));
    all += widths.back();
  }
  return widths;
}

std::vector<Rect> placesOf(const Ui& ui, const Rect& row, const Answers& answers) {
  float all = 0.0f;
  const std::vector<float> widths = widthsOf(ui, answers, all);
  if (all > row.width) return splitFor(ui, row, answers.labels);
  std::vector<Rect> places(widths.size());
  float right = row.right();
  for (std::size_t i = widths.size(); i-- > 0;) {
    if (i == 0 && answers.apart) right = row.x + widths[0];
    places[i] = {right - widths[i], row.y, widths[i], row.height};
    right -= widths[i] + ui.px(kBetweenAnswers);
  }
  return places;
}

void question(Ui& ui, const Session& session, Actions& actions) {
  constexpr float kLeast = 440.0f;
  constexpr float kMost = 560.0f;
  constexpr float kSides = 32.0f;
  const Question& asked = *session.question();
  const Answers answers = answersOf(ui, asked);
  const std::string words = ui.tell(asked.text);
  float buttons = 0.0f;
  widthsOf(ui, answers, buttons);
  const float wanted = std::max(buttons, ui.textWidth(words, Weight::kSemibold)) / ui.scale();
  WindowFrame frame{"###question", std::clamp(wanted + kSides, kLeast, kMost), 94.0f, words, true};
  frame.modal = true;
  frame.wraps = true;
  frame.leastWidth = 1.0f;  // it has no content
  Text more = asked.text;
  more.key += ".more";
  frame.detail = ui.tell(more);
  windowFrame(
      ui, frame, [](const Rect&) {},
      [&](const Rect& row) {
        const std::vector<Rect> places = placesOf(ui, row, answers);
        for (std::size_t i = 0; i < places.size(); ++i) {
          const std::string& id = answers.ids[i];
          const bool enter = id == answerOfEnter(asked);
          const bool clicked =
              ui.button("question/" + id, places[i], answers.labels[i], {.enter = enter});
          if (clicked || (enter && ui.enterPressed())) actions.run(Command("answer", id));
        }
      });
}

}  // namespace

bool hasWindow(std::string_view name) {
  constexpr std::string_view kWindows[] = {"shape",    "speed",     "flight",      "frames",
                                           "settings", "shortcuts", "insert-keys", "scene"};
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
  // One that is asked for, though it was open under others, comes to the front.
  const std::vector<std::string>& open = session.windows();
  if (open != memory.open && open.size() >= memory.open.size() && !open.empty()) {
    ui.memory().focus.raise = open.back();
  }
  memory.open = open;
  if (session.windowOpen("speed")) speedWindow(ui, session, memory.speed, actions);
  if (session.windowOpen("shape")) shapeWindow(ui, session, memory.shape, actions);
  if (session.windowOpen("flight")) flightWindow(ui, session, memory.flight, actions);
  if (session.windowOpen("frames")) framesWindow(ui, session, memory.frames, actions);
  if (session.windowOpen("scene")) sceneWindow(ui, session, memory.scene, actions);
  if (session.windowOpen("insert-keys")) insertKeys(ui, session, actions);
  if (session.windowOpen("shortcuts")) helpWindow(ui, session, texts, actions);
  if (session.windowOpen("settings")) settingsWindow(ui, session, memory.settings, actions);
  chooser(ui, session, memory.chooser, actions);
  if (session.question()) question(ui, session, actions);
  // One that was pressed is on top: it is the first that Escape closes.
  const std::string& front = ui.memory().focus.window();
  if (session.windowOpen(front) && front != open.back()) actions.raise = front;
}

}  // namespace vides
