// SPDX-License-Identifier: MIT
// How the window is divided: widths of the columns, height of the timeline, and within the columns
// how close the panels' rows stand.
#pragma once

#include <functional>

#include "edit/layout.hpp"
#include "panels/ui.hpp"

namespace vides {

// Pixels that the columns take. Where there is no room for both, the left one holds the right one's
// panels, too.
struct ColumnWidths {
  float left = 0.0f, right = 0.0f;
  bool both = false;
};
// Unless the user has chosen a width, the right column grows with the window: it holds what the
// camera sees, a picture `proportion` times as wide as high, which is the result. Where the
// viewport would have too little the columns give way, the right one first.
ColumnWidths columnWidths(const Ui& ui, const Layout& layout, float width, float height,
                          float proportion);

// Of a usual column's height, what the camera's picture takes at most.
inline constexpr float kPictureShare = 0.4f;

// In a low window the columns need the room more, in a high one there is enough; unless the user
// has chosen a height.
float timelineHeight(const Ui& ui, const Layout& layout, float height);

// The largest of the usual densities (Ui::setDensity) at which what a column holds is no higher
// than `height`; the least one where none is enough.
float fittingDensity(Ui& ui, float height, const std::function<float()>& needed);

// A part of the window with a scroll bar where it is too low for what it holds. `content` is given
// its place, scrolled.
void region(const char* id, const Rect& rect, const std::function<void(Rect)>& content);

// Rows stand as close as that until the end of the block.
class DenseRows {
 public:
  DenseRows(Ui& ui, float density) : ui_(ui), before_(ui.density()) { ui.setDensity(density); }
  ~DenseRows() { ui_.setDensity(before_); }
  DenseRows(const DenseRows&) = delete;
  DenseRows& operator=(const DenseRows&) = delete;

 private:
  Ui& ui_;
  float before_;
};

}  // namespace vides
