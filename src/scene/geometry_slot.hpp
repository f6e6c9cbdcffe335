// SPDX-License-Identifier: MIT
// Hands out the same geometry again for as long as its points stay the same.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "scene/draw_list.hpp"

namespace vides {

class GeometrySlot {
 public:
  SharedGeometry keep(Primitive primitive, std::vector<GeometryPoint> points) {
    return keep(std::make_shared<const Geometry>(Geometry{primitive, std::move(points)}));
  }
  SharedGeometry keep(SharedGeometry fresh) {
    const bool same =
        geometry_ && geometry_->primitive == fresh->primitive && geometry_->points == fresh->points;
    if (!same) geometry_ = std::move(fresh);
    return geometry_;
  }

 private:
  SharedGeometry geometry_;
};

}  // namespace vides
