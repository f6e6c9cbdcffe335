// SPDX-License-Identifier: MIT
// What the camera sees at the playhead.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/column_layout.hpp"
#include "panels/left_panels.hpp"
#include "panels/right_panels.hpp"

namespace vides {
namespace {

constexpr float kRow = 22.0f;

constexpr const char* kButtons[] = {"camera/use_view", "camera/new_key", "camera/safe_frames",
                                    "camera/thirds"};
constexpr float kMargin = 5.0f;  // of a label in its button, at least
constexpr float kLeastPicture = 90.0f;

bool oneRow(const Ui& ui, float width) {
  float all = 3 * ui.px(4);
  for (const char* id : kButtons) all += ui.textWidth(ui.words(id)) + 2 * ui.px(kMargin);
  return all <= width;
}

float buttonsHeight(const Ui& ui, float width) {
  return ui.tall(kRow) + (oneRow(ui, width) ? 0.0f : ui.tall(4) + ui.tall(kRow));
}

void cameraButtons(Ui& ui, Stack& rows, const Session& session, Actions& actions) {
  const Display& display = session.display();
  std::vector<Rect> places;
  if (oneRow(ui, rows.width())) {
    std::vector<std::string> labels;
    for (const char* id : kButtons) labels.push_back(ui.words(id));
    places = splitFor(ui, rows.row(kRow), labels);
  } else {
    places = split(ui, rows.row(kRow), 2);
    rows.gap(4);
    for (const Rect& place : split(ui, rows.row(kRow), 2)) places.push_back(place);
  }
  commandButton(ui, kButtons[0], places[0], "use-view", session, actions);
  commandButton(ui, kButtons[1], places[1], "new-key-from-view", session, actions);
  commandButton(ui, kButtons[2], places[2], "show-element safe-frames", session, actions,
                {.on = display.safeFrames, .toggle = true});
  commandButton(ui, kButtons[3], places[3], "show-element thirds", session, actions,
                {.on = display.thirds, .toggle = true});
}

}  // namespace

std::string cameraCaption(const Ui& ui, const Session& session) {
  if (const auto& free = session.freeCamera()) {
    return ui.words("camera/zoom") + " " + ui.number(free->zoom, 1);
  }
  return fmt::format("{} {}", ui.words("frame"), session.frame());
}

float cameraPanelHeight(const Ui& ui, float width, const Session& session) {
  const float buttons = ui.tall(8) + buttonsHeight(ui, width - 2 * ui.px(8));
  return panelHeight(ui) + buttons + (session.view().swapped ? panelHeight(ui) - ui.tall(8) : 0.0f);
}

float pictureHeight(const Ui& ui, float width, float height, const Range& rest,
                    const Session& session) {
  const PictureFormat& format = session.flight().picture;
  const double whole = static_cast<double>(width) * format.height / format.width;
  const double room = static_cast<double>(height);
  const bool chosen = session.layout().right != Layout().right;
  const double most = chosen ? room - rest.min
                             : std::max(static_cast<double>(kPictureShare) * room, room - rest.max);
  // The other panels keep what they need, unless there is next to nothing.
  const double least = static_cast<double>(ui.px(kLeastPicture));
  const double high = std::max(std::min(most, room - rest.min), least);
  return static_cast<float>(std::round(std::min(whole, high)));
}

Rect cameraPanel(Ui& ui, Stack& column, float height, const Session& session, Actions& actions) {
  Rect picture;
  const float top = column.y();
  const bool film = !session.view().swapped;
  panel(ui, column, film ? "panel/camera" : "panel/viewport", [&](Stack& rows) {
    const Rect row = rows.room(height);
    picture = {column.x(), row.y, column.width(), row.height};
    ui.fill(picture, ColourRole::kPicture);
    const float line = std::max(1.0f, ui.px(1));
    for (const float y : {picture.y - line, picture.bottom()}) {
      ui.fill({picture.x, y, picture.width, line}, ColourRole::kBorder);
    }
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
