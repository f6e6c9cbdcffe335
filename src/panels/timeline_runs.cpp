// SPDX-License-Identifier: MIT
// Runs of bars and of marks.
#include "panels/timeline_runs.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace vides {

void BarRuns::add(const Rect& bar, SectionKind kind, float apart, bool hovered) {
  const bool alone = apart >= 1.0f || hovered;
  const bool joins = run_ && !alone && kind == kind_ && bar.x <= run_->right() + 0.5f;
  if (joins) {
    run_->width = bar.right() - run_->x;
  } else {
    end();
    // At once, since its words come on top of it.
    if (alone) {
      const float gap = 0.5f * ui_.scale();
      const float round = std::clamp(bar.width / (7.0f * ui_.scale()) - 1.0f, 0.0f, 1.0f);
      ui_.fill({bar.x + gap, bar.y, bar.width - 2.0f * gap, bar.height}, roleOf(kind), 2.0f * round,
               hovered ? 1.0 : 0.85);
      return;
    }
    run_ = bar;
    kind_ = kind;
  }
  if (apart > 0.0f) joints_.push_back({bar.x, apart});
}

void BarRuns::end() {
  if (!run_) return;
  const Rect whole = *run_;
  run_.reset();
  ui_.fill(whole, roleOf(kind_), 0.0f, 0.85);
  const float width = std::max(1.0f, std::round(ui_.scale()));
  for (const auto& [x, apart] : joints_) {
    const float left = std::round(x - 0.5f * width);
    ui_.fill({left, whole.y, width, whole.height}, ColourRole::kColumn, 0.0f,
             static_cast<double>(apart));
  }
  joints_.clear();
}

void kindGlyph(Ui& ui, const Rect& bar, SectionKind kind) {
  const float room = (bar.width - 3.0f * ui.scale()) / 8.0f;
  if (room < 0.7f * ui.scale()) return;
  const float s = std::min(ui.scale(), room);
  const float half = 4.0f * s;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ui.colour(ColourRole::kText);
  const float width = 1.4f * s;
  const float x = std::round(bar.centreX()), y = std::round(bar.centreY());
  const auto stroke = [&](std::initializer_list<ImVec2> points) {
    list.AddPolyline(points.begin(), static_cast<int>(points.size()), ink, 0, width);
  };
  const auto arc = [&](ImVec2 centre, float radius, float from, float to) {
    list.PathArcTo(centre, radius, from, to, 20);
    list.PathStroke(ink, 0, width);
  };
  // A filled tip at `at` that shows in a direction (radians, clockwise from the right).
  const auto tip = [&](ImVec2 at, float direction, float size) {
    const ImVec2 ahead(std::cos(direction) * size, std::sin(direction) * size);
    const ImVec2 aside(-ahead.y, ahead.x);
    list.AddTriangleFilled({at.x + ahead.x, at.y + ahead.y},
                           {at.x - 0.4f * ahead.x + aside.x, at.y - 0.4f * ahead.y + aside.y},
                           {at.x - 0.4f * ahead.x - aside.x, at.y - 0.4f * ahead.y - aside.y}, ink);
  };
  constexpr float kPi = std::numbers::pi_v<float>;
  switch (kind) {
    case SectionKind::kMove:
      stroke({{x - half, y}, {x + half - s, y}});
      stroke({{x + half - 3.0f * s, y - 3.0f * s},
              {x + half, y},
              {x + half - 3.0f * s, y + 3.0f * s}});
      break;
    case SectionKind::kPan:
      // Around the camera, which stands below.
      list.AddCircleFilled({x, y + 3.0f * s}, 1.3f * s, ink);
      arc({x, y + 3.0f * s}, 1.25f * half, 1.22f * kPi, 1.72f * kPi);
      tip({x + 3.4f * s, y - 0.6f * s}, 0.28f * kPi, 2.6f * s);
      break;
    case SectionKind::kRoll:
      arc({x, y}, half - 0.4f * s, -0.35f * kPi, 1.25f * kPi);
      tip({x - 2.4f * s, y - 2.8f * s}, -0.22f * kPi, 2.4f * s);
      break;
    case SectionKind::kZoom:
      list.AddRect({x - half, y - half}, {x + half, y + half}, ink, 0.0f, 0, width);
      list.AddRectFilled({x - 1.5f * s, y - 1.5f * s}, {x + 1.5f * s, y + 1.5f * s}, ink);
      break;
    case SectionKind::kHold:
      list.AddRectFilled({x - 3.0f * s, y - half}, {x - 1.0f * s, y + half}, ink);
      list.AddRectFilled({x + 1.0f * s, y - half}, {x + 3.0f * s, y + half}, ink);
      break;
  }
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
