// SPDX-License-Identifier: MIT
// From the zoom to focal length and field of view.
#include "math/lens.hpp"

#include <cmath>

namespace vides {

double Lens::focalLength(double zoom) const {
  const double share = (zoom - kMinZoom) / (kMaxZoom - kMinZoom);
  return focalLengthAtZoom1 + share * (focalLengthAtZoom100 - focalLengthAtZoom1);
}

double Lens::horizontalFieldOfView(double zoom) const {
  return 2.0 * std::atan(sensorWidth / (2.0 * focalLength(zoom)));
}

double Lens::verticalFieldOfView(double zoom, double width, double height) const {
  return 2.0 * std::atan(sensorWidth / (2.0 * focalLength(zoom)) * height / width);
}

}  // namespace vides
