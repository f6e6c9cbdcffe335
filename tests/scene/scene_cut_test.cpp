// SPDX-License-Identifier: MIT
// Large scenes: blocks of different detail meet, and how fine it is changes bit by bit. Scenes that
// reach far: what is far away takes nothing from the rest.
#include "scene/scene_cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "scene/scene_part.hpp"

namespace vides {
namespace {

// A net of side × side squares over x and z of [-1, 1], in gentle waves, each cut into triangles
// and a little crooked, so that the mean of some positions is not the place of another.
SceneGeometry net(std::uint32_t side) {
  SceneGeometry scene;
  for (std::uint32_t row = 0; row <= side; ++row) {
    for (std::uint32_t column = 0; column <= side; ++column) {
      const double x = 2.0 * column / side - 1.0, z = 2.0 * row / side - 1.0;
      const std::uint32_t here = row * (side + 1) + column;
      const double aside = 0.3 / side * std::sin(0.7 * here * here);
      scene.positions.emplace_back(x + aside, 0.05 * std::sin(5 * x) * std::sin(4 * z), z - aside);
      if (column < side) scene.edges.push_back({here, here + 1});
      if (row < side) scene.edges.push_back({here, here + side + 1});
      if (row < side && column < side) scene.edges.push_back({here + 1, here + side + 1});
    }
  }
  finishScene(scene);
  return scene;
}

// Over the near edge of the net, along it to the far one.
ViewProjection cameraOver(double height = 0.25, double steep = 0.25) {
  const Vec3 normal = glm::normalize(Vec3(0, -steep, -1));
  const Vec3 up = glm::normalize(Vec3(0, 1, 0) - normal * normal.y);
  return viewProjection({0, height, 0.9}, normal, up, 0.9, {0, 0, 640, 360});
}

std::vector<SeenDetail> seenOf(SceneCut& cut, const SharedDrawable& scene,
                               const ViewProjection& view) {
  return cut.see({{scene, &DrawableScene::edges, Placement{}}}, view, 2.0);
}

using Place = std::array<std::int64_t, 3>;
// As coarse as floats: places that are meant to be the same are told apart from all others.
Place rounded(const Vec3& at) {
  return {std::llround(1e5 * at.x), std::llround(1e5 * at.y), std::llround(1e5 * at.z)};
}
Place placeOf(const SeenDetail& detail, std::size_t point) {
  const GeometryPoint& p = detail.geometry->points[point];
  return rounded(detail.place.at({p.x, p.y, p.z}));
}

// Whatever tile an edge is of: of a position, the cells that it lies in and their means only one is
// drawn, so that what leads there meets.
TEST(SceneCut, BlocksOfDifferentDetailMeet) {
  const SceneGeometry geometry = net(400);
  const SharedDrawable scene = DrawableScene::make(geometry);
  ASSERT_GT(scene->edges().size(), 30u);
  const auto& levels = scene->cells().levels();
  ASSERT_GT(levels.size(), 3u);
  SceneCut cut;
  for (const double height : {0.15, 0.25, 0.5, 1.2}) {
    std::set<Place> drawn;
    std::size_t count = 0;
    for (const SeenDetail& detail : seenOf(cut, scene, cameraOver(height))) {
      ASSERT_EQ(detail.count, detail.geometry->elements());  // none is left out
      count += detail.count;
      for (std::size_t i = 0; i < 2 * detail.count; ++i) drawn.insert(placeOf(detail, i));
    }
    EXPECT_LT(count, 60000u);
    EXPECT_GT(count, 5000u);
    std::set<std::size_t> used;  // levels
    std::size_t twice = 0;
    for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
      std::set<Place> places;
      const auto see = [&](const Vec3& at) {
        const Place place = rounded(at);
        return drawn.contains(place) && places.insert(place).second;
      };
      see(geometry.positions[i]);
      std::uint32_t cell = scene->cells().cells()[i];
      for (std::size_t level = 0; level < levels.size(); ++level) {
        if (see(levels[level].means[cell])) used.insert(level);
        if (level + 1 < levels.size()) cell = levels[level].parent[cell];
      }
      twice += places.size() > 1 ? 1 : 0;
    }
    EXPECT_EQ(twice, 0u) << "at height " << height;
    EXPECT_GT(used.size(), 1u);
  }
}

// From near to far and from block to block, the lines stand about as close in the picture.
TEST(SceneCut, DensityChangesBitByBit) {
  const SharedDrawable scene = DrawableScene::make(net(500));
  SceneCut cut;
  const ViewProjection view = cameraOver(0.7, 1.0);
  constexpr int kCell = 40;  // pixels
  std::map<std::pair<int, int>, int> ends;
  for (const SeenDetail& detail : seenOf(cut, scene, view)) {
    for (std::size_t i = 0; i < 2 * detail.count; ++i) {
      const GeometryPoint& p = detail.geometry->points[i];
      const Vec3 at = detail.place.at({p.x, p.y, p.z});
      const auto pixel = view.project(at);
      if (!pixel || std::max(std::abs(at.x), std::abs(at.z)) > 0.95) continue;
      ++ends[{static_cast<int>(std::floor(pixel->x / kCell)),
              static_cast<int>(std::floor(pixel->y / kCell))}];
    }
  }
  int compared = 0;
  for (const auto& [cell, count] : ends) {
    const auto [x, y] = cell;
    if (x < 1 || x > 14 || y < 2 || y > 7) continue;  // whole cells, all of the net
    const auto right = ends.find({x + 1, y}), below = ends.find({x, y + 1});
    for (const auto& other : {right, below}) {
      if (other == ends.end() || other->first.first > 14 || other->first.second > 7) continue;
      const double ratio = static_cast<double>(count) / other->second;
      EXPECT_LT(std::max(ratio, 1.0 / ratio), 2.5) << x << ' ' << y;
      ++compared;
    }
  }
  EXPECT_GT(compared, 40);
}

TEST(SceneCut, TheSameViewHasTheSameGeometry) {
  const SharedDrawable scene = DrawableScene::make(net(300));
  SceneCut cut;
  const auto first = seenOf(cut, scene, cameraOver());
  const auto second = seenOf(cut, scene, cameraOver());
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].geometry, second[i].geometry);
  }
  // Seen the other way and back: nothing of that view stays.
  SceneCut fresh;
  seenOf(cut, scene, cameraOver(1.5));
  const auto third = seenOf(cut, scene, cameraOver()), anew = seenOf(fresh, scene, cameraOver());
  ASSERT_EQ(third.size(), anew.size());
  for (std::size_t i = 0; i < third.size(); ++i) {
    EXPECT_EQ(third[i].geometry->points, anew[i].geometry->points);
  }
}

