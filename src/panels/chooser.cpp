// SPDX-License-Identifier: MIT
// The file chooser.
#include "panels/chooser.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <system_error>

#include "flight/printable.hpp"

#include "panels/chooser_list.hpp"
#include "panels/file_names.hpp"
#include "panels/window_frame.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;
using Mode = ChooserMemory::Mode;

constexpr float kRow = 24.0f;

constexpr std::string_view kFlights[] = {".vid"};
constexpr std::string_view kScenes[] = {".obj"};
constexpr std::string_view kSetups[] = {".json"};
constexpr std::string_view kFrames[] = {".txt", ".csv", ".json", ".chan"};

// What can be chosen, and what happens to it.
struct Kind {
  std::string_view window;
  const char* command;
  const char* heading;
  const char* verb;
  std::span<const std::string_view> endings;
  bool saves = false;     // a new name may be given
  bool endsIt = true;     // an ending that was left out is put there
  const char* name = "";  // to begin with
  bool asks = true;       // before an existing file is given as a new name
  const char* more = "";  // of the command, after the file
};
constexpr Kind kKinds[] = {
    {"chooser-open", "open", "chooser.heading.open", "chooser.open", kFlights},
    {"chooser-save", "save-as", "chooser.heading.save", "answer.save", kFlights, true},
    {"chooser-import", "import-scene", "chooser.heading.import", "chooser.import", kScenes, false,
     false, "", true, "ask"},
    {"chooser-find", "replace-scene", "chooser.heading.find", "chooser.choose", kScenes, false,
     false},
    {"chooser-setup", "load-setup", "chooser.heading.setup", "chooser.load", kSetups},
    {"chooser-save-setup", "save-setup", "chooser.heading.save-setup", "answer.save", kSetups, true,
     true, "setup.json"},
    // Only when they are written is a file overwritten, and asked about.
    {"chooser-frames", "frames-file", "chooser.heading.frames", "chooser.choose", kFrames, true,
     false, "", false},
};

const Kind& kindOf(std::string_view window) {
  const auto found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                  [&](const Kind& kind) { return kind.window == window; });
  return found == std::end(kKinds) ? kKinds[0] : *found;
}

bool pressed(ImGuiKey key, bool repeats = false) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeats);
}

const Kind& kindOf(const ChooserMemory& memory) { return kindOf(memory.window); }
bool saves(const ChooserMemory& memory) { return kindOf(memory).saves; }

void rename(ChooserMemory& memory, std::string name) {
  memory.name = std::move(name);
  memory.rewritten = true;
}

// "*.txt *.csv": what can be chosen.
std::string filterOf(const Kind& kind) {
  std::string filter;
  for (const std::string_view ending : kind.endings) {
    if (!filter.empty()) filter += ' ';
    filter.append("*").append(ending);
  }
  return filter;
}

void enter(ChooserMemory& memory, const fs::path& folder) {
  const auto read = readFolder(folder, memory.filter, memory.order);
  if (!read) {
    memory.trouble = printable(folder.string()) + ": " + read.error();
    return;
  }
  memory.trouble.clear();
  memory.entries = *read;
  memory.selected = -1;
  fs::path plain = folder.lexically_normal();
  if (!plain.has_filename() && plain.has_relative_path()) plain = plain.parent_path();
  memory.folder = plain;
  if (!saves(memory)) rename(memory, "");
}

// The flight's folder, else the last one, else the one that the program was started in.
void begin(Ui& ui, const Session& session, ChooserMemory& memory, const std::string& window) {
  std::error_code error;
  fs::path folder = memory.folder;
  if (!session.path().empty()) folder = fs::absolute(session.path(), error).parent_path();
  if (folder.empty() || !fs::is_directory(folder, error)) folder = fs::current_path(error);
  if (folder.empty()) folder = homeFolder();  // the working directory is gone
  if (folder.empty()) folder = "/";
  const FolderOrder order = memory.order;
  memory = ChooserMemory();
  memory.window = window;
  memory.order = order;
  memory.filter = filterOf(kindOf(memory));
  memory.before = session.output();
  if (window == "chooser-find") memory.scene = session.soughtScene();
  if (*kindOf(memory).name != '\0') {
    rename(memory, kindOf(memory).name);
  } else if (window == "chooser-frames") {
    rename(memory, fileName(session.framesFile()));
  } else if (saves(memory)) {
    const std::string file = fileName(session.path());
    rename(memory, file.empty() ? ui.words("title.untitled") + ".vid" : file);
  }
  memory.folder = folder;
  enter(memory, folder);
}

