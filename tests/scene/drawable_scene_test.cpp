// SPDX-License-Identifier: MIT
// Scenes as they are drawn: small ones whole, large ones as finely as they are seen.
#include "scene/drawable_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "math/random_view.hpp"
#include "scene/scene_part.hpp"

namespace vides {
namespace {

using test::Random;

// A net of side × side squares over x and z of [-1, 1], in gentle waves.
SceneGeometry net(std::uint32_t side) {
  SceneGeometry scene;
  for (std::uint32_t row = 0; row <= side; ++row) {
    for (std::uint32_t column = 0; column <= side; ++column) {
      const double x = 2.0 * column / side - 1.0, z = 2.0 * row / side - 1.0;
      scene.positions.emplace_back(x, 0.05 * std::sin(5 * x) * std::sin(4 * z), z);
      const std::uint32_t here = row * (side + 1) + column;
      if (column < side) scene.edges.push_back({here, here + 1});
      if (row < side) scene.edges.push_back({here, here + side + 1});
    }
  }
  finishScene(scene);
  return scene;
}

std::vector<DrawItem> itemsOf(const SharedDrawable& scene, const ViewProjection& view,
                              const Space& space = {}, bool asPoints = false) {
  DrawList list;
  list.view = view;
  ScenePart().add(list, {{scene}, space, asPoints, 1.2f}, theme(ThemeKind::kDark));
  return list.items;
}

std::size_t elements(const std::vector<DrawItem>& items) {
  std::size_t sum = 0;
  for (const DrawItem& item : items) sum += item.count;
  return sum;
}

std::size_t whole(const DrawableScene::Tiles& tiles) {
  std::size_t sum = 0;
  for (const auto& tile : tiles) sum += tile.details.front().geometry->elements();
  return sum;
}

Vec3 placeOf(const Placement& place, const GeometryPoint& p) { return place.at({p.x, p.y, p.z}); }

TEST(DrawableScene, SmallScenesAreWhole) {
  Random random(3);
  const SceneGeometry scene = net(100);
  const SharedDrawable drawable = DrawableScene::make(scene);
  const ViewProjection view = viewProjection(EditorView{}, {0, 0, 800, 600});
  const auto items = itemsOf(drawable, view);
  EXPECT_EQ(elements(items), scene.edges.size());
  // Every edge once, to a part in ten million of the scene's size.
  std::multiset<std::array<double, 3>> expected, found;
  const auto rounded = [](const Vec3& p) {
    return std::array{std::round(p.x * 1e5), std::round(p.y * 1e5), std::round(p.z * 1e5)};
  };
  for (const auto& edge : scene.edges) {
    expected.insert(rounded(0.5 * (scene.positions[edge[0]] + scene.positions[edge[1]])));
  }
  for (const DrawItem& item : items) {
    const auto& points = item.geometry->points;
    EXPECT_LE(points.size(), 65536u);  // what a buffer texture holds at least
    for (std::size_t i = 0; i < points.size(); i += 2) {
      found.insert(
          rounded(0.5 * (placeOf(item.place, points[i]) + placeOf(item.place, points[i + 1]))));
    }
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(elements(itemsOf(drawable, view, {}, true)), scene.positions.size());
}

TEST(DrawableScene, StandsInTheCubeAsTheSpaceSays) {
  SceneGeometry scene;
  scene.positions = {{1000, 2000, -500}, {1004, 2002, -500}, {1001, 2000, -499}};
  scene.edges = {{0, 1}, {0, 2}};
  const SharedDrawable drawable = DrawableScene::make(scene);
  EXPECT_EQ(drawable->box(), (BoundingBox{{1000, 2000, -500}, {1004, 2002, -499}}));
  const Space space{{1002, 2001, -499.5}, 4.0};
  const auto items = itemsOf(drawable, viewProjection(EditorView{}, {0, 0, 800, 600}), space);
  ASSERT_EQ(items.size(), 1u);
  const auto& points = items[0].geometry->points;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 expected = space.toCube(scene.positions[scene.edges[i / 2][i % 2]]);
    EXPECT_LT(glm::distance(placeOf(items[0].place, points[i]), expected), 1e-6);
  }
}

TEST(DrawableScene, ExtremeScenesAreFinite) {
  const double most = std::numeric_limits<double>::max();
  for (const std::vector<Vec3>& positions : std::vector<std::vector<Vec3>>{
           {{1, 2, 3}}, {{-most, 0, 0}, {most, 1, 0}}, {{0, 0, 0}, {5e-324, 0, 0}}}) {
    SceneGeometry scene;
    scene.positions = positions;
    if (positions.size() > 1) scene.edges = {{0, 1}};
    const SharedDrawable drawable = DrawableScene::make(scene);
    for (const auto& tile : drawable->positions()) {
      EXPECT_TRUE(std::isfinite(tile.place.unit));
      EXPECT_GT(tile.place.unit, 0.0);
      for (const GeometryPoint& p : tile.details[0].geometry->points) {
        EXPECT_LE(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 2.0f);
      }
    }
  }
  EXPECT_TRUE(DrawableScene::make({})->edges().empty());
}

TEST(DrawableScene, LargeScenesStayWithinTheLimit) {
  const SceneGeometry scene = net(420);
  ASSERT_GT(scene.edges.size(), 2 * kMostSceneElements);
  const SharedDrawable drawable = DrawableScene::make(scene);
  EXPECT_EQ(whole(drawable->edges()), scene.edges.size());
  EXPECT_EQ(whole(drawable->positions()), scene.positions.size());
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    const ViewProjection view = test::randomView(random);
    EXPECT_LE(elements(itemsOf(drawable, view)), kMostSceneElements);
    EXPECT_LE(elements(itemsOf(drawable, view, {}, true)), kMostSceneElements);
  }
}

TEST(DrawableScene, FromNearItIsWhole) {
  const SceneGeometry scene = net(420);
  const SharedDrawable drawable = DrawableScene::make(scene);
  EditorView near;
  near.size = 20.0;
  const ViewProjection view = viewProjection(near, {0, 0, 800, 600});
  // Every edge that is seen is there, with its own ends.
  std::vector<Vec3> drawn;
  const auto items = itemsOf(drawable, view);
  for (const DrawItem& item : items) {
    for (const GeometryPoint& p : item.geometry->points) {
      drawn.push_back(placeOf(item.place, p));
    }
  }
  std::size_t seen = 0;
  for (const Vec3& position : scene.positions) {
    const auto pixel = view.project(position);
    if (!pixel || pixel->x < 0 || pixel->x > 800 || pixel->y < 0 || pixel->y > 600) continue;
    EXPECT_TRUE(std::ranges::any_of(
        drawn, [&](const Vec3& p) { return glm::distance(p, position) < 1e-7; }));
    ++seen;
  }
  EXPECT_GT(seen, 100u);
  EXPECT_LT(elements(items), scene.edges.size() / 4);  // and little of what is not seen
}

// What is joined lies less than a cell from where it was, and hardly anything is bare that was
// covered.
TEST(DrawableScene, CoarserDetailsCoverTheSame) {
  const SceneGeometry scene = net(420);
  const SharedDrawable drawable = DrawableScene::make(scene);
  std::size_t coarser = 0;
  for (const auto& tile : drawable->edges()) {
    const auto& finest = tile.details.front().geometry->points;
    std::size_t before = finest.size();
    for (const auto& detail : tile.details) {
      if (detail.level == DrawableScene::kWhole) continue;
      const double cell = drawable->cells().levels()[static_cast<std::size_t>(detail.level)].cell;
      ++coarser;
      EXPECT_LT(detail.geometry->points.size(), before);
      before = detail.geometry->points.size();
      EXPECT_GT(before, 0u);
      // Every corner of the coarse one has one of the whole within its cell, and the other way.
      const auto near = [&](const GeometryPoint& p, const std::vector<GeometryPoint>& others) {
        const auto limit = static_cast<float>(cell / tile.place.unit * 1.0001);
        return std::ranges::any_of(others, [&](const GeometryPoint& q) {
          return std::abs(p.x - q.x) <= limit && std::abs(p.y - q.y) <= limit &&
                 std::abs(p.z - q.z) <= limit;
        });
      };
      const auto& points = detail.geometry->points;
      for (std::size_t i = 0; i < points.size(); i += 7) EXPECT_TRUE(near(points[i], finest));
      for (std::size_t i = 0; i < finest.size(); i += 211) EXPECT_TRUE(near(finest[i], points));
    }
  }
  EXPECT_GT(coarser, drawable->edges().size());
}

// However little of it is drawn, it is drawn everywhere.
TEST(DrawableScene, NothingHasHoles) {
  Random random(17);
  for (const std::uint32_t side : {100u, 200u, 300u}) {
    const SceneGeometry scene = net(side);
    const SharedDrawable drawable = DrawableScene::make(scene);
    for (int round = 0; round < 12; ++round) {
      EditorView editorView;
      editorView.turn = random.between(-180, 180);
      editorView.tilt = random.between(15, 90);  // the net lies flat
      editorView.size = random.between(0.5, 3.0);
      editorView.type = random.coin() ? ProjectionType::Parallel : ProjectionType::Perspective;
      const PixelRectangle picture =
          random.coin() ? PixelRectangle{0, 0, 232, 131} : PixelRectangle{0, 0, 720, 620};
      const ViewProjection view = viewProjection(editorView, picture);
      constexpr double kCell = 16.0;  // pixels
      std::set<std::pair<int, int>> drawn;
      const auto cellOf = [&](const Vec2& pixel) {
        return std::pair(static_cast<int>(std::floor(pixel.x / kCell)),
                         static_cast<int>(std::floor(pixel.y / kCell)));
      };
      for (const DrawItem& item : itemsOf(drawable, view)) {
        for (std::size_t i = 0; i < 2 * item.count; ++i) {
          const auto pixel = view.project(placeOf(item.place, item.geometry->points[i]));
          if (pixel) drawn.insert(cellOf(*pixel));
        }
      }
      std::size_t seen = 0, bare = 0;
      for (std::size_t i = 0; i < scene.positions.size(); i += 3) {
        const auto pixel = view.project(scene.positions[i]);
        if (!pixel || pixel->x < 0 || pixel->x >= picture.width || pixel->y < 0 ||
            pixel->y >= picture.height) {
          continue;
        }
        ++seen;
        const auto [x, y] = cellOf(*pixel);
        bool near = false;
        for (int dx = -1; dx <= 1; ++dx) {
          for (int dy = -1; dy <= 1; ++dy) near = near || drawn.contains({x + dx, y + dy});
        }
        bare += near ? 0 : 1;
      }
      EXPECT_GT(seen, 10u);
      EXPECT_EQ(bare, 0u) << "of " << seen;
    }
  }
}

TEST(DrawableScene, LongLinesAcrossEachOtherStayWithinTheLimit) {
  Random random(9);
  SceneGeometry scene;
  for (int i = 0; i < 20000; ++i) scene.positions.push_back(random.inCube());
  for (std::uint32_t i = 0; i < 3 * kMostSceneElements; ++i) {
    scene.edges.push_back({i % 20000, static_cast<std::uint32_t>(random.between(0, 19999))});
  }
  finishScene(scene);
  ASSERT_GT(scene.edges.size(), 2 * kMostSceneElements);
  const auto drawable = DrawableScene::make(scene);
  const std::size_t count =
      elements(itemsOf(drawable, viewProjection(EditorView{}, {0, 0, 800, 600})));
  EXPECT_LE(count, kMostSceneElements);
  EXPECT_GT(count, 40000u);  // 800 x 600 pixels have room for 48,000
}

TEST(DrawableScene, WhatIsOutsideThePictureIsLeftOut) {
  SceneGeometry scene = net(100);
  for (Vec3& position : scene.positions) position.z += 10.0;
  const SharedDrawable drawable = DrawableScene::make(scene);
  const auto seen = [&](const Vec3& normal) {
    return elements(
        itemsOf(drawable, viewProjection({0, 0.5, 0}, normal, {0, 1, 0}, 0.5, {0, 0, 800, 600})));
  };
  EXPECT_EQ(seen({0, 0, 1}), scene.edges.size());
  EXPECT_EQ(seen({0, 0, -1}), 0u);
}

TEST(DrawableScene, MakingCanBeStopped) {
  const SceneGeometry scene = net(300);
  double last = 0.0;
  int told = 0;
  const auto drawable = DrawableScene::make(scene, [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
    ++told;
    return true;
  });
  EXPECT_TRUE(drawable);
  EXPECT_GT(told, 10);
  for (int most = 0; most < told; most += 1 + told / 12) {
    int left = most;
    EXPECT_EQ(DrawableScene::make(scene, [&](double) { return left-- > 0; }), nullptr);
  }
}

}  // namespace
}  // namespace vides
