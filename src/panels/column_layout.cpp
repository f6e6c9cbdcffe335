// SPDX-License-Identifier: MIT
// Columns and timeline of windows of any size.
#include "panels/column_layout.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vides {
namespace {

// At content scale 1.
constexpr float kLeastViewport = 160.0f;
// What the columns' contents can do with. Where there isn't as much, one column holds both.
constexpr float kLeastLeft = 240.0f;
constexpr float kLeastRight = 216.0f;
constexpr float kRightShare = 0.2625f, kMostRightShare = 0.35f;
constexpr float kViewportProportion = 1.1f;  // wider than that the cube gains nothing
constexpr float kTimelineShare = 0.17f, kMostTimeline = 220.0f;
constexpr float kDensities[] = {1.0f, 0.95f, 0.9f, 0.85f, 0.8f, 0.775f};

// The column's share of the window; more of it where the viewport is wider than it needs, up to
// the picture's full height.
float usualRight(const Ui& ui, float left, float width, float height, float proportion) {
  const float spare = width - left - kViewportProportion * height;
  const float full = kPictureShare * (height - ui.tall(8)) * proportion + 2 * ui.px(8);
  const float wanted =
      std::clamp(std::min(spare, full), kRightShare * width, kMostRightShare * width);
  return std::max(std::round(wanted), ui.px(Layout().right));
}

}  // namespace

void region(const char* id, const Rect& rect, const std::function<void(Rect)>& content) {
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  const bool seen = ImGui::BeginChild(id, {rect.width, rect.height}, false, ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  if (seen) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    content({from.x, from.y, ImGui::GetContentRegionAvail().x, rect.height});
  }
  ImGui::EndChild();
}

ColumnWidths columnWidths(const Ui& ui, const Layout& layout, float width, float height,
                          float proportion) {
  const float left = layout.leftShown ? ui.px(layout.left) : 0.0f;
  float right = ui.px(layout.right);
  if (layout.right == Layout().right) {
    right = usualRight(ui, left, width, height, proportion);
  }
  if (!layout.rightShown) right = 0.0f;
  const float spare = std::max(0.0f, width - ui.px(kLeastViewport));
  const float least = std::min(left, ui.px(kLeastLeft)) + std::min(right, ui.px(kLeastRight));
  if (left > 0.0f && right > 0.0f && spare < least) {
    const float half = std::max(ui.px(kLeastLeft), std::floor(width / 2.0f));
    return {std::min({left, half, width}), 0.0f, true};
  }
  right = std::min(right, std::max(spare - left, ui.px(Layout().right)));
  const float share = std::min(1.0f, spare / std::max(1.0f, left + right));
  return {std::floor(left * share), std::floor(right * share), false};
}

float timelineHeight(const Ui& ui, const Layout& layout, float height) {
  constexpr float kLeast = 116.0f;
  constexpr float kEnough = 772.0f;  // for all of it beside the columns
  constexpr float kSlope = 0.42f;
  float wanted = ui.px(layout.timeline);
  if (layout.timeline != Layout().timeline) return std::min(wanted, height * 0.5f);
  wanted = std::clamp(std::round(kTimelineShare * height), wanted, ui.px(kMostTimeline));
  const float low = std::max(
      ui.px(kLeast), ui.px(layout.timeline) - std::round(kSlope * (ui.px(kEnough) - height)));
  return std::min({wanted, low, height * 0.5f});
}

float fittingDensity(Ui& ui, float height, const std::function<float()>& needed) {
  for (const float density : kDensities) {
    const DenseRows rows(ui, density);
    if (needed() <= height) return density;
  }
  return std::end(kDensities)[-1];
}

}  // namespace vides
