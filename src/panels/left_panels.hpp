// SPDX-License-Identifier: MIT
// The left column, the paper's four areas: position and curve, orientation, speed, zoom.
#pragma once

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"

namespace vides {

// Each adds itself to the column and what the user asks for to the actions. Their heights, with the
// gap to the next one, are those in a column of that width at the Ui's density.
void positionPanel(Ui& ui, Stack& column, const Session& session, Actions& actions);
float positionPanelHeight(const Ui& ui, float width);
void orientationPanel(Ui& ui, Stack& column, const Session& session, Actions& actions);
float orientationPanelHeight(const Ui& ui, float width);
// Its curve is as high as there is room above `bottom`; where there is too little, what stands
// below can give up `spare` pixels.
void speedPanel(Ui& ui, Stack& column, float bottom, float spare, const Session& session,
                Actions& actions);
// With the lowest curve.
float speedPanelHeight(const Ui& ui);
// In one row less where it fits above `bottom` only so.
void zoomPanel(Ui& ui, Stack& column, float bottom, const Session& session, Actions& actions);
float zoomPanelHeight(const Ui& ui, bool low);

// A button that runs a command, given as its line; greyed where the session can't.
void commandButton(Ui& ui, std::string_view id, const Rect& rect, std::string_view command,
                   const Session& session, Actions& actions, ButtonStyle style = {});

// How far long work is: a bar filled to `share` (cut to 0 to 1). Gives back the words for it, "43
// %".
std::string progressBar(Ui& ui, const Rect& track, double share);

// A row whose label stands left of three columns that are in line over all panels.
struct ThreeColumns {
  Rect label;
  Rect values[3];
};
ThreeColumns threeColumns(const Ui& ui, const Rect& row);
// The same for three numbers; in a column too narrow for them the label stands above.
ThreeColumns threeNumbers(const Ui& ui, Stack& rows);
float threeNumbersHeight(const Ui& ui, float width);
// What panels of a column of that width have for their rows.
float rowWidth(const Ui& ui, float columnWidth);
// Whether the selected keys differ in it: then no number is shown.
bool differs(Ui& ui, const Session& session, KeyValue which);
// The current key's place (the aim's) in the fields AREA/x, y, z (AREA/aim_x …), in the units that
// are chosen; `set` has the command for what was typed, for all selected keys.
using SetCoordinate = std::function<void(const Ui::Typed& typed, Command command)>;
void positionFields(Ui& ui, std::string_view area, const Rect (&boxes)[3], const Session& session,
                    const SetCoordinate& set);
void aimFields(Ui& ui, std::string_view area, const Rect (&boxes)[3], const Session& session,
               const SetCoordinate& set);

}  // namespace vides
