// SPDX-License-Identifier: MIT
// Runs of bars and of marks.
#include "panels/timeline_runs.hpp"

#include <algorithm>
#include <cmath>

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
  const float gap = run_ ? std::abs(x - run_->to) : std::numeric_limits<float>::infinity();
  if (run_) draw(*run_, gap);
  run_ = Run{x, x, isKey, ringed, role, gap};
}

void MarkRuns::end() {
  if (run_) draw(*run_, std::numeric_limits<float>::infinity());
  run_.reset();
}

void MarkRuns::draw(const Run& run, float gapBehind) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool one = run.from == run.to;
  const ImU32 ink = ui_.colour(run.role, one ? 1.0 : 0.6);
  const float whole = ui_.scale() * (run.isKey ? one ? 3.6f : 2.6f : 2.2f);
  const float room = 0.4f * std::min(run.gap, gapBehind);
  const float radius = std::clamp(room, ui_.scale() * 1.4f, whole);
  const float ring = radius + 2.0f * ui_.scale();
  if (one) {
    list.AddCircleFilled({run.from, y_}, radius, ink);
    if (run.ringed) list.AddCircle({run.from, y_}, ring, ink, 0, 1.2f * ui_.scale());
  } else {
    list.AddRectFilled({run.from - radius, y_ - radius}, {run.to + radius, y_ + radius}, ink,
                       radius);
    if (run.ringed) {
      list.AddRect({run.from - ring, y_ - ring}, {run.to + ring, y_ + ring}, ink, ring, 0,
                   1.2f * ui_.scale());
    }
  }
}

}  // namespace vides
