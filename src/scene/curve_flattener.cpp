// SPDX-License-Identifier: MIT
// Flattens cubic pieces by a bound on their second derivative.
#include "scene/curve_flattener.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "math/whole.hpp"

namespace vides {
namespace {

constexpr int kMostParts = 4096;
// A run of pieces that becomes one chord is at most so long: pixels, and pieces.
constexpr double kLongestRun = 4.0;
constexpr std::size_t kMostInRun = 16;

std::array<Vec3, 4> controlPoints(const CubicSegment& q) {
  return {q.d, q.d + q.c / 3.0, q.d + (2.0 * q.c + q.b) / 3.0, q.d + q.c + q.b + q.a};
}

// How many pixels a unit covers at most, where something is seen.
class Scale {
 public:
  explicit Scale(const ViewProjection& view) : view_(view) {
    const glm::dmat4& m = view.mappingMatrix();
    pixels_ = 0.5 * view.pixels().height * m[1][1];
    parallelLevel_ = levelOf(pixels_);
    if (!view.perspective()) return;
    // A step across the line of sight covers more pixels towards the picture's corners.
    const double x = 1.0 / m[0][0], y = 1.0 / m[1][1];
    pixels_ *= std::sqrt(1.0 + x * x + y * y);
    const ViewMapping& mapping = view.mapping();
    nearest_ = mapping.projectionReferencePoint.z - mapping.frontPlaneDistance;
    const double middle = mapping.projectionReferencePoint.z - mapping.viewPlaneDistance;
    unseenLevel_ = levelOf(pixels_ / middle);
  }

  // In a parallel projection all pieces have the same.
  std::optional<int> common() const {
    if (view_.perspective()) return std::nullopt;
    return parallelLevel_;
  }

  int level(const CubicSegment& piece) const {
    if (!view_.perspective()) return parallelLevel_;
    const auto points = controlPoints(piece);
    double least = view_.weight(points[0]);
    for (const Vec3& p : points) least = std::min(least, view_.weight(p));
    const int result = levelOf(pixels_ / std::max(least, nearest_));
    if (result <= unseenLevel_) return result;
    Vec3 low = points[0], high = points[0];
    for (const Vec3& p : points) low = glm::min(low, p), high = glm::max(high, p);
    return mayBeSeen(view_, low, high, 8.0) ? result : unseenLevel_;
  }

 private:
  static int levelOf(double pixels) {
    return static_cast<int>(wholeWithin(std::ceil(std::log2(pixels)), -10, 30));
  }

  const ViewProjection& view_;
  double pixels_ = 1.0;
  double nearest_ = 0.0;
  int parallelLevel_ = 0;
  int unseenLevel_ = 0;
};

int partsOf(const CubicSegment& q, int level) {
  const double bend =
      std::max(glm::length(q.secondDerivative(0.0)), glm::length(q.secondDerivative(1.0)));
  const double parts = std::ceil(std::sqrt(std::ldexp(bend, level) / (8.0 * kFlatteningError)));
  return static_cast<int>(wholeWithin(parts, 1, kMostParts));
}

// Collects short pieces for as long as one chord is as good as they are.
class Run {
 public:
  // Whether the piece can lie in the run too; `from` is where the run begins.
  bool take(const Vec3& from, const std::array<Vec3, 4>& points, int level) {
    if (count_ == kMostInRun) return false;
    const double unit = std::ldexp(1.0, -level);
    std::array<Vec3, 3 * kMostInRun> inner = inner_;
    std::copy(points.begin(), points.begin() + 3, inner.begin() + 3 * count_);
    const Vec3 chord = points[3] - from;
    const double length2 = glm::dot(chord, chord);
    if (length2 > kLongestRun * kLongestRun * unit * unit) return false;
    for (std::size_t i = 0; i < 3 * (count_ + 1); ++i) {
      const Vec3 way = inner[i] - from;
      const double share =
          length2 > 0.0 ? std::clamp(glm::dot(way, chord) / length2, 0.0, 1.0) : 0.0;
      if (glm::length(way - share * chord) > kFlatteningError * unit) return false;
    }
    inner_ = inner;
    ++count_;
    return true;
  }
  void clear() { count_ = 0; }
  bool empty() const { return count_ == 0; }

