// SPDX-License-Identifier: MIT
// Random views of the editor.
#pragma once

#include "math/random.hpp"
#include "math/view_projection.hpp"

namespace vides::test {

inline ViewProjection randomView(Random& random) {
  EditorView view;
  view.turn = random.between(-180, 180);
  view.tilt = random.between(-90, 90);
  view.size = std::exp(random.between(std::log(0.25), std::log(20)));
  view.target = random.coin() ? Vec3{0.0} : 0.5 * random.inCube();
  view.type = random.coin() ? ProjectionType::Parallel : ProjectionType::Perspective;
  PixelRectangle pixels;
  pixels.x = random.between(-100, 300);
  pixels.y = random.between(-100, 300);
  pixels.width = random.between(200, 3000);
  pixels.height = random.between(200, 2000);
  return viewProjection(view, pixels);
}

}  // namespace vides::test