void choose(ChooserMemory& memory, const fs::path& file, Actions& actions) {
  memory.mode = Mode::kChoose;
  const Kind& kind = kindOf(memory);
  Command command(kind.command);
  if (memory.scene) command.add(*memory.scene);
  command.add(file.string());
  if (*kind.more != '\0') command.add(kind.more);
  actions.run(std::move(command));
}

void createFolder(ChooserMemory& memory) {
  std::error_code error;
  const fs::path folder = typedPath(memory.folder, memory.name);
  fs::create_directory(folder, error);
  if (error) {
    memory.trouble = printable(folder.string()) + ": " + error.message();
    return;
  }
  memory.mode = Mode::kChoose;
  rename(memory, memory.nameBefore);
  enter(memory, folder);
}

void accept(Ui& ui, ChooserMemory& memory, Actions& actions) {
  memory.trouble.clear();
  memory.before = {};
  if (memory.mode == Mode::kOverwrite) return choose(memory, memory.overwrites, actions);
  if (memory.mode == Mode::kNameFolder) return createFolder(memory);
  fs::path file = typedPath(memory.folder, memory.name);
  if (memory.selected >= 0) {
    const FolderEntry& entry = memory.entries[static_cast<std::size_t>(memory.selected)];
    if (entry.folder) return enter(memory, memory.folder / entry.name);
    file = memory.folder / entry.name;  // what is chosen means itself, also "~"
  }
  if (memory.name.empty()) return;
  std::error_code error;
  if (fs::is_directory(file, error)) return enter(memory, file);
  const std::string_view ending = kindOf(memory).endings.front();
  if (saves(memory)) {
    if (kindOf(memory).endsIt && !file.string().ends_with(ending)) file += ending;
    if (!kindOf(memory).asks || !fs::exists(fs::symlink_status(file, error)))
      return choose(memory, file, actions);
    memory.mode = Mode::kOverwrite;
    memory.overwrites = file.string();
    return;
  }
  if (!fs::exists(file, error) && kindOf(memory).endsIt) {
    const fs::path ended = file.string() + std::string(ending);
    if (fs::exists(ended, error)) file = ended;
  }
  if (fs::exists(file, error)) return choose(memory, file, actions);
  memory.trouble = ui.tell(Text("chooser.missing", {file.string()}));
}

void giveUp(ChooserMemory& memory, Actions& actions) {
  if (memory.mode == Mode::kChoose) {
    actions.run(Command("close-window", memory.window));
    return;
  }
  if (memory.mode == Mode::kNameFolder) rename(memory, memory.nameBefore);
  memory.mode = Mode::kChoose;
  memory.trouble.clear();
}

void select(ChooserMemory& memory, int index) {
  memory.selected = index;
  memory.mode = Mode::kChoose;
  const FolderEntry& entry = memory.entries[static_cast<std::size_t>(index)];
  if (!entry.folder) rename(memory, entry.name);
}

void keys(Ui& ui, ChooserMemory& memory, Actions& actions) {
  if (pressed(ImGuiKey_Escape)) return giveUp(memory, actions);
  // Enter overwrites nothing.
  if (ui.enterPressed()) {
    return memory.mode == Mode::kOverwrite ? giveUp(memory, actions) : accept(ui, memory, actions);
  }
  const int last = static_cast<int>(memory.entries.size()) - 1;
  if (memory.mode != Mode::kChoose || last < 0) return;
  const int step =
      (pressed(ImGuiKey_DownArrow, true) ? 1 : 0) - (pressed(ImGuiKey_UpArrow, true) ? 1 : 0);
  if (step == 0) return;
  select(memory, std::clamp(memory.selected + step, 0, last));
  memory.reveal = true;
}

