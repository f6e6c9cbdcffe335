// SPDX-License-Identifier: MIT
// Looks a method up by its name.
#include "flight/orientation_method.hpp"

#include <algorithm>

namespace vides {

const OrientationMethod* orientationMethod(std::string_view name) {
  const auto all = orientationMethods();
  const auto found =
      std::ranges::find(all, name, [](const OrientationMethod* method) { return method->name; });
  return found == all.end() ? nullptr : *found;
}

}  // namespace vides
