// SPDX-License-Identifier: MIT
// What the camera sees at the playhead.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/left_panels.hpp"
#include "panels/right_panels.hpp"

namespace vides {
namespace {

constexpr float kRow = 22.0f;

void cameraButtons(Ui& ui, Stack& rows, const Session& session, Actions& actions) {
  const Display& display = session.display();
  auto row = split(ui, rows.row(kRow), 2);
  commandButton(ui, "camera/use_view", row[0], "use-view", session, actions);
  commandButton(ui, "camera/new_key", row[1], "new-key-from-view", session, actions);
  rows.gap(4);
  row = split(ui, rows.row(kRow), 2);
  commandButton(ui, "camera/safe_frames", row[0], "show-element safe-frames", session, actions,
                {.on = display.safeFrames, .toggle = true});
  commandButton(ui, "camera/thirds", row[1], "show-element thirds", session, actions,
                {.on = display.thirds, .toggle = true});
}

}  // namespace

std::string cameraCaption(const Ui& ui, const Session& session) {
  if (const auto& free = session.freeCamera()) {
    return ui.words("camera/zoom") + " " + ui.number(free->zoom, 1);
  }
  return fmt::format("{} {}", ui.words("frame"), session.frame());
}

Rect cameraPanel(Ui& ui, Stack& column, const Session& session, Actions& actions) {
  Rect picture;
  const float top = column.y();
  const bool film = !session.view().swapped;
  panel(ui, column, film ? "panel/camera" : "panel/viewport", [&](Stack& rows) {
    const PictureFormat& format = session.flight().picture;
    // The flight's format, but never higher than wide: the column has other panels, too.
    const double proportion = static_cast<double>(format.height) / format.width;
    const double height = rows.width() * std::clamp(proportion, 0.2, 0.75);
    picture = rows.row(static_cast<float>(std::round(height / ui.scale())));
    ui.fill(picture, ColourRole::kPicture);
    ui.outline({picture.x - 1.0f, picture.y - 1.0f, picture.width + 2.0f, picture.height + 2.0f},
               ColourRole::kTextDisabled, 0.0f, 1.0f);
    if (film) {
      rows.gap(8);
      cameraButtons(ui, rows, session, actions);
    }
  });
  // What the buttons change stands in the middle then.
  const float bottom = column.y();
  if (!film)
    panel(ui, column, "panel/camera",
          [&](Stack& rows) { cameraButtons(ui, rows, session, actions); });
  panelCaption(ui, column, film ? top : bottom, cameraCaption(ui, session));
  return picture;
}

}  // namespace vides