void places(Ui& ui, const Rect& row, const Session& session, ChooserMemory& memory) {
  constexpr const char* kIds[] = {"chooser/up", "chooser/home", "chooser/current", "chooser/flight",
                                  "chooser/new_folder"};
  std::vector<std::string> labels;
  for (const char* id : kIds) labels.push_back(ui.words(id));
  const std::vector<Rect> boxes = splitFor(ui, row, labels);
  std::error_code error;
  const fs::path flight =
      session.path().empty() ? fs::path() : fs::absolute(session.path(), error).parent_path();
  const struct {
    const char* id;
    fs::path folder;
  } all[] = {{"chooser/up", memory.folder.parent_path()},
             {"chooser/home", homeFolder()},
             {"chooser/current", fs::current_path(error)},
             {"chooser/flight", flight}};
  for (std::size_t i = 0; i < std::size(all); ++i) {
    if (ui.button(all[i].id, boxes[i], {.enabled = !all[i].folder.empty()})) {
      memory.mode = Mode::kChoose;
      enter(memory, all[i].folder);
    }
  }
  if (ui.button("chooser/new_folder", boxes[4], ButtonStyle{}) && memory.mode == Mode::kChoose) {
    memory.mode = Mode::kNameFolder;
    memory.nameBefore = memory.name;
    rename(memory, "");
  }
}

// Labels of fields stand in one column.
float labelColumn(const Ui& ui) {
  float width = 0.0f;
  for (const char* label : {"chooser/folder", "chooser/name", "chooser/folder_name"}) {
    width = std::max(width, ui.textWidth(ui.words(label)));
  }
  return std::ceil(width + ui.px(8));
}

// Where one is, which can be typed, and which files of it the list shows.
void folderAndFilter(Ui& ui, const Rect& row, ChooserMemory& memory) {
  const std::string folder = ui.words("chooser/folder"), filter = ui.words("chooser/filter");
  const float gap = ui.px(8), filterWidth = std::round(row.width * 0.24f);
  const float folderLabel = labelColumn(ui);
  const float filterLabel = std::ceil(ui.textWidth(filter) + gap);
  const Rect patterns{row.right() - filterWidth, row.y, filterWidth, row.height};
  const Rect path{row.x + folderLabel, row.y,
                  patterns.x - filterLabel - 2 * gap - row.x - folderLabel, row.height};
  ui.text({row.x, row.y, folderLabel, row.height}, folder, {.colour = ColourRole::kTextSecondary});
  ui.text({patterns.x - filterLabel, row.y, filterLabel, row.height}, filter,
          {.colour = ColourRole::kTextSecondary});
  if (const auto typed = ui.textField("chooser/folder", path, memory.folder.string(), true)) {
    memory.mode = Mode::kChoose;
    enter(memory, typedPath(memory.folder, *typed));
  }
  if (const auto typed = ui.textField("chooser/filter", patterns, memory.filter)) {
    memory.mode = Mode::kChoose;
    memory.filter = *typed;
    enter(memory, memory.folder);
  }
}

// Unless another widget has the keyboard.
bool takesName(Ui& ui) {
  const std::string& focused = ui.memory().focus.widget();
  return ui.memory().editing.empty() && (focused.empty() || focused == "chooser/name");
}

void nameField(Ui& ui, const Rect& row, bool takesText, ChooserMemory& memory) {
  const bool folder = memory.mode == Mode::kNameFolder;
  const std::string label = ui.words(folder ? "chooser/folder_name" : "chooser/name");
  const float labelWidth = labelColumn(ui);
  ui.text({row.x, row.y, labelWidth, row.height}, label, {.colour = ColourRole::kTextSecondary});
  const Rect box{row.x + labelWidth, row.y, row.width - labelWidth, row.height};
  ui.fill(box, ColourRole::kField, 3.0f);
  ui.edge(box);
  ui.entry("chooser/name", box, label, memory.name);
  if (!takesText || memory.mode == Mode::kOverwrite) {
    ui.text({box.x + ui.px(6), box.y, box.width - ui.px(12), box.height},
            shownName(ui, memory.name), {.mayShorten = true});
    return;
  }
  std::array<char, 4096> buffer{};
  WideCharacters& wide = ui.memory().wide;
  wide.foldedName(memory.name).copy(buffer.data(), buffer.size() - 1);
  const float vertical = std::floor((box.height - ui.font(Weight::kRegular)->FontSize) / 2.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(6), vertical));
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::PushItemWidth(box.width);
  // While it takes text it keeps its own copy: another name has to begin anew.
  if (memory.rewritten) ImGui::ClearActiveID();
  if (!memory.rewritten && !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  memory.rewritten = false;
  if (ImGui::InputText("###chooser/name/typing", buffer.data(), buffer.size(),
                       ImGuiInputTextFlags_AutoSelectAll)) {
    std::string name = wide.unfolded(buffer.data());
    if (name != memory.name) {
      memory.name = std::move(name);
      memory.selected = -1;
    }
  }
  ImGui::PopItemWidth();
  ImGui::PopStyleVar();
  ui.outline(box, ColourRole::kText, 3.0f);  // as of every field that is typed into
}

