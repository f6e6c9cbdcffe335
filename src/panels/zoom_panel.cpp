// SPDX-License-Identifier: MIT
// Zoom: the current orientation's, with focal length and horizontal field of view.
#include <cmath>

#include "panels/left_panels.hpp"

namespace vides {
namespace {

constexpr float kFields = 22.0f;
constexpr float kHeadingFields = 20.0f;

// The zoom itself, and what the lens makes of it: either of these can be typed as well.
void lensRow(Ui& ui, const Rect& row, const Session& session, Actions& actions) {
  const std::size_t key = session.current().key;
  const double zoom = session.currentOrientation().zoom;
  const ThreeColumns columns = threeColumns(ui, row);
  ui.text(columns.label,
          differs(ui, session, KeyValue::kZoom) ? std::string("\u2013") : ui.number(zoom, 1),
          {.weight = Weight::kSemibold});
  const Rect rest{columns.values[0].x, row.y, row.right() - columns.values[0].x, row.height};
  const std::vector<Rect> boxes = split(ui, rest, 2);
  const struct {
    const char* id;
    KeyValue which;
    const char* suffix;
    const char* command;
  } all[] = {
      {"zoom/focal_length", KeyValue::kFocalLength, " mm", "set-focal-length"},
      {"zoom/field_of_view", KeyValue::kFieldOfView, "\u00b0", "set-field-of-view"},
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto typed =
        ui.field(all[i].id, boxes[i], valueOf(session.state(), key, all[i].which, Units::kCube),
                 {.decimals = 1,
                  .suffix = all[i].suffix,
                  .weight = Weight::kSemibold,
                  .differs = differs(ui, session, all[i].which)});
    if (typed.value) actions.number(typed, Command(all[i].command, typed.argument()));
  }
}

}  // namespace

float zoomPanelHeight(const Ui& ui, bool low) {
  return panelHeight(ui) + ui.tall(18) + (low ? 0.0f : ui.tall(4) + ui.tall(kFields));
}

void zoomPanel(Ui& ui, Stack& column, float bottom, const Session& session, Actions& actions) {
  const float top = column.y();
  const bool low = top + zoomPanelHeight(ui, false) > bottom + 1.0f &&
                   top + zoomPanelHeight(ui, true) <= bottom + 1.0f;
  panel(ui, column, "panel/zoom", [&](Stack& rows) {
    const double zoom = session.currentOrientation().zoom;
    const auto change = ui.slider("zoom/value", rows.row(18), zoom,
                                  {.least = kMinZoom,
                                   .most = kMaxZoom,
                                   .decimals = 1,
                                   .snap = 5.0,
                                   .differs = differs(ui, session, KeyValue::kZoom)});
    if (change) {
      // Dragged, it goes in tenths: what is shown is what is kept.
      const double tenths = std::round(change->value * 10.0) / 10.0;
      const bool dragged = change->phase == Phase::kPreview;
      actions.during(Command("set-zoom", dragged ? Argument(tenths) : change->argument()),
                     change->phase);
    }
    if (low) {
      // Beside the heading.
      const float width = std::round(column.width() * 0.8f);
      const Rect heading{column.x() + column.width() - ui.px(8) - width, top + ui.tall(4), width,
                         ui.tall(24)};
      lensRow(ui, {heading.x, heading.y + ui.tall(2), width, ui.tall(kHeadingFields)}, session,
              actions);
    } else {
      rows.gap(4);
      lensRow(ui, rows.row(kFields), session, actions);
    }
  });
}

}  // namespace vides
