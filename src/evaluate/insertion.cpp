// SPDX-License-Identifier: MIT
// New keys on the curve and beyond its end.
#include "evaluate/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "flight/limits.hpp"

namespace vides {
namespace {

constexpr int kMostInserted = 10;
// A new key closer to the last one than this makes no sense.
constexpr double kLeastRoom = 1e-3;

bool aimsAreApart(const Key& key) {
  return std::all_of(key.orientations.begin(), key.orientations.end(), [&](const Orientation& o) {
    return glm::length(aimOffset(key, o)) >= limits::kAimDistance;
  });
}

// What a new key takes over from `from` (A.4.1).
Key takeOver(const Key& from, const Vec3& position) {
  Key key = from;
  key.position = position;
  for (Orientation& o : key.orientations) o.hold = 0.0;
  return key;
}

tl::expected<Flight, InsertRefusal> insertAt(const Evaluation& evaluation, std::size_t after,
                                             const std::vector<double>& fractions) {
  const Flight& flight = evaluation.flight();
  if (after >= evaluation.pieceCount()) return tl::unexpected(InsertRefusal::kAfterLastKey);
  if (flight.keys.size() + fractions.size() > limits::kKeys.max) {
    return tl::unexpected(InsertRefusal::kTooMany);
  }
  Key current = flight.keys[after];
  const std::optional<double> duration = current.orientations.back().duration;
  const auto share = [&](double from, double to) {
    return duration ? std::optional(*duration * (to - from)) : std::nullopt;
  };
  Flight result = flight;
  const std::size_t count = fractions.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 point = evaluation.piecePoint(after, fractions[i]);
    Key key = takeOver(current, glm::clamp(point, Vec3(-1.0), Vec3(1.0)));
    key.orientations.back().duration = share(fractions[i], i + 1 < count ? fractions[i + 1] : 1.0);
    if (!aimsAreApart(key)) return tl::unexpected(InsertRefusal::kAimAtKey);
    result.keys.insert(after + 1 + i, std::move(key));
  }
  current.orientations.back().duration = share(0.0, fractions.front());
  result.keys.set(after, std::move(current));
  return result;
}

// How far along `direction` the cube lets a point go.
double roomInCube(const Vec3& point, const Vec3& direction, double wanted) {
  double room = wanted;
  for (int i = 0; i < 3; ++i) {
    if (direction[i] == 0.0) continue;
    const double face = direction[i] > 0.0 ? 1.0 : -1.0;
    room = std::min(room, (face - point[i]) / direction[i]);
  }
  return std::max(room, 0.0);
}

}  // namespace

tl::expected<Flight, InsertRefusal> insertKeys(const Evaluation& evaluation, std::size_t after,
                                               int count) {
  if (count < 1 || count > kMostInserted) return tl::unexpected(InsertRefusal::kTooMany);
  std::vector<double> fractions;
  for (int i = 1; i <= count; ++i) fractions.push_back(static_cast<double>(i) / (count + 1));
  return insertAt(evaluation, after, fractions);
}

tl::expected<Flight, InsertRefusal> appendKey(const Evaluation& evaluation) {
  const Flight& flight = evaluation.flight();
  const std::size_t last = flight.keys.size() - 1;
  if (flight.closed) return insertKeys(evaluation, last, 1);
  if (flight.keys.size() >= limits::kKeys.max) return tl::unexpected(InsertRefusal::kTooMany);

  const Key& from = flight.keys[last];
  Vec3 direction = evaluation.piece(last - 1).derivative(1.0);
  if (glm::length(direction) < 1e-9) direction = from.position - flight.keys[last - 1].position;
  const double size = glm::length(direction);
  if (!(size > 0.0)) return tl::unexpected(InsertRefusal::kNoRoom);
  direction /= size;

  const double wanted = evaluation.pieceLength(last - 1) / 3.0;
  const double step = roomInCube(from.position, direction, wanted);
  if (step < kLeastRoom) return tl::unexpected(InsertRefusal::kNoRoom);
  const Vec3 point = glm::clamp(from.position + step * direction, Vec3(-1.0), Vec3(1.0));
  Key key = takeOver(from, point);
  if (!aimsAreApart(key)) return tl::unexpected(InsertRefusal::kAimAtKey);
  Flight result = flight;
  result.keys.push_back(std::move(key));
  return result;
}

}  // namespace vides
