// SPDX-License-Identifier: MIT
// The two columns of panels: as much as fits without scrolling, rows closer in a low window.
#include <imgui.h>

#include <algorithm>

#include "app/editor_parts.hpp"
#include "panels/column_layout.hpp"
#include "panels/left_panels.hpp"
#include "panels/right_panels.hpp"

namespace vides {
namespace {

// The panels' height becomes the region's, so that it can be scrolled.
void endStack(const Stack& stack, float top) {
  ImGui::SetCursorScreenPos({stack.x(), top});
  ImGui::Dummy({1.0f, std::max(1.0f, stack.y() - top)});
}

// Where a column's panels begin, apart from its edges.
Stack stackIn(const Ui& ui, const Rect& room, float width) {
  return {ui, room.x + ui.px(8), room.y + ui.tall(8), width - 2 * ui.px(8)};
}

// What the right column's panels need beside the picture, with the least and the largest sphere.
Range besidePicture(const Ui& ui, float width, const Session& session) {
  const float all =
      cameraPanelHeight(ui, width, session) + panelHeight(ui) + measuresPanelHeight(ui);
  const float most = std::min(rowWidth(ui, width), mostSphere(ui));
  return {static_cast<double>(all + leastSphere(ui)), static_cast<double>(all + most)};
}

}  // namespace

void Editor::Parts::leftColumn(Ui& ui, const Rect& rect, bool both, Actions& actions) {
  const auto needed = [&] {
    const float width = rect.width - 2 * ui.px(8);
    return ui.tall(8) + positionPanelHeight(ui, width) + orientationPanelHeight(ui, width) +
           speedPanelHeight(ui) + zoomPanelHeight(ui, true);
  };
  const DenseRows rows(ui, both ? 1.0f : fittingDensity(ui, rect.height, needed));
  region("###left", rect, [&](const Rect& room) {
    Stack column = stackIn(ui, room, rect.width);
    const float bottom = room.y + rect.height;
    leftPanels(ui, column, both ? column.y() : bottom, actions);
    if (both) rightPanels(ui, column, column.y() + rect.height, actions);
    endStack(column, room.y);
  });
}

void Editor::Parts::leftPanels(Ui& ui, Stack& column, float bottom, Actions& actions) {
  positionPanel(ui, column, session, actions);
  orientationPanel(ui, column, session, actions);
  const float zoom = zoomPanelHeight(ui, false);
  speedPanel(ui, column, bottom - zoom, zoom - zoomPanelHeight(ui, true), session, actions);
  zoomPanel(ui, column, bottom, session, actions);
}

void Editor::Parts::rightColumn(Ui& ui, const Rect& rect, Actions& actions) {
  const auto needed = [&] {
    const float width = rect.width - 2 * ui.px(8), height = rect.height - ui.tall(8);
    const Range rest = besidePicture(ui, width, session);
    return ui.tall(8) + pictureHeight(ui, width, height, {0.0, rest.max}, session) +
           static_cast<float>(rest.min);
  };
  const DenseRows rows(ui, fittingDensity(ui, rect.height, needed));
  region("###right", rect, [&](const Rect& room) {
    Stack column = stackIn(ui, room, rect.width);
    rightPanels(ui, column, room.y + rect.height, actions);
    endStack(column, room.y);
  });
}

void Editor::Parts::rightPanels(Ui& ui, Stack& column, float bottom, Actions& actions) {
  const float height = pictureHeight(ui, column.width(), bottom - column.y(),
                                     besidePicture(ui, column.width(), session), session);
  const Rect picture = cameraPanel(ui, column, height, session, actions);
  const bool film = !session.view().swapped;
  pictureArea(ui, picture, film, true);
  pictures->camera(ui, *ImGui::GetWindowDrawList(), picture, session, scenes, viewportState());
  if (film && session.freeCamera()) freeViewSign(ui, picture);
  spherePanel(ui, column, bottom - measuresPanelHeight(ui), session, graphs, actions);
  measuresPanel(ui, column, session, graphs);
}

}  // namespace vides
