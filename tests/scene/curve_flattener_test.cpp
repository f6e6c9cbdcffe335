// SPDX-License-Identifier: MIT
// Flattening: how far the chords stray, what an edit and a turn make anew, runs of short pieces.
#include "scene/curve_flattener.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "math/random_view.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

using test::Random;

double toSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const double size2 = glm::dot(way, way);
  const double t = size2 > 0 ? std::clamp(glm::dot(p - a, way) / size2, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * way);
}

// The chords of a piece, or of the run that it is part of, in pixels.
double distanceToChords(const CurveFlattener::Chunk& chunk, std::size_t piece,
                        const ViewProjection& view, const Vec2& pixel) {
  const auto& points = chunk.geometry->points;
  // One chord before and behind: a run's only chord counts for its last piece.
  std::size_t begin = chunk.begins[piece], end = chunk.begins[piece + 1];
  begin = begin > 0 ? begin - 1 : 0;
  end = std::min(end + 1, chunk.geometry->elements());
  double least = 1e9;
  for (std::size_t i = begin; i < end; ++i) {
    const auto a = view.project({points[i + 1].x, points[i + 1].y, points[i + 1].z});
    const auto b = view.project({points[i + 2].x, points[i + 2].y, points[i + 2].z});
    if (a && b) least = std::min(least, toSegment(pixel, *a, *b));
  }
  return least;
}

bool within(const PixelRectangle& r, const Vec2& p) {
  return p.x >= r.x && p.y >= r.y && p.x <= r.x + r.width && p.y <= r.y + r.height;
}

// The largest distance in pixels of the curve from its chords, where it is seen.
double worstError(const CurveFlattener& flattener, const Evaluation& evaluation,
                  const ViewProjection& view, int samples) {
  const double nearest = view.perspective() ? view.mapping().projectionReferencePoint.z -
                                                  view.mapping().frontPlaneDistance
                                            : 0.0;
  double worst = 0.0;
  for (const auto& chunk : flattener.chunks()) {
    for (std::size_t k = 0; k < chunk.pieces(); ++k) {
      const CubicSegment& q = evaluation.piece(chunk.first + k);
      for (int i = 0; i <= samples; ++i) {
        const Vec3 p = q.point(1.0 * i / samples);
        const auto pixel = view.project(p);
        if (!pixel || view.weight(p) < 1.2 * nearest || !within(view.pixels(), *pixel)) continue;
        worst = std::max(worst, distanceToChords(chunk, k, view, *pixel));
      }
    }
  }
  return worst;
}

Flight longFlight(std::size_t keys, double step) {
  Random random(5);
  std::vector<KeyPointer> list;
  Vec3 place{0.0}, way{1, 0, 0};
  for (std::size_t i = 0; i < keys; ++i) {
    Key key;
    key.position = place;
    key.orientations.front().aim = {0, 0, 5};
    list.emplace_back(key);
    way = glm::normalize(way + 0.2 * random.inCube() - 0.05 * place);
    place = glm::clamp(place + step * way, Vec3{-1.0}, Vec3{1.0});
  }
  Flight flight;
  flight.keys = KeyList(std::move(list));
  return flight;
}

TEST(CurveFlattener, StraysLessThanAQuarterOfAPixel) {
  Random random(1);
  int chords = 0;
  for (int round = 0; round < 150; ++round) {
    test::FlightKind kind;
    kind.nasty = round % 3 == 0;
    const Evaluation evaluation(test::randomFlight(random, kind));
    const ViewProjection view = test::randomView(random);
    CurveFlattener flattener;
    flattener.update(evaluation, view);
    // A hundredth more for the floats that the points are kept in.
    ASSERT_LE(worstError(flattener, evaluation, view, 300), kFlatteningError + 0.01)
        << "round " << round << (view.perspective() ? " perspective" : " parallel");
    for (const auto& chunk : flattener.chunks()) {
      chords += static_cast<int>(chunk.geometry->elements());
    }
  }
  EXPECT_GT(chords, 1000);
}

TEST(CurveFlattener, TakesNoMoreChordsThanItNeeds) {
  // A quarter of a circle of 300 pixels, about: its sagitta s = r (1 - cos(a / 2)) says that 0.25
  // pixels need pi / 2 / (2 acos(1 - 0.25 / 300)) = 19.2 chords.
  Flight flight;
  flight.closed = true;
  std::vector<KeyPointer> keys;
  for (int i = 0; i < 4; ++i) {
    Key key;
    key.position = {std::cos(i * M_PI / 2), std::sin(i * M_PI / 2), 0.0};
    key.orientations.front().aim = {0, 0, 5};
    key.shape = {KeyShape::kOwn, Shape{-0.66, 0, 0}, nullptr};  // nearly round
    keys.emplace_back(key);
  }
  flight.keys = KeyList(std::move(keys));
  EditorView view;
  view.turn = view.tilt = 0;
  view.size = kCubeRadius;
  CurveFlattener flattener;
  flattener.update(Evaluation(flight), viewProjection(view, {0, 0, 600, 600}));
  const std::size_t chords = flattener.chunks().front().geometry->elements();
  EXPECT_GE(chords, 4u * 19);
  EXPECT_LE(chords, 4u * 19 * 2);
}

std::set<const Geometry*> geometries(const CurveFlattener& flattener) {
  std::set<const Geometry*> result;
  for (const auto& chunk : flattener.chunks()) result.insert(chunk.geometry.get());
  return result;
}

