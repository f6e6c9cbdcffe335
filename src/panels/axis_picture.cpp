// SPDX-License-Identifier: MIT
// Draws a file's axes.
#include "panels/axis_picture.hpp"

#include <cmath>

namespace vides {
namespace {

// As the viewport's first view has it, and near enough for a picture of 16 pixels.
Vec2 onScreen(const Vec3& p) {
  return {0.85 * p.x - 0.53 * p.z, -0.93 * p.y + 0.2 * p.x + 0.32 * p.z};
}

}  // namespace

std::string axisWords(UpAxis axis) {
  const std::string_view plain = name(axis);
  return plain.starts_with('-') ? "\u2212" + std::string(plain.substr(1)) : std::string(plain);
}

void axisPicture(Ui& ui, const Rect& box, UpAxis up) {
  const Mat3 turn = uprightTurn(up);
  const double length = 0.42 * static_cast<double>(std::min(box.width, box.height));
  const ImVec2 middle(std::round(box.centreX()), std::round(box.centreY()));
  constexpr ColourRole kRoles[] = {ColourRole::kAxisX, ColourRole::kAxisY, ColourRole::kAxisZ};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float thin = std::max(1.0f, 1.2f * ui.scale());
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 way(0.0);
    way[axis] = 1.0;
    const Vec3 turned = turn * way;
    const Vec2 end = length * onScreen(turned);
    const ImVec2 tip(middle.x + static_cast<float>(end.x), middle.y + static_cast<float>(end.y));
    // Which axis it is that stands upright is what the picture is about, whichever way it points.
    const bool upright = std::abs(turned.y) > 0.5;
    const ImU32 ink = ui.colour(kRoles[axis], upright ? 1.0 : 0.65);
    list.AddLine(middle, tip, ink, upright ? 1.8f * thin : thin);
    if (upright) list.AddCircleFilled(tip, 1.9f * thin, ink);
  }
}

}  // namespace vides
