// SPDX-License-Identifier: MIT
// Draws the list of scenes.
#include "panels/scene_window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edit/folder.hpp"
#include "edit/scene_edits.hpp"
#include "panels/axis_picture.hpp"
#include "panels/left_panels.hpp"

namespace vides {
namespace {

using State = SceneRow::State;

constexpr float kRow = 48.0f;
constexpr float kControl = 24.0f;
constexpr float kAxis = 24.0f;
constexpr float kFind = 76.0f;

std::string idOf(const char* what, std::size_t index) {
  return fmt::format("scene/{}_{}", what, index);
}

// An eye, crossed out where it is shut.
void eyePicture(Ui& ui, const Rect& box, bool open) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = std::round(box.centreX()), y = std::round(box.centreY());
  const float w = ui.px(7), h = ui.px(5), line = 1.4f * ui.scale();
  const ImU32 ink = ui.colour(open ? ColourRole::kText : ColourRole::kTextDisabled);
  list.AddBezierQuadratic({x - w, y}, {x, y - 2 * h}, {x + w, y}, ink, line);
  list.AddBezierQuadratic({x - w, y}, {x, y + 2 * h}, {x + w, y}, ink, line);
  if (open) {
    list.AddCircleFilled({x, y}, 0.42f * w, ink);
  } else {
    list.AddLine({x - w, y + h}, {x + w, y - h}, ink, line);
  }
}

// What a row says of its file, and how.
struct Told {
  std::string words;
  ColourRole colour = ColourRole::kTextSecondary;
};
Told toldOf(const Ui& ui, const SceneRow& row) {
  const std::string content = row.drawable ? ui.tell(contentText(*row.drawable)) : std::string();
  switch (row.state) {
    case State::kHidden:
      return {content.empty() ? ui.words("scene.state.hidden")
                              : ui.tell(Text("scene.state.known", {content}))};
    case State::kWaiting:
      return {ui.words("scene.state.waiting")};
    case State::kReading:
      return {ui.words("scene.state.reading")};
    case State::kStopped:
      return {ui.words("scene.state.stopped")};
    case State::kMissing:
      return {ui.tell(Text("scene.state.missing", {row.path.string()})), ColourRole::kError};
    case State::kRefused:
      return {ui.tell(row.problem), ColourRole::kError};
    case State::kRead:
      break;
  }
  if (row.changedOnDisk) return {ui.words("scene.state.changed"), ColourRole::kText};
  return {ui.tell(
      Text("scene.state.shown", {content, extentText(PlacedScene(row.drawable, row.up).box())}))};
}

void upAxes(Ui& ui, const Rect& box, const SceneRow& row, std::size_t index, Actions& actions) {
  const std::string id = idOf("up", index);
  ui.choice(id, box, name(row.up), ui.words("scene/up"));
  const std::vector<Rect> places = split(ui, box, static_cast<int>(kUpAxes.size()), 2.0f);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string axis(name(kUpAxes[i]));
    const bool on = kUpAxes[i] == row.up;
    const ButtonStyle style{.on = on, .toggle = true, .tooltip = ui.words("tip/scene/up")};
    if (ui.button(id + "_" + axis, places[i], axisWords(kUpAxes[i]), style) && !on) {
      actions.run(Command("set-scene-up", index, axis));
    }
  }
}

