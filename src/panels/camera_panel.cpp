// SPDX-License-Identifier: MIT
// What the camera sees at the playhead.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/left_panels.hpp"
#include "panels/right_panels.hpp"

namespace vides {

Rect cameraPanel(Ui& ui, Stack& column, const Session& session, Actions& actions) {
  Rect picture;
  const float top = column.y();
  panel(ui, column, session.view().swapped ? "panel/viewport" : "panel/camera", [&](Stack& rows) {
    const PictureFormat& format = session.flight().picture;
    // The flight's format, but never higher than wide: the column has other panels, too.
    const double proportion = static_cast<double>(format.height) / format.width;
    const double height = rows.width() * std::clamp(proportion, 0.2, 0.75);
    picture = rows.row(static_cast<float>(std::round(height / ui.scale())));
    ui.fill(picture, ColourRole::kPicture);
    if (!session.freeCamera()) return;
    rows.gap(6);
    const auto row = split(ui, rows.row(22), 2);
    commandButton(ui, "camera/use", row[0], "use-view", session, actions);
    commandButton(ui, "camera/new_key", row[1], "new-key-from-view", session, actions);
  });
  // Right of the heading: which frame, or that the camera was flown away from it.
  const Rect heading{column.x() + ui.px(8), top + ui.px(4), column.width() - ui.px(16), ui.px(24)};
  const bool flown = session.freeCamera().has_value();
  ui.text(
      heading,
      flown ? ui.words("camera/free") : fmt::format("{} {}", ui.words("frame"), session.frame()),
      {.colour = ColourRole::kTextSecondary, .align = Align::kRight});
  return picture;
}

}  // namespace vides
