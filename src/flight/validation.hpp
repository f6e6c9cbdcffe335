// SPDX-License-Identifier: MIT
// Checks a flight against the ranges of the format: the same problems at the same pointers as the
// reader of `.vid` files tells, and for single values as an editor needs them.
//
// What only the evaluation can tell (more than limits::kFrames frames) is not looked at here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flight/flight.hpp"
#include "flight/limits.hpp"
#include "flight/problem.hpp"

namespace vides {

// In the order of the file, at most kMostProblems. Empty if the flight can be written and read
// back. The text of Extra members is taken for what the reader gave.
std::vector<Problem> validate(const Flight& flight);

// The first problem of one key; index < flight.keys.size().
std::optional<Problem> checkKey(const Flight& flight, std::size_t index);
// The first problem of a key that would stand at `index`.
std::optional<Problem> checkKey(const Key& key, std::size_t index);

// Single values, at the place `pointer`.
std::optional<Problem> checkNumber(double value, const Range& range, std::string_view pointer);
std::optional<Problem> checkInteger(double value, const Range& range, std::string_view pointer);
std::optional<Problem> checkName(std::string_view name, std::string_view pointer);
// A path of a scene file: not empty, UTF-8, without NUL.
std::optional<Problem> checkPath(std::string_view path, std::string_view pointer);
std::optional<Problem> checkSpaceCenter(const Vec3& center, std::string_view pointer);
// Whether the aim point is far enough from its key.
std::optional<Problem> checkAimDistance(const Vec3& position, AimMode mode, const Vec3& aim,
                                        std::string_view pointer);

Expectation expectNumber(const Range& range);
Expectation expectNumbers(int count, const Range& range);
Expectation expectInteger(const Range& range);
Expectation expectCount(const CountRange& range);

}  // namespace vides
