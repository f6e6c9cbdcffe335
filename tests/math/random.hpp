// SPDX-License-Identifier: MIT
// Random inputs with a fixed seed: the same on every run and every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "math/kochanek_bartels.hpp"
#include "math/vector.hpp"

namespace vides::test {

// SplitMix64; std's distributions differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }
  double angle() { return between(-std::numbers::pi, std::numbers::pi); }
  // From 10^lo to 10^hi, evenly in the exponent.
  double magnitude(double lo, double hi) { return std::pow(10.0, between(lo, hi)); }
  bool coin() { return (bits() & 1u) != 0; }

  Vec3 inCube() {
    const double x = between(-1, 1), y = between(-1, 1);
    return {x, y, between(-1, 1)};
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = inCube();
      const double squared = glm::dot(v, v);
      if (squared > 0.01 && squared <= 1.0) return v / std::sqrt(squared);
    }
  }
  Quaternion orientation() {
    const Vec3 axis = direction();
    const double half = angle();
    return {std::cos(half), std::sin(half) * axis.x, std::sin(half) * axis.y,
            std::sin(half) * axis.z};
  }
  Shape shape() {
    const double t = between(-1, 1), c = between(-1, 1);
    return {t, c, between(-1, 1)};
  }

 private:
  std::uint64_t state_;
};

}  // namespace vides::test
