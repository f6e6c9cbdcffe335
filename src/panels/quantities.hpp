// SPDX-License-Identifier: MIT
// Lengths, speeds and times as the instruments tell them: one form for each, wherever it stands.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "edit/session.hpp"
#include "panels/ui.hpp"

namespace vides {

// What lengths and speeds are shown in: the unit that is chosen for positions.
struct LengthUnit {
  double perCube = 1.0;  // of these in a cube unit
  std::string brief;     // "units"
  std::string whole;     // "cube units", "scene units"
};
LengthUnit lengthUnit(const Ui& ui, const Session& session);

// Where places are so far from the origin that their numbers say little: the space's centre, which
// is shown once (view/centre), and from which they are shown.
std::optional<Vec3> farCentre(const Session& session);
// "500 000 · 0 · −4 200 000"
std::string centreWords(const Ui& ui, const Vec3& centre);

// With a narrow space between thousands, from five digits on.
std::string grouped(const Ui& ui, double value, int decimals);
std::string grouped(const Ui& ui, std::int64_t value);

// Decimals of a length or speed whose size is `most`.
int decimalsFor(double most);
// A length, a speed or the like with as many decimals as its size asks for.
std::string measured(const Ui& ui, double value);
// "0.404 units/s", "63.7 °/s", "45°", "0.404 /s"
std::string withUnit(const std::string& number, const std::string& unit);

// How long a film, a section or a hold is (edit/film_length.hpp): "31.08 s", "777 fr.", both, and a
// film's frames by number, "0–776".
std::string secondsText(const Ui& ui, std::int64_t frames, double frameRate);
std::string framesText(const Ui& ui, std::int64_t frames);
std::string lengthText(const Ui& ui, std::int64_t frames, double frameRate);
std::string frameNumbers(const Ui& ui, std::int64_t first, std::int64_t last);
// "25 fps", "23.976 fps".
std::string frameRateText(const Ui& ui, double frameRate);

// A moment of a flight that is `span` seconds long: "31.12 s", from a minute on "1:04.52", from an
// hour on "2:21:17.80"; the form is that of the span.
std::string timeText(const Ui& ui, double seconds, double span, int decimals);
// As a clock shows it, "00:09.52": with minutes and zeros in front, so that all times of a flight
// are as long; with a decimal at least.
std::string paddedTime(const Ui& ui, double seconds, double span, int decimals);

}  // namespace vides
