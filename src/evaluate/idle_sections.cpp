// SPDX-License-Identifier: MIT
// Looks for rolls a whole turn apart, and asks the evaluation what else differs there.
#include "evaluate/idle_sections.hpp"

#include <cmath>
#include <optional>

#include "evaluate/evaluation.hpp"

namespace vides {
namespace {

// Whether they may be whole turns apart; the evaluation is exact about it.
bool mayBeTurns(double a, double b) {
  return std::abs(b - a) > 180.0 && std::abs(std::remainder(b - a, 360.0)) < 1e-3;
}

}  // namespace

std::vector<IdleSection> idleSections(const Flight& flight, std::size_t most) {
  std::vector<IdleSection> idle;
  std::optional<Evaluation> evaluation;
  const auto look = [&](const OrientationPlace& from, double fromRoll, double toRoll) {
    if (idle.size() >= most || !mayBeTurns(fromRoll, toRoll)) return;
    if (!evaluation) evaluation.emplace(flight);
    const std::int64_t turns = evaluation->idleTurns(from);
    if (turns > 0) idle.push_back({from, evaluation->next(from), turns});
  };
  OrientationPlace last;
  std::optional<double> roll;
  std::size_t k = 0;
  flight.keys.forEach([&](const Key& key) {
    for (std::size_t j = 0; j < key.orientations.size(); ++j) {
      if (roll) look(last, *roll, key.orientations[j].roll);
      last = {k, j};
      roll = key.orientations[j].roll;
    }
    ++k;
  });
  if (flight.closed && roll) look(last, *roll, flight.keys.front().orientations.front().roll);
  return idle;
}

}  // namespace vides