void sceneRow(Ui& ui, const Rect& box, const SceneRow& row, std::size_t index, Actions& actions) {
  const float gap = ui.px(8), control = ui.px(kControl);
  const auto square = [&](float x) {
    return Rect{x, std::round(box.centreY() - control / 2), control, control};
  };
  const auto labelled = [&](const char* what) {
    return ButtonStyle{.quiet = true,
                       .tooltip = ui.words(std::string("tip/scene/") + what),
                       .label = ui.words(std::string("scene/") + what)};
  };
  const Rect eye = square(box.x + ui.px(4));
  ButtonStyle shown = labelled("eye");
  shown.toggle = true;
  shown.on = row.visible;
  if (ui.pictureButton(idOf("eye", index), eye, shown)) {
    actions.run(Command("show-scene", index, row.visible ? "off" : "on"));
  }
  eyePicture(ui, eye, row.visible);

  const Rect remove = square(box.right() - ui.px(6) - control);
  if (ui.iconButton(idOf("remove", index), remove, Icon::kClose, labelled("remove"))) {
    actions.run(Command("remove-scene", index));
  }
  const Rect reload = square(remove.x - ui.px(2) - control);
  ButtonStyle again = labelled("reload");
  again.quiet = !row.changedOnDisk;
  if (ui.iconButton(idOf("reload", index), reload, Icon::kLoop, again)) {
    actions.run(Command("reload-scene", index));
  }
  const float axes = 6 * ui.px(kAxis) + 5 * ui.px(2);
  const Rect up{reload.x - gap - axes, reload.y, axes, control};
  upAxes(ui, up, row, index, actions);

  float right = up.x - gap;
  if (row.failed()) {
    const Rect find{right - ui.px(kFind), reload.y, ui.px(kFind), control};
    ButtonStyle style = labelled("find");
    style.quiet = false;
    if (ui.button(idOf("find", index), find, style.label, style)) {
      actions.run(Command("replace-scene", index));
    }
    right = find.x - gap;
  }
  const float left = eye.right() + gap;
  const Rect label{left, box.y + ui.px(5), right - left, ui.px(20)};
  const Rect below{left, box.y + ui.px(24), right - left, ui.px(18)};
  ui.text(label, fileName(row.file),
          {.colour = row.visible ? ColourRole::kText : ColourRole::kTextDisabled,
           .weight = Weight::kSemibold,
           .mayShorten = true});
  const Told told = toldOf(ui, row);
  if (row.state == State::kReading) {
    const float number = ui.px(48);
    const Rect track{below.x, std::round(below.centreY() - ui.px(2)), below.width - number,
                     ui.px(4)};
    const std::string share = progressBar(ui, track, row.share);
    ui.text({track.right(), below.y, number, below.height}, share, {.align = Align::kRight});
  } else {
    ui.text(below, told.words, {.colour = told.colour, .mayShorten = true});
  }
  ui.shows(idOf("file", index), {left, box.y, right - left, box.height}, told.words);
}

void list(Ui& ui, const Rect& box, const std::vector<SceneRow>& rows, Actions& actions) {
  ui.fill(box, ColourRole::kField, 4.0f);
  ui.edge(box);
  if (rows.empty()) {
    float y = box.centreY() - ui.px(20);
    for (const std::string& line : wrapped(ui, ui.words("scene.none"), box.width - ui.px(48))) {
      ui.text({box.x, y, box.width, ui.px(20)}, line,
              {.colour = ColourRole::kTextSecondary, .align = Align::kCentre});
      y += ui.px(20);
    }
    return;
  }
  const float height = ui.px(kRow);
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("###scene/list", {box.width, box.height}, false, ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Rect row{from.x, from.y + static_cast<float>(i) * height, room, height};
    sceneRow(ui, row, rows[i], i, actions);
    const float line = std::max(1.0f, ui.px(1));
    ui.fill({row.x + ui.px(8), row.bottom() - line, row.width - ui.px(16), line},
            ColourRole::kBorder, 0.0f, 0.6);
  }
  ImGui::SetCursorScreenPos(from);
  ImGui::Dummy({1.0f, height * static_cast<float>(rows.size())});
  ImGui::EndChild();
}

void buttons(Ui& ui, const Rect& row, const Session& session, std::size_t count, Actions& actions) {
  const std::vector<Rect> places = lastButtons(ui, row, 2);
  const std::string words = count > 0 ? ui.tell(Text("scene.count", {count})) : std::string();
  const Rect left{row.x, row.y, places[0].x - row.x - ui.px(12), row.height};
  ui.text(left, words, {.colour = ColourRole::kTextSecondary});
  ui.shows("scene/count", left, words);
  if (ui.button("scene/fly_round", places[0], {.enabled = count > 0})) {
    actions.run(Command("fit-space", kFlyRoundShare));
  }
  commandButton(ui, "scene/import", places[1], "import-scene", session, actions);
}

}  // namespace

void sceneWindow(Ui& ui, const Session& session, WindowPlace& place, Actions& actions) {
  const std::vector<SceneRow> rows = session.sceneRows();
  const float wanted =
      130.0f + kRow * static_cast<float>(std::clamp<std::size_t>(rows.size(), 2, 8));
  const FloatingFrame frame{"scene", 600.0f, wanted, ui.words("scene/heading"), {}, {}, 480.0f};
  const bool open = floatingFrame(
      ui, frame, place, [&](const Rect& room) { list(ui, room, rows, actions); },
      [&](const Rect& row) { buttons(ui, row, session, rows.size(), actions); });
  if (!open) actions.run(Command("close-window", "scene"));
}

}  // namespace vides
