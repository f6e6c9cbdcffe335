// SPDX-License-Identifier: MIT
// Sections of the VPN's way, cut until they are straight.
#include "panels/sphere_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vides {
namespace {

constexpr int kParts = 4;       // of a section to begin with: curves that swing are not overlooked
constexpr int kMostHalved = 7;  // of each part
// A longer chord is cut, however straight it looks; one that can't be any more is a jump.
constexpr double kLongest = 0.35;

double distanceToChord(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length = glm::dot(way, way);
  const double share = length > 0.0 ? std::clamp(glm::dot(p - a, way) / length, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + share * way);
}

bool moves(const Section& section) {
  return section.frames > 0 && section.kind != SectionKind::kHold;
}

}  // namespace

SpherePath::Point SpherePath::at(const Section& section, double frame) {
  ++evaluated_;
  const auto last = static_cast<double>(evaluation_->frameCount() - 1);
  if (frame <= last) return {frame, evaluation_->cameraBetween(frame).viewPlaneNormal};
  // Of a closed flight, from its last frame back to the first.
  const Vec3 to = evaluation_->cameraAt(section.to).viewPlaneNormal;
  const Vec3 from = evaluation_->cameraBetween(last).viewPlaneNormal;
  const Vec3 between = from + (frame - last) * (to - from);
  const double length = glm::length(between);
  return {frame, frame < last + 1.0 && length > 0.5 ? between / length : to};
}

void SpherePath::refine(Lines& lines, const Section& section, const Point& a, const Point& b,
                        int depth) {
  const bool mayCut = depth > 0 && evaluated_ < kMostEvaluated;
  if (mayCut) {
    const Point middle = at(section, 0.5 * (a.frame + b.frame));
    const bool straight = distanceToChord(middle.direction, a.direction, b.direction) <= tolerance_;
    if (!straight || glm::distance(a.direction, b.direction) > kLongest) {
      refine(lines, section, a, middle, depth - 1);
      refine(lines, section, middle, b, depth - 1);
      return;
    }
  }
  const bool jump = glm::distance(a.direction, b.direction) > kLongest;
  if (jump) {
    lines.push_back({b.direction});
  } else {
    lines.back().push_back(b.direction);
  }
}

void SpherePath::add(Lines& lines, const Section& section) {
  const auto first = static_cast<double>(section.firstFrame);
  const auto frames = static_cast<double>(section.frames);
  std::array<Point, kParts + 1> points;
  for (int i = 0; i <= kParts; ++i) {
    points[static_cast<std::size_t>(i)] = at(section, first + frames * i / kParts);
  }
  const Vec3 &a = points.front().direction, &b = points.back().direction;
  // It goes on where the one before ends.
  if (lines.empty() || lines.back().empty() || glm::distance(lines.back().back(), a) > tolerance_) {
    lines.push_back({a});
  }
  const bool straight = std::all_of(points.begin(), points.end(), [&](const Point& point) {
    return distanceToChord(point.direction, a, b) <= tolerance_;
  });
  if (straight && glm::distance(a, b) <= kLongest) {
    lines.back().push_back(b);
    return;
  }
  for (std::size_t i = 0; i < kParts; ++i) {
    refine(lines, section, points[i], points[i + 1], kMostHalved);
  }
}

void SpherePath::addPath() {
  const std::int64_t count = evaluation_->sectionCount();
  const bool many = count > static_cast<std::int64_t>(kMostFollowed);
  const std::int64_t step = many ? count / static_cast<std::int64_t>(kFollowedOfMany) + 1 : 1;
  thinned_ = thinned_ || many;
  for (std::int64_t i = 0; i < count; i += step) {
    const Section section = evaluation_->section(i);
    if (moves(section)) add(lines_, section);
  }
  std::erase_if(lines_, [](const std::vector<Vec3>& line) { return line.size() < 2; });
}

void SpherePath::addMarks() {
  const KeyList& keys = evaluation_->flight().keys;
  const std::size_t step = keys.size() / kMostFollowed + 1;
  thinned_ = thinned_ || step > 1;
  for (std::size_t k = 0; k < keys.size(); k += step) {
    for (std::size_t o = 0; o < keys[k].orientations.size(); ++o) {
      marks_.push_back({{k, o}, evaluation_->cameraAt({k, o}).viewPlaneNormal});
      ++evaluated_;
    }
  }
}

void SpherePath::follow(const Evaluation& evaluation, const OrientationPlace& current,
                        double tolerance) {
  evaluated_ = 0;
  const double power = std::exp2(std::floor(std::log2(tolerance)));
  const bool same = evaluation_ && evaluation_->sameAs(evaluation) && power == tolerance_;
  if (same && current == current_) return;
  evaluation_ = evaluation;
  tolerance_ = power;
  current_ = current;
  currentLines_.clear();
  const auto section = evaluation.sectionFrom(current);
  if (section && moves(*section)) add(currentLines_, *section);
  if (same) return;
  lines_.clear();
  marks_.clear();
  thinned_ = false;
  addPath();
  addMarks();
}

}  // namespace vides
