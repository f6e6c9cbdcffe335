// SPDX-License-Identifier: MIT
// Numbers with their units.
#include "panels/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edit/film_length.hpp"
#include "panels/form.hpp"

namespace vides {
namespace {

constexpr double kMinute = 60.0, kHour = 3600.0;
constexpr double kMostPlain = 1e9;  // larger ones have a power of ten
constexpr std::size_t kLeastGrouped = 5;

}  // namespace

LengthUnit lengthUnit(const Ui& ui, const Session& session) {
  const bool scene = session.display().units == Units::kScene;
  return {scene ? session.flight().space.halfSize : 1.0, ui.words("unit.length"),
          ui.words(scene ? "unit.length.scene" : "unit.length.cube")};
}

std::optional<Vec3> farCentre(const Session& session) {
  constexpr double kFar = 100.0;  // half sizes of the cube
  const Space& space = session.flight().space;
  if (session.display().units != Units::kScene) return std::nullopt;
  const double distance = std::hypot(std::hypot(space.center.x, space.center.y), space.center.z);
  return distance > kFar * space.halfSize ? std::optional(space.center) : std::nullopt;
}

std::string centreWords(const Ui& ui, const Vec3& centre) {
  std::string words;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) words += " \u00b7 ";
    words += grouped(ui, centre[axis], std::min(3, neededDecimals(centre[axis])));
  }
  return words;
}

std::string grouped(const Ui& ui, double value, int decimals) {
  const std::string number = ui.number(value, decimals);
  const std::size_t first = number.find_first_of("0123456789");
  const std::size_t past = std::min(number.find_first_of(".,"), number.size());
  if (first > past || past - first < kLeastGrouped) return number;
  std::string result = number.substr(0, first);
  for (std::size_t i = first; i < past; ++i) {
    if (i > first && (past - i) % 3 == 0) result += shown(ui.fonts(), "\u202f");
    result += number[i];
  }
  return result + number.substr(past);
}

std::string grouped(const Ui& ui, std::int64_t value) {
  return grouped(ui, static_cast<double>(value), 0);
}

int decimalsFor(double most) {
  constexpr double kNothing = 1e-9;
  constexpr int kMost = 6;
  const double size = std::abs(most);
  if (size >= kNothing && size < 0.1) {
    return std::min(kMost, 2 - static_cast<int>(std::floor(std::log10(size))));
  }
  return size < 100.0 ? 3 : size < 1000.0 ? 2 : size < 10000.0 ? 1 : 0;
}

std::string measured(const Ui& ui, double value) {
  if (std::abs(value) < kMostPlain) return grouped(ui, value, decimalsFor(value));
  const double power = std::floor(std::log10(std::abs(value)));
  return fmt::format("{}e{:.0f}", ui.number(value / std::pow(10.0, power), 3), power);
}

std::string withUnit(const std::string& number, const std::string& unit) {
  const bool close = unit.empty() || unit == "\u00b0";
  return close ? number + unit : number + " " + unit;
}

std::string secondsText(const Ui& ui, std::int64_t frames, double frameRate) {
  return grouped(ui, toldSeconds(frames, frameRate), kTimeDecimals) + " s";
}

std::string framesText(const Ui& ui, std::int64_t frames) {
  // Only a number is told in the singular.
  return ui.tell(frames == 1 ? Text("frames.short", {frames})
                             : Text("frames.short", {grouped(ui, frames)}));
}

std::string lengthText(const Ui& ui, std::int64_t frames, double frameRate) {
  return secondsText(ui, frames, frameRate) + " \u00b7 " + framesText(ui, frames);
}

std::string frameNumbers(const Ui& ui, std::int64_t first, std::int64_t last) {
  return grouped(ui, first) + "\u2013" + grouped(ui, last);
}

std::string frameRateText(const Ui& ui, double frameRate) {
  return ui.number(frameRate, neededDecimals(frameRate)) + " " + ui.words("frames_per_second");
}

std::string timeText(const Ui& ui, double seconds, double span, int decimals) {
  const auto parts = static_cast<std::int64_t>(std::pow(10.0, decimals));
  const std::int64_t all = timeTicks(seconds, decimals);
  const auto inSeconds = [&](std::int64_t ticks) {
    return ui.number(static_cast<double>(ticks) / static_cast<double>(parts), decimals);
  };
  if (span < kMinute) return inSeconds(all) + " s";
  const std::int64_t rest = all % (60 * parts), minutes = all / (60 * parts);
  const std::string tail = (rest < 10 * parts ? "0" : "") + inSeconds(rest);
  if (span < kHour) return fmt::format("{}:{}", minutes, tail);
  return fmt::format("{}:{:02}:{}", minutes / 60, minutes % 60, tail);
}

std::string paddedTime(const Ui& ui, double seconds, double span, int decimals) {
  const double form = std::max(span, kMinute);
  const std::string time = timeText(ui, seconds, form, decimals);
  const auto digits = [](const std::string& words) { return words.find_first_of(".,:"); };
  const std::size_t widest = std::max<std::size_t>(2, digits(timeText(ui, form, form, decimals)));
  return std::string(widest - std::min(widest, digits(time)), '0') + time;
}

}  // namespace vides
