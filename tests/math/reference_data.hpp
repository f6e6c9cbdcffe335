// SPDX-License-Identifier: MIT
// Reads the reference values under tests/data/reference into the core's types.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "math/vector.hpp"

namespace vides::test {

using Json = nlohmann::json;

inline Json reference(const std::string& file) {
  std::ifstream in(std::string(VIDES_TEST_DATA) + "/reference/" + file);
  if (!in) throw std::runtime_error("missing reference file " + file);
  return Json::parse(in);
}

inline Vec3 vec3(const Json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

// [w, x, y, z]
inline Quaternion quaternion(const Json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>(),
          j.at(3).get<double>()};
}

// The largest difference of a component.
inline double difference(const Quaternion& a, const Quaternion& b) {
  return std::max(
      {std::abs(a.w - b.w), std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}
inline double difference(const Vec3& a, const Vec3& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}
// The same up to the quaternion's sign.
inline double differenceOfRotations(const Quaternion& a, const Quaternion& b) {
  return std::min(difference(a, b), difference(a, -b));
}

}  // namespace vides::test
