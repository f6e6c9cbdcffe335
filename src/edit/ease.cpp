// SPDX-License-Identifier: MIT
// The ease presets' formulas.
#include "edit/ease.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vides {
namespace {

constexpr double kPi = std::numbers::pi;

struct EasePreset {
  std::string_view name;
  double (*speed)(double tau);
};

double ramp(double x) { return std::min(x, 1.0); }

constexpr EasePreset kPresetTable[] = {
    {"constant", [](double) { return kBaseSpeed; }},
    {"in-sine", [](double t) { return 25.0 * kPi * std::sin(0.5 * kPi * t); }},
    {"out-sine", [](double t) { return 25.0 * kPi * std::cos(0.5 * kPi * t); }},
    {"in-out-sine", [](double t) { return 25.0 * kPi * std::sin(kPi * t); }},
    {"in-parabola", [](double t) { return 100.0 * t; }},
    {"out-parabola", [](double t) { return 100.0 * (1.0 - t); }},
    {"in-out-parabola", [](double t) { return 100.0 * std::min(2.0 * t, 2.0 - 2.0 * t); }},
    {"in-acceleration", [](double t) { return 60.0 * ramp(3.0 * t); }},
    {"out-acceleration", [](double t) { return 60.0 * ramp(3.0 - 3.0 * t); }},
    {"in-out-acceleration",
     [](double t) { return 75.0 * std::min(ramp(3.0 * t), ramp(3.0 - 3.0 * t)); }},
};

}  // namespace

const std::vector<std::string_view>& easeNames() {
  static const std::vector<std::string_view> kNames = [] {
    std::vector<std::string_view> list;
    for (const EasePreset& preset : kPresetTable) list.push_back(preset.name);
    return list;
  }();
  return kNames;
}

std::optional<SpeedValues> easeValues(std::string_view name) {
  for (const EasePreset& preset : kPresetTable) {
    if (preset.name != name) continue;
    SpeedValues values;
    for (std::size_t j = 0; j < values.size(); ++j) {
      const double tau = static_cast<double>(j) / (kSpeedValues - 1);
      values[j] = std::clamp(preset.speed(tau), kMinSpeed, kMaxSpeed);
    }
    return values;
  }
  return std::nullopt;
}

}  // namespace vides