 private:
  std::array<Vec3, 3 * kMostInRun> inner_{};
  std::size_t count_ = 0;
};

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const double length2 = glm::dot(way, way);
  const double share = length2 > 0.0 ? std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - a - share * way);
}

// Both show every piece at the same scale.
bool sameView(const ViewProjection& a, const ViewProjection& b) {
  return a.perspective() == b.perspective() && a.pixels() == b.pixels() &&
         a.matrix() == b.matrix() && a.mappingMatrix() == b.mappingMatrix();
}

Vec3 toVec3(const GeometryPoint& p) { return {p.x, p.y, p.z}; }

}  // namespace

bool mayBeSeen(const ViewProjection& view, const Vec3& low, const Vec3& high, double margin) {
  const double x = 1.0 + 2.0 * margin / view.pixels().width;
  const double y = 1.0 + 2.0 * margin / view.pixels().height;
  std::array<bool, 5> outside;
  outside.fill(true);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{(corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                 (corner & 4) != 0 ? high.z : low.z};
    const glm::dvec4 clip = view.matrix() * glm::dvec4(p, 1.0);
    outside[0] = outside[0] && clip.x < -x * clip.w;
    outside[1] = outside[1] && clip.x > x * clip.w;
    outside[2] = outside[2] && clip.y < -y * clip.w;
    outside[3] = outside[3] && clip.y > y * clip.w;
    outside[4] = outside[4] && clip.w <= 0.0;
  }
  return std::ranges::none_of(outside, [](bool all) { return all; });
}

// The chunks that hold one of the changed pieces or stand beside one.
void CurveFlattener::updateChunks(const std::vector<Evaluation::PieceRange>& changed) {
  const std::size_t count = pieces_.size();
  std::size_t i = 0;
  for (Chunk& chunk : chunks_) {
    const std::size_t first = chunk.first, last = first + chunk.pieces();
    while (i < changed.size() && changed[i].last < first) ++i;
    const bool near = i < changed.size() && changed[i].first <= last;
    // Of a closed flight the first and the last one are neighbours.
    const bool atSeam = first == 0 || last == count;
    if ((near || atSeam) && !fits(chunk, first)) make(chunk);
  }
}

void CurveFlattener::update(const Evaluation& evaluation, const ViewProjection& view) {
  const Scale scale(view);
  rebuilt_ = 0;
  const bool sameEvaluation = !chunks_.empty() && evaluation_.sameAs(evaluation);
  const bool sameScale =
      scale.common() ? scale.common() == commonLevel_ : !commonLevel_ && sameView(view, view_);
  const Evaluation old = std::exchange(evaluation_, evaluation);
  commonLevel_ = scale.common();
  view_ = view;
  if (sameEvaluation && sameScale) return;
  const std::size_t count = evaluation.pieceCount();
  const std::size_t before = pieces_.size();
  const bool sameKeys = evaluation.flight().keys.size() == old.flight().keys.size();
  const auto look = [&](std::size_t first, std::size_t last) {
    evaluation.forEachPiece(first, last,
                            [&](std::size_t k, const void* identity, const CubicSegment& piece) {
                              pieces_[k] = {identity, scale.level(piece)};
                            });
  };
  if (sameScale && sameKeys && !chunks_.empty() && closed_ == evaluation.flight().closed) {
    const auto changed = evaluation.changedPieces(old);
    for (const auto& range : changed) look(range.first, range.last);
    updateChunks(changed);
    return;
  }
  closed_ = evaluation.flight().closed;
  pieces_.resize(count);
  look(0, count);

  if (count == before) {
    for (Chunk& chunk : chunks_) {
      if (!fits(chunk, chunk.first)) make(chunk);
    }
    return;
  }
  // Pieces came or went: the chunks before and behind that place stay.
  std::size_t front = 0, back = chunks_.size();
  while (front < chunks_.size() && fits(chunks_[front], chunks_[front].first)) ++front;
  const auto moved = [&](const Chunk& chunk) { return chunk.first + count - before; };
  while (back > front && chunks_[back - 1].first + count >= before &&
         fits(chunks_[back - 1], moved(chunks_[back - 1]))) {
    --back;
  }
  const std::size_t gapBegins =
      front == 0 ? 0 : chunks_[front - 1].first + chunks_[front - 1].pieces();
  std::size_t gapEnds = back == chunks_.size() ? count : moved(chunks_[back]);
  if (gapEnds < gapBegins) back = chunks_.size(), gapEnds = count;
  std::vector<Chunk> chunks(chunks_.begin(), chunks_.begin() + static_cast<std::ptrdiff_t>(front));
  divide(gapBegins, gapEnds, chunks);
  for (std::size_t i = back; i < chunks_.size(); ++i) {
    chunks.push_back(std::move(chunks_[i]));
    chunks.back().first = moved(chunks.back());
  }
  chunks_ = std::move(chunks);
}

