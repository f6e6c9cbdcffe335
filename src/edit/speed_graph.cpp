// SPDX-License-Identifier: MIT
// Speed, way and acceleration of a section in numbers.
#include "edit/speed_graph.hpp"

#include <algorithm>
#include <cmath>

namespace vides {
namespace {

constexpr std::size_t kIntervals = kSpeedValues - 1;

// How much changes from the section's start to its end.
void measure(SpeedGraph& graph, const Flight& flight, const Section& section) {
  const auto zoomOf = [&](const OrientationPlace& place) {
    return flight.keys[place.key].orientations[place.orientation].zoom;
  };
  graph.kind = section.kind;
  graph.frames = section.frames;
  graph.seconds = static_cast<double>(section.frames) / flight.frameRate;
  switch (section.kind) {
    case SectionKind::kMove:
      graph.unit = SectionUnit::kScene;
      graph.amount = section.length * flight.space.halfSize;
      break;
    case SectionKind::kPan:
    case SectionKind::kRoll:
      graph.unit = SectionUnit::kDegrees;
      graph.amount = section.angle;
      break;
    case SectionKind::kZoom:
      graph.unit = SectionUnit::kZoom;
      graph.amount = std::abs(zoomOf(section.to) - zoomOf(section.from));
      break;
    case SectionKind::kHold:
      break;
  }
}

}  // namespace

std::optional<SpeedGraph> speedGraph(const Evaluation& evaluation, const OrientationPlace& place,
                                     int chords) {
  if (evaluation.next(place) == place) return std::nullopt;
  SpeedGraph graph;
  const SpeedCurve& used = evaluation.speedCurve(place);
  graph.start = jointAt(evaluation, place, SectionEnd::kStart);
  graph.end = jointAt(evaluation, place, SectionEnd::kEnd);
  graph.idleTurns = evaluation.idleTurns(place);
  const SpeedCurve drawn = SpeedCurve::unlimited(used.values(), evaluation.speedBefore(place),
                                                 evaluation.speedAfter(place));
  for (std::size_t i = 0; i < kIntervals; ++i) {
    graph.limited[i] =
        used.slopes()[i] != drawn.slopes()[i] || used.slopes()[i + 1] != drawn.slopes()[i + 1];
  }
  if (const auto section = evaluation.sectionFrom(place)) {
    measure(graph, evaluation.flight(), *section);
  }
  const double seconds = graph.seconds;
  if (seconds > 0.0) graph.perSpeed = graph.amount / (used.mean() * seconds);
  const auto count = static_cast<int>(kIntervals) * chords;
  for (int i = 0; i <= count; ++i) {
    const double tau = static_cast<double>(i) / count;
    SpeedGraph::Point point{tau, used.at(tau), drawn.at(tau), graph.amount * used.progress(tau),
                            0.0};
    if (seconds > 0.0) point.acceleration = graph.perSpeed * used.derivative(tau) / seconds;
    graph.fastest = std::max(graph.fastest, graph.perSpeed * point.speed);
    graph.most = std::max(graph.most, std::abs(point.acceleration));
    graph.points.push_back(point);
  }
  graph.mean = graph.perSpeed * used.mean();
  return graph;
}

double drawnSpeed(double speed, double step) {
  return std::clamp(std::round(speed / step) * step, kMinSpeed, kMaxSpeed);
}

SpeedValues swept(const SpeedValues& values, double tau0, double speed0, double tau1, double speed1,
                  double step) {
  constexpr double kHalfColumn = 0.5 / static_cast<double>(kIntervals);
  SpeedValues result = values;
  const double low = std::min(tau0, tau1), high = std::max(tau0, tau1);
  for (std::size_t j = 0; j < result.size(); ++j) {
    const double tau = static_cast<double>(j) / static_cast<double>(kIntervals);
    const double way = tau1 - tau0;
    const bool crossed = way != 0.0 && low <= tau && tau <= high;
    // On the way to a handle it follows within its column; once crossed it stays.
    const bool near = std::abs(tau - tau1) <= kHalfColumn;
    const bool towards = way == 0.0 || std::abs(tau - tau1) < std::abs(tau - tau0);
    if (!crossed && !(near && towards)) continue;
    const double share = crossed ? (tau - tau0) / way : 1.0;
    result[j] = drawnSpeed(speed0 + share * (speed1 - speed0), step);
  }
  return result;
}

}  // namespace vides
