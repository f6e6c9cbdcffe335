// SPDX-License-Identifier: MIT
// Problems of places, converted.
#include "edit/problem_units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "edit/place_text.hpp"
#include "flight/limits.hpp"

namespace vides {
namespace {

// Without the noise of the way there and back.
double rounded(double value) {
  double result = value;
  const std::string text = fmt::format("{:.12g}", value);
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result + 0.0;  // -0 becomes 0
}

// A number as problems tell it.
std::optional<double> numberIn(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// "[1, 2, 3]", or nothing.
std::optional<Vec3> pointIn(std::string_view text) {
  if (!text.starts_with('[') || !text.ends_with(']')) return std::nullopt;
  text = text.substr(1, text.size() - 2);
  Vec3 point(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t end = std::min(text.find(", "), text.size());
    const auto value = numberIn(text.substr(0, end));
    if (!value) return std::nullopt;
    point[axis] = *value;
    text.remove_prefix(std::min(end + 2, text.size()));
  }
  return point;
}

// Of what the pointer names: /keys/K/position/A or /keys/K/orientations/J/aim/A; A may be absent.
struct Place {
  bool offset = false;  // of a relative aim: the space's centre doesn't move it
  std::optional<std::size_t> axis;
};
std::optional<Place> placeOf(std::string_view pointer, const Flight& flight) {
  const std::vector<std::string_view> tokens = tokensOf(pointer);
  if (tokens.size() < 3 || tokens[0] != "keys") return std::nullopt;
  const auto key = indexIn(tokens[1]);
  if (!key || *key >= flight.keys.size()) return std::nullopt;
  const auto axisAt = [&](std::size_t i) {
    const auto axis = i < tokens.size() ? indexIn(tokens[i]) : std::nullopt;
    return axis && *axis < 3 ? axis : std::nullopt;
  };
  if (tokens[2] == "position") return Place{false, axisAt(3)};
  if (tokens[2] != "orientations" || tokens.size() < 5 || tokens[4] != "aim") return std::nullopt;
  const auto orientation = indexIn(tokens[3]);
  const auto& orientations = flight.keys[*key].orientations;
  if (!orientation || *orientation >= orientations.size()) return std::nullopt;
  return Place{orientations[*orientation].aimMode == AimMode::kRelative, axisAt(5)};
}

}  // namespace

Problem inSceneUnits(Problem problem, const Flight& flight) {
  const auto place = placeOf(problem.pointer, flight);
  if (!place) return problem;
  const Space& space = flight.space;
  Expectation& expected = problem.expected;
  if (place->axis) {
    const double from = place->offset ? 0.0 : space.center[static_cast<int>(*place->axis)];
    const auto converted = [&](double value) { return rounded(from + space.halfSize * value); };
    if (expected.max < limits::kFinite) {
      expected.min = converted(expected.min);
      expected.max = converted(expected.max);
    }
    if (const auto found = numberIn(problem.found)) {
      if (std::isfinite(*found)) problem.found = fmt::format("{}", converted(*found));
    }
  } else if (problem.code == ProblemCode::kAimAtKey) {
    expected.min = rounded(expected.min * space.halfSize);
    if (const auto found = pointIn(problem.found)) {
      const Vec3 p = place->offset ? space.halfSize * *found : space.toWorld(*found);
      problem.found = fmt::format("[{}, {}, {}]", rounded(p.x), rounded(p.y), rounded(p.z));
    }
  }
  return problem;
}

}  // namespace vides
