// SPDX-License-Identifier: MIT
// A small picture of what a shape does.
#include "edit/shape_picture.hpp"

namespace vides {

ShapePicture shapePicture(const Shape& shape, int chords) {
  const Vec3 before{0.05, 0.95, 0.0}, key{0.45, 0.15, 0.0}, after{0.95, 0.75, 0.0};
  const CubicSegment pieces[] = {
      kochanekBartelsSegment(nullptr, before, Shape{}, key, shape, &after),
      kochanekBartelsSegment(&before, key, shape, after, Shape{}, nullptr)};
  ShapePicture picture{Vec2(key), {Vec2(before)}};
  for (const CubicSegment& piece : pieces) {
    for (int i = 1; i <= chords; ++i) {
      picture.line.emplace_back(Vec2(piece.point(static_cast<double>(i) / chords)));
    }
  }
  return picture;
}

}  // namespace vides
