// SPDX-License-Identifier: MIT
// Position & curve: keys come, go and are stepped through; where the current one is and its shape.
#include <fmt/format.h>

#include "panels/left_panels.hpp"

namespace vides {
namespace {

constexpr float kRow = 22.0f;

void positionRow(Ui& ui, Stack& rows, const Session& session, Actions& actions) {
  const ThreeColumns columns = threeNumbers(ui, rows);
  ui.text(columns.label, ui.words("position/place"), {.colour = ColourRole::kTextSecondary});
  auto typed = positionFields(ui, "position", columns.values, session, actions);
  if (typed) actions.run(std::move(*typed));
}

void shapeRow(Ui& ui, Stack& rows, const Session& session, std::size_t index, bool current,
              Actions& actions) {
  const ThreeColumns columns = threeNumbers(ui, rows);
  const Key& key = session.flight().keys[index];
  const std::string preset = key.shape.preset == KeyShape::kOwn ? ui.words("position/own")
                                                                : std::to_string(key.shape.preset);
  std::string label = fmt::format("{} {} \u00b7 {}", ui.words("position/key"), index + 1, preset);
  if (ui.textWidth(label) > columns.label.width)
    label = fmt::format("{} \u00b7 {}", index + 1, preset);
  ui.text(columns.label, label, {.colour = ColourRole::kTextSecondary, .mayShorten = true});
  const Shape& shape = shapeOf(session.flight(), key);
  struct Part {
    const char* id;
    const char* nextId;
    const char* letter;
    const char* command;
    double value;
  };
  const Part parts[] = {
      {"position/bias", "position/next_bias", "b", "set-bias", shape.bias},
      {"position/continuity", "position/next_continuity", "c", "set-continuity", shape.continuity},
      {"position/tension", "position/next_tension", "t", "set-tension", shape.tension}};
  for (int i = 0; i < 3; ++i) {
    const Part& part = parts[i];
    // The next key's are shown for comparison; typed at are those of the current one.
    const auto typed = ui.field(
        current ? part.id : part.nextId, columns.values[i], part.value,
        {.decimals = 2, .prefix = part.letter, .readOnly = !current, .weight = Weight::kSemibold});
    actions.typed(typed, [&](double value) { return Command(part.command, value); });
  }
}

}  // namespace

float positionPanelHeight(const Ui& ui, float width) {
  const float numbers = threeNumbersHeight(ui, rowWidth(ui, width));
  return panelHeight(ui) + 3 * (ui.tall(kRow) + numbers) + 4 * ui.tall(4) + ui.tall(6);
}

void positionPanel(Ui& ui, Stack& column, const Session& session, Actions& actions) {
  panel(ui, column, "panel/position", [&](Stack& rows) {
    auto row = splitFor(ui, rows.row(kRow),
                        {ui.words("position/insert"), ui.words("position/insert_many"),
                         ui.words("position/append"), ui.words("position/delete")});
    commandButton(ui, "position/insert", row[0], "insert-key", session, actions);
    commandButton(ui, "position/insert_many", row[1], "show-window insert-keys", session, actions);
    commandButton(ui, "position/append", row[2], "append-key", session, actions);
    commandButton(ui, "position/delete", row[3], "delete-keys", session, actions);
    rows.gap(4);
    row = split(ui, rows.row(kRow), 2);
    commandButton(ui, "position/previous", row[0], "previous-key", session, actions);
    commandButton(ui, "position/next", row[1], "next-key", session, actions);
    rows.gap(6);
    positionRow(ui, rows, session, actions);
    rows.gap(4);
    const std::size_t current = session.current().key;
    shapeRow(ui, rows, session, current, true, actions);
    rows.gap(4);
    // The row stays where there is no next key, empty: nothing moves when the last one is left.
    const std::size_t next = current + 1 == session.flight().keys.size() ? 0 : current + 1;
    if (next > 0 || session.flight().closed) {
      shapeRow(ui, rows, session, next, false, actions);
    } else {
      static_cast<void>(threeNumbers(ui, rows));
    }
    rows.gap(4);
    commandButton(ui, "position/change", rows.row(kRow), "show-window shape", session, actions);
  });
}

}  // namespace vides