CurveFlattener::Piece CurveFlattener::pieceAt(std::ptrdiff_t index) const {
  const auto count = static_cast<std::ptrdiff_t>(pieces_.size());
  if (closed_ && count > 0) index = (index + count) % count;
  return index < 0 || index >= count ? Piece{} : pieces_[static_cast<std::size_t>(index)];
}

std::vector<CurveFlattener::Piece> CurveFlattener::signatureOf(std::size_t first,
                                                               std::size_t count) const {
  std::vector<Piece> result(count + 2);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = pieceAt(static_cast<std::ptrdiff_t>(first + i) - 1);
  }
  return result;
}

bool CurveFlattener::fits(const Chunk& chunk, std::size_t first) const {
  const std::size_t count = chunk.signature.size() - 2;
  if (first + count > pieces_.size()) return false;
  if (!std::equal(chunk.signature.begin() + 1, chunk.signature.end() - 1,
                  pieces_.begin() + static_cast<std::ptrdiff_t>(first))) {
    return false;
  }
  const auto at = static_cast<std::ptrdiff_t>(first);
  return chunk.signature.front() == pieceAt(at - 1) &&
         chunk.signature.back() == pieceAt(at + static_cast<std::ptrdiff_t>(count));
}

// Small enough that an edit makes little anew, few enough that each can be a draw of its own.
void CurveFlattener::divide(std::size_t first, std::size_t last, std::vector<Chunk>& chunks) {
  const std::size_t size = std::clamp<std::size_t>(pieces_.size() / 64, 32, 1024);
  while (first < last) {
    const std::size_t count = std::min(size, last - first);
    Chunk& chunk = chunks.emplace_back();
    chunk.first = first;
    chunk.signature.resize(count + 2);
    make(chunk);
    first += count;
  }
}