// What is wrong, the question whether to overwrite, or nothing; and the two buttons.
void lastRow(Ui& ui, const Rect& row, const Session& session, ChooserMemory& memory,
             Actions& actions) {
  const std::vector<Rect> places = lastButtons(ui, row, 2);
  const Rect& cancel = places[0];
  const Rect& ok = places[1];
  std::string words = memory.trouble;
  const OutputLine output = session.output();
  const bool wrong = output.kind == MessageKind::kError || output.kind == MessageKind::kRefusal;
  if (words.empty() && wrong && !(output == memory.before)) words = ui.tell(output.text);
  const bool asks = memory.mode == Mode::kOverwrite;
  if (asks) {
    words = ui.tell(Text("chooser.overwrite", {fileName(memory.overwrites)}));
  }
  const TextStyle style{.colour = asks ? ColourRole::kText : ColourRole::kError,
                        .weight = asks ? Weight::kSemibold : Weight::kRegular,
                        .mayShorten = true};
  const Rect room{row.x, row.y, cancel.x - row.x - ui.px(8), row.height};
  // A path may need the height of two lines.
  const std::vector<std::string> lines = wrapped(ui, words, room.width, style.weight);
  if (lines.size() < 2) {
    ui.text(room, words, style);
  } else {
    std::string rest = lines[1];
    for (std::size_t i = 2; i < lines.size(); ++i) rest += " " + lines[i];
    const float line = ui.px(16), top = std::round(room.centreY() - line);
    ui.text({room.x, top, room.width, line}, lines[0], style);
    ui.text({room.x, top + line, room.width, line}, rest, style);
  }
  const char* const verb = asks                               ? "answer.overwrite"
                           : memory.mode == Mode::kNameFolder ? "chooser.create"
                                                              : kindOf(memory).verb;
  const bool named = memory.selected >= 0 || !memory.name.empty();
  if (ui.button("chooser/cancel", cancel, {.enter = asks})) {
    giveUp(memory, actions);
  } else if (ui.button("chooser/ok", ok, ui.words(verb),
                       {.enabled = named, .enter = named && !asks})) {
    accept(ui, memory, actions);
  }
}

}  // namespace

bool isChooser(std::string_view window) { return kindOf(window).window == window; }

void chooser(Ui& ui, const Session& session, ChooserMemory& memory, Actions& actions) {
  const auto& open = session.windows();
  const auto top = std::find_if(open.rbegin(), open.rend(), isChooser);
  if (top == open.rend()) {
    memory.window.clear();
    return;
  }
  if (memory.window != *top) begin(ui, session, memory, *top);
  // Escape that closed a question, and Enter that opened the chooser, are done with.
  const bool asked = session.question().has_value();
  const bool typing = !ui.memory().editing.empty();  // and so are those of a field
  if (!asked && !memory.questionWas && !typing) keys(ui, memory, actions);
  memory.questionWas = asked;
  WindowFrame frame{"###chooser", 680.0f, 520.0f, ui.words(kindOf(memory).heading), !asked};
  frame.modal = true;
  frame.leastWidth = 464.0f;
  frame.leastHeight = 300.0f;
  frame.close = "chooser/close";
  const bool stays = windowFrame(
      ui, frame,
      [&](const Rect& room) {
        Stack rows(ui, room.x, room.y, room.width);
        places(ui, rows.row(kRow), session, memory);
        rows.gap(4);
        folderAndFilter(ui, rows.row(kRow), memory);
        rows.gap(4);
        const float below = ui.px(kRow + 8);
        const Rect box{room.x, rows.y(), room.width, room.bottom() - below - rows.y()};
        const ChooserClick click = chooserList(ui, box, memory);
        if (click.entry >= 0) select(memory, click.entry);
        if (click.twice) accept(ui, memory, actions);
        nameField(ui, {room.x, room.bottom() - ui.px(kRow), room.width, ui.px(kRow)},
                  !asked && takesName(ui), memory);
      },
      [&](const Rect& row) { lastRow(ui, row, session, memory, actions); });
  if (!stays) actions.run(Command("close-window", memory.window));
}

}  // namespace vides
