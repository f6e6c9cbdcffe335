// SPDX-License-Identifier: MIT
// Zoom: the current orientation's, with focal length and horizontal field of view.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "panels/left_panels.hpp"

namespace vides {

float zoomPanelHeight(const Ui& ui, bool low) {
  return panelHeight(ui) + ui.tall(18) + (low ? 0.0f : ui.tall(20));
}

void zoomPanel(Ui& ui, Stack& column, float bottom, const Session& session, Actions& actions) {
  const float top = column.y();
  const bool low = top + zoomPanelHeight(ui, false) > bottom + 1.0f &&
                   top + zoomPanelHeight(ui, true) <= bottom + 1.0f;
  panel(ui, column, "panel/zoom", [&](Stack& rows) {
    const double zoom = session.currentOrientation().zoom;
    const auto change =
        ui.slider("zoom/value", rows.row(18), zoom,
                  {.least = kMinZoom, .most = kMaxZoom, .decimals = 1, .snap = 5.0});
    if (change) {
      // Dragged, it goes in tenths: what is shown is what is kept.
      const double tenths = std::round(change->value * 10.0) / 10.0;
      actions.during(Command("set-zoom", change->phase == Phase::kPreview ? tenths : change->value),
                     change->phase);
    }
    const Lens& lens = session.flight().lens;
    const double angle = lens.horizontalFieldOfView(zoom) * 180.0 / std::numbers::pi;
    const std::string told = fmt::format("{} mm \u00b7 {}\u00b0",
                                         ui.number(lens.focalLength(zoom), 1), ui.number(angle, 1));
    if (low) {
      const std::string both = ui.number(zoom, 1) + " \u00b7 " + told;
      ui.shows("zoom/lens", panelCaption(ui, column, top, both), told);
    } else {
      ui.valueRow(rows.row(20), "zoom/lens", ui.number(zoom, 1), told);
    }
  });
}

}  // namespace vides