void CurveFlattener::make(Chunk& chunk) {
  ++rebuilt_;
  const std::size_t count = chunk.signature.size() - 2;
  chunk.signature = signatureOf(chunk.first, count);
  chunk.begins.clear();
  auto geometry = std::make_shared<Geometry>();
  geometry->primitive = Primitive::kPolylines;
  auto& points = geometry->points;

  const Piece before = chunk.signature.front(), after = chunk.signature.back();
  const std::size_t all = pieces_.size();
  if (before.identity != nullptr) {
    const CubicSegment& q = evaluation_.piece((chunk.first + all - 1) % all);
    points.push_back(geometryPoint(q.point(1.0 - 1.0 / partsOf(q, before.level))));
  } else {
    points.push_back({0, 0, 0, kLineEnds});
  }

  Vec3 last = evaluation_.piece(chunk.first).point(0.0);
  Vec3 runBegins = last;
  chunk.low = chunk.high = last;
  points.push_back(geometryPoint(last));
  Run run;
  for (std::size_t i = 0; i < count; ++i) {
    const CubicSegment& q = evaluation_.piece(chunk.first + i);
    const int level = chunk.signature[i + 1].level;
    const auto control = controlPoints(q);
    for (const Vec3& p : control) {
      chunk.low = glm::min(chunk.low, p);
      chunk.high = glm::max(chunk.high, p);
    }
    chunk.begins.push_back(static_cast<std::uint32_t>(points.size() - 2));
    if (!run.take(runBegins, control, level)) {
      if (!run.empty()) points.push_back(geometryPoint(last));
      run.clear();
      runBegins = last;
      if (!run.take(runBegins, control, level)) {
        chunk.begins.back() = static_cast<std::uint32_t>(points.size() - 2);
        const int parts = partsOf(q, level);
        for (int part = 1; part <= parts; ++part) {
          points.push_back(geometryPoint(part == parts ? control[3] : q.point(1.0 * part / parts)));
        }
        runBegins = control[3];
      }
    }
    last = control[3];
  }
  if (!run.empty()) points.push_back(geometryPoint(last));
  chunk.begins.push_back(static_cast<std::uint32_t>(points.size() - 2));

  if (after.identity != nullptr) {
    const CubicSegment& q = evaluation_.piece((chunk.first + count) % all);
    points.push_back(geometryPoint(q.point(1.0 / partsOf(q, after.level))));
  } else {
    points.back().along = kLineEnds;
    points.push_back({0, 0, 0, kLineEnds});
  }
  chunk.geometry = std::move(geometry);
}

std::optional<CurveFlattener::Nearest> CurveFlattener::nearest(const Vec2& pixel,
                                                               double reach) const {
  std::optional<Nearest> best;
  const PixelRectangle spot{pixel.x - reach, pixel.y - reach, 2.0 * reach, 2.0 * reach};
  for (const Chunk& chunk : chunks_) {
    if (!mayBeSeen(view_, chunk.low, chunk.high, reach)) continue;
    const auto& points = chunk.geometry->points;
    for (std::size_t i = 1; i + 2 < points.size(); ++i) {
      const auto a = view_.project(toVec3(points[i]));
      const auto b = view_.project(toVec3(points[i + 1]));
      if (!a || !b || std::max(a->x, b->x) < spot.x || std::min(a->x, b->x) > spot.x + spot.width) {
        continue;
      }
      const double distance = distanceToSegment(pixel, *a, *b);
      if (distance > reach || (best && distance >= best->distance)) continue;
      const auto piece = std::ranges::upper_bound(chunk.begins, i - 1) - chunk.begins.begin() - 1;
      const auto within = std::min(static_cast<std::size_t>(piece), chunk.pieces() - 1);
      best = Nearest{chunk.first + within, 0.0, distance};
    }
  }
  if (!best) return best;
  best->parameter = nearestParameter(best->piece, pixel);
  if (const auto place = view_.project(evaluation_.piece(best->piece).point(best->parameter))) {
    best->distance = glm::distance(*place, pixel);
  }
  return best;
}

// The best of a hundred places, then halving the step around it.
double CurveFlattener::nearestParameter(std::size_t piece, const Vec2& pixel) const {
  const CubicSegment& q = evaluation_.piece(piece);
  const auto distance = [&](double u) {
    const auto place = view_.project(q.point(u));
    return place ? glm::distance(*place, pixel) : std::numeric_limits<double>::infinity();
  };
  constexpr int kPlaces = 100;
  double best = 0.0, least = distance(0.0);
  const auto attempt = [&](double u) {
    u = std::clamp(u, 0.0, 1.0);
    const double here = distance(u);
    if (here < least) best = u, least = here;
  };
  for (int i = 1; i <= kPlaces; ++i) attempt(1.0 * i / kPlaces);
  for (double step = 0.5 / kPlaces; step > 1e-12; step *= 0.5) {
    const double middle = best;
    attempt(middle - step);
    attempt(middle + step);
  }
  return best;
}

}  // namespace vides