// Where the scene's positions are drawn, compared with where they are.
double worstError(const SceneGeometry& scene, double within) {
  const SharedDrawable drawable = DrawableScene::make(scene);
  double worst = 0.0;
  std::size_t drawn = 0;
  for (const auto& tile : drawable->positions()) {
    for (const GeometryPoint& p : tile.details.front().geometry->points) {
      const Vec3 at = tile.place.at({p.x, p.y, p.z});
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec3& position : scene.positions) {
        nearest = std::min(nearest, glm::distance(at, position));
      }
      ++drawn;
      if (glm::length(at) < within) worst = std::max(worst, nearest);
    }
  }
  EXPECT_EQ(drawn, scene.positions.size());
  return worst;
}

TEST(DrawableScene, AFarMarkerDoesNoHarm) {
  SceneGeometry scene = net(30);
  for (const Vec3& marker : {Vec3(1e9, 0, 0), Vec3(0, -3e8, 5e8)}) {
    scene.positions.push_back(marker);
    scene.points.push_back(static_cast<std::uint32_t>(scene.positions.size() - 1));
  }
  // A line from the middle out there, too.
  scene.edges.push_back({400, static_cast<std::uint32_t>(scene.positions.size() - 1)});
  finishScene(scene);
  EXPECT_LT(worstError(scene, 10.0), 1e-7);
  const SharedDrawable drawable = DrawableScene::make(scene);
  for (const auto& tile : drawable->edges()) {
    for (const GeometryPoint& p : tile.details.front().geometry->points) {
      const Vec3 at = tile.place.at({p.x, p.y, p.z});
      if (glm::length(at) > 10.0) continue;
      EXPECT_TRUE(std::ranges::any_of(scene.positions, [&](const Vec3& position) {
        return glm::distance(at, position) < 1e-7;
      }));
    }
  }
}

TEST(DrawableScene, AMillimetreIsSeenAtSixThousandKilometres) {
  SceneGeometry scene;
  // Two pairs at the ends of the earth.
  scene.positions = {{6e6, 1, 0}, {6e6 + 1e-3, 1, 0}, {-6e6, 0, 0}, {-6e6, 1e-3, 0}, {0, 0, 0}};
  scene.edges = {{0, 1}, {2, 3}};
  scene.points = {4};
  finishScene(scene);
  const SharedDrawable drawable = DrawableScene::make(scene);
  std::size_t edges = 0;
  for (const auto& tile : drawable->edges()) {
    const auto& points = tile.details.front().geometry->points;
    for (std::size_t i = 0; i < points.size(); i += 2, ++edges) {
      const Vec3 a = tile.place.at({points[i].x, points[i].y, points[i].z});
      const Vec3 b = tile.place.at({points[i + 1].x, points[i + 1].y, points[i + 1].z});
      EXPECT_NEAR(glm::distance(a, b), 1e-3, 1e-5);
    }
  }
  EXPECT_EQ(edges, 2u);
}

// The grids are as fine as most of the scene wants them.
TEST(DrawableScene, AFarMarkerLeavesTheGridsFine) {
  SceneGeometry scene = net(200);
  const SharedDrawable without = DrawableScene::make(scene);
  scene.positions.push_back({1e7, 0, 0});
  scene.points.push_back(static_cast<std::uint32_t>(scene.positions.size() - 1));
  finishScene(scene);
  const SharedDrawable with = DrawableScene::make(scene);
  const auto& levels = with->cells().levels();
  ASSERT_EQ(levels.size(), without->cells().levels().size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    EXPECT_NEAR(levels[i].cell / without->cells().levels()[i].cell, 1.0, 0.01);
    EXPECT_EQ(levels[i].means.size(), without->cells().levels()[i].means.size() + 1);
  }
}

}  // namespace
}  // namespace vides