void expectWhole(const CurveFlattener& flattener, const Evaluation& evaluation) {
  std::size_t next = 0;
  for (const auto& chunk : flattener.chunks()) {
    EXPECT_EQ(chunk.first, next);
    next += chunk.pieces();
    // Chunks meet: the last point of one is the first of the next.
    const auto& points = chunk.geometry->points;
    const Vec3 first = evaluation.piece(chunk.first).point(0.0);
    EXPECT_EQ(points[1].x, static_cast<float>(first.x));
    const Vec3 last = evaluation.piece(next - 1).point(1.0);
    EXPECT_NEAR(points[points.size() - 2].x, last.x, 1e-6);
  }
  EXPECT_EQ(next, evaluation.pieceCount());
}

TEST(CurveFlattener, MakesOnlyWhatChanged) {
  Flight flight = longFlight(1000, 0.05);
  const Evaluation before(flight);
  EditorView editor;
  const PixelRectangle pixels{0, 0, 800, 600};
  CurveFlattener flattener;
  flattener.update(before, viewProjection(editor, pixels));
  const std::size_t all = flattener.chunks().size();
  EXPECT_EQ(flattener.rebuilt(), all);
  EXPECT_GE(all, 10u);

  const auto shown = geometries(flattener);
  for (int i = 0; i < 20; ++i) {
    editor.turn += 7.3;
    editor.tilt -= 1.7;
    flattener.update(before, viewProjection(editor, pixels));
    EXPECT_EQ(flattener.rebuilt(), 0u);
  }
  EXPECT_EQ(geometries(flattener), shown);

  Key key = flight.keys[500];
  key.position.x = 0.9;
  flight.keys.set(500, key);
  const Evaluation moved = before.updated(flight);
  flattener.update(moved, viewProjection(editor, pixels));
  EXPECT_GE(flattener.rebuilt(), 1u);
  EXPECT_LE(flattener.rebuilt(), 3u);
  expectWhole(flattener, moved);

  flight.keys.insert(300, key);
  const Evaluation longer = moved.updated(flight);
  flattener.update(longer, viewProjection(editor, pixels));
  EXPECT_LE(flattener.rebuilt(), 4u);
  expectWhole(flattener, longer);
  EXPECT_LE(worstError(flattener, longer, viewProjection(editor, pixels), 20), 0.26);

  flight.keys.erase(10);
  flight.keys.erase(10);
  const Evaluation shorter = longer.updated(flight);
  flattener.update(shorter, viewProjection(editor, pixels));
  EXPECT_LE(flattener.rebuilt(), 4u);
  expectWhole(flattener, shorter);

  editor.size = 3.0;
  flattener.update(shorter, viewProjection(editor, pixels));
  EXPECT_EQ(flattener.rebuilt(), flattener.chunks().size());
}

TEST(CurveFlattener, AnyEditIsTheSameAsFromScratch) {
  Random random(9);
  for (int round = 0; round < 20; ++round) {
    Flight flight = test::randomFlight(random, {true, 90});
    Evaluation evaluation(flight);
    CurveFlattener kept;
    ViewProjection view = test::randomView(random);
    for (int edit = 0; edit < 25; ++edit) {
      if (test::chance(random, 0.2)) view = test::randomView(random);
      kept.update(evaluation, view);
      expectWhole(kept, evaluation);
      ASSERT_LE(worstError(kept, evaluation, view, 20), 0.26) << round << " " << edit;
      for (int i = 0; i < 3; ++i) test::editRandomly(random, flight, true);
      evaluation = evaluation.updated(flight);
    }
  }
}

TEST(CurveFlattener, ShortPiecesBecomeOneChord) {
  // A fifth of a pixel each.
  const Evaluation evaluation(longFlight(20000, 0.001));
  const ViewProjection view = viewProjection(EditorView{}, {0, 0, 800, 600});
  CurveFlattener flattener;
  flattener.update(evaluation, view);
  std::size_t chords = 0;
  for (const auto& chunk : flattener.chunks()) chords += chunk.geometry->elements();
  EXPECT_LT(chords, 20000u / 4);
  EXPECT_GT(chords, 100u);
  EXPECT_LE(worstError(flattener, evaluation, view, 4), 0.26);
}

TEST(CurveFlattener, FindsTheNearestPlace) {
  Random random(3);
  int found = 0;
  for (int round = 0; round < 60; ++round) {
    const Evaluation evaluation(test::randomFlight(random, {}));
    const ViewProjection view = test::randomView(random);
    CurveFlattener flattener;
    flattener.update(evaluation, view);
    const PixelRectangle& r = view.pixels();
    const Vec2 pixel{r.x + random.between(0, r.width), r.y + random.between(0, r.height)};
    double least = 1e9;
    for (std::size_t k = 0; k < evaluation.pieceCount(); ++k) {
      for (int i = 0; i <= 2000; ++i) {
        const auto place = view.project(evaluation.piece(k).point(i / 2000.0));
        if (place) least = std::min(least, glm::distance(*place, pixel));
      }
    }
    const auto nearest = flattener.nearest(pixel, 60.0);
    if (least < 59.0) {
      ASSERT_TRUE(nearest) << least;
    }
    if (!nearest) continue;
    ++found;
    EXPECT_NEAR(nearest->distance, least, 0.6);
    const auto place = view.project(evaluation.piece(nearest->piece).point(nearest->parameter));
    EXPECT_NEAR(glm::distance(*place, pixel), nearest->distance, 1e-9);
  }
  EXPECT_GT(found, 10);
}

}  // namespace
}  // namespace vides
