// SPDX-License-Identifier: MIT
// Around the viewport: what view it is, and the three sliders that turn, tilt and size it.
#pragma once

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"

namespace vides {

// Where the sliders around the viewport stand, if there is room for them.
bool roomForSliders(const Ui& ui, const Rect& rect);
struct SliderPlaces {
  Rect size, turn, tilt;
};
SliderPlaces sliderPlaces(const Ui& ui, const Rect& rect);
// What the sliders ask for; they change the view, which is no step of the history.
std::optional<EditorView> viewportSliders(Ui& ui, const Rect& rect, const Session& session);

// In the viewport while scenes are read: how far it is, and a button that stops it.
void readingSign(Ui& ui, const Rect& viewport, const Session& session, Actions& actions);

// A line between two regions that can be dragged, and folds its region at a double click. Gives
// back by how many pixels (at content scale 1) it was dragged.
struct SplitterChange {
  float by = 0.0f;
  bool fold = false;
};
SplitterChange splitter(Ui& ui, std::string_view id, const Rect& rect, bool vertical);

}  // namespace vides
