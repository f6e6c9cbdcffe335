// SPDX-License-Identifier: MIT
// Runs of bars and of marks.
#include "panels/timeline_runs.hpp"

namespace vides {

void BarRuns::add(const Rect& bar, SectionKind kind, bool narrow, bool hovered) {
  const bool joins = run_ && narrow && !hovered && kind == kind_ && bar.x <= run_->right() + 0.5f;
  if (joins) {
    run_->width = bar.right() - run_->x;
    return;
  }
  end();
  // At once, since its words come on top of it.
  if (hovered || !narrow) {
    ui_.fill(bar, roleOf(kind), 2.0f, hovered ? 1.0 : 0.85);
    return;
  }
  run_ = bar;
  kind_ = kind;
}

void BarRuns::end() {
  if (run_) ui_.fill(*run_, roleOf(kind_), 2.0f, 0.85);
  run_.reset();
}

void MarkRuns::add(float x, bool isKey, bool ringed, ColourRole role) {
  const bool joins = run_ && run_->isKey == isKey && run_->ringed == ringed && run_->role == role &&
                     x >= run_->from && x - run_->to <= 2.0f * ui_.scale();
  if (joins) {
    run_->to = x;
    return;
  }
  end();
  run_ = Run{x, x, isKey, ringed, role};
}

void MarkRuns::end() {
  if (!run_) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ui_.colour(run_->role);
  const float radius = ui_.scale() * (run_->isKey ? 3.6f : 2.2f);
  const float ring = radius + 2.0f * ui_.scale();
  if (run_->from == run_->to) {
    list.AddCircleFilled({run_->from, y_}, radius, ink);
    if (run_->ringed) list.AddCircle({run_->from, y_}, ring, ink, 0, 1.2f * ui_.scale());
  } else {
    list.AddRectFilled({run_->from - radius, y_ - radius}, {run_->to + radius, y_ + radius}, ink,
                       radius);
    if (run_->ringed) {
      list.AddRect({run_->from - ring, y_ - ring}, {run_->to + ring, y_ + ring}, ink, ring, 0,
                   1.2f * ui_.scale());
    }
  }
  run_.reset();
}

}  // namespace vides
