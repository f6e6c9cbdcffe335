// SPDX-License-Identifier: MIT
// Draws the note about an import.
#include "panels/import_note.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edit/scene_edits.hpp"
#include "panels/axis_picture.hpp"

namespace vides {
namespace {

constexpr float kWidth = 476.0f;
constexpr float kNarrow = 268.0f;
constexpr float kRow = 26.0f;
constexpr float kPad = 10.0f;

// As it is, or the first of its shorter forms that has room.
std::string fitting(const Ui& ui, Text text, float room) {
  std::string words = ui.tell(text);
  const std::string key = text.key;
  for (const char* form : {"#short", "#shorter"}) {
    if (ui.textWidth(words) <= room || ui.words(key + form).empty()) break;
    text.key = key + form;
    words = ui.tell(text);
  }
  return words;
}

void axes(Ui& ui, const Rect& row, const ImportNote& note, UpAxis now, Actions& actions) {
  const std::vector<Rect> boxes = split(ui, row, static_cast<int>(kUpAxes.size()));
  ui.choice("import/up", row, name(now));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::string axis(name(kUpAxes[i]));
    const Rect& box = boxes[i];
    const float picture = box.width >= ui.px(40) ? ui.px(20) : 0.0f;
    const std::string id = "import/up_" + axis;
    const ButtonStyle style{.on = kUpAxes[i] == now,
                            .toggle = true,
                            .tooltip = ui.words("tip/import/up"),
                            .label = axisWords(kUpAxes[i])};
    if (ui.pictureButton(id, box, style)) {
      actions.run(Command("set-scene-up", note.scene, axis));
    }
    const float left = box.x + (box.width - picture - ui.px(14)) / 2;
    if (picture > 0.0f) axisPicture(ui, {left, box.y, picture, box.height}, kUpAxes[i]);
    ui.text({left + picture, box.y, ui.px(16), box.height}, style.label,
            {.weight = style.on ? Weight::kSemibold : Weight::kRegular, .align = Align::kCentre});
  }
}

}  // namespace

void importNote(Ui& ui, const Rect& viewport, float top, const Session& session, Actions& actions) {
  if (!session.importNote()) return;
  const ImportNote& note = *session.importNote();
  const float width = std::min(ui.px(kWidth), viewport.width - ui.px(16));
  const bool wide = width >= ui.px(kWidth) - 1.0f;
  const float pad = ui.px(kPad);
  const float notes = note.notes.empty() ? 0.0f : 18.0f;
  const float height = ui.px((wide ? 82.0f : 110.0f) + notes);
  const Rect box{std::round(viewport.centreX() - width / 2), viewport.y + top, width, height};
  if (width < ui.px(kNarrow) || box.bottom() > viewport.bottom()) return;
  ui.fill(box, ColourRole::kPanel, 6.0f, 0.96);
  ui.outline(box, ColourRole::kEdge, 6.0f);
  Stack rows(ui, box.x + pad, box.y + ui.px(6), width - 2 * pad);
  const Rect first = rows.row(20);
  const Rect close{first.right() - ui.px(20), first.y, ui.px(20), ui.px(20)};
  ui.text({first.x, first.y, close.x - first.x - pad, first.height}, note.name,
          {.weight = Weight::kSemibold, .mayShorten = true});
  if (ui.iconButton("import/close", close, Icon::kClose,
                    {.quiet = true, .tooltip = ui.words("import/close")})) {
    actions.run(Command("dismiss-import"));
  }
  const Rect second = rows.row(18);
  ui.text(second, fitting(ui, Text("import.content", {note.content, note.size}), second.width),
          {.colour = ColourRole::kTextSecondary, .mayShorten = true});
  if (notes > 0.0f) {
    ui.text(rows.row(notes), ui.tell(note.notes),
            {.colour = ColourRole::kTextSecondary, .mayShorten = true});
  }
  rows.gap(4);
  const UpAxis now = session.flight().scene[note.scene].up;
  const std::string up = ui.words("import/up");
  const Rect row = rows.row(kRow);
  const float label = std::ceil(ui.textWidth(up) + ui.px(8));
  const float fly = std::max(ui.px(96), ui.textWidth(ui.words("import/fly_round")) + ui.px(16));
  ui.text({row.x, row.y, label, row.height}, up, {.colour = ColourRole::kTextSecondary});
  const float right = wide ? row.right() - fly - ui.px(12) : row.right();
  axes(ui, {row.x + label, row.y, right - row.x - label, row.height}, note, now, actions);
  if (!wide) rows.gap(4);
  const Rect last = wide ? row : rows.row(kRow - 2);
  if (ui.button("import/fly_round", {last.right() - fly, last.y, fly, last.height})) {
    actions.run(Command("fit-space", kFlyRoundShare));
  }
  // What is under it is out of reach.
  ui.area("import/note", box, note.name, false);
}

}  // namespace vides
