// SPDX-License-Identifier: MIT
// Any bytes as an OBJ file: refused with the place of the fault, or a scene of which everything
// holds that scene_geometry.hpp promises.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "fuzz/require.hpp"
#include "scene/drawable_scene.hpp"
#include "scene/obj_reader.hpp"

namespace vides::test {
namespace {

void checkProblem(std::string_view text, const SceneProblem& problem) {
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  require(problem.line >= 0 && problem.line <= lines, "a fault is in a line of the file");
  const std::string& words = problem.found;
  require(words.size() < 40, "what was found is told shortly");
  require(std::all_of(words.begin(), words.end(), [](char c) { return c >= ' ' && c <= '~'; }),
          "a fault upsets no terminal");
}

void checkBox(const SceneGeometry& scene) {
  require(scene.box.has_value(), "a scene has a box");
  BoundingBox box{scene.positions.front(), scene.positions.front()};
  for (const Vec3& position : scene.positions) {
    for (int i = 0; i < 3; ++i) {
      require(std::isfinite(position[i]), "positions are finite");
      box.low[i] = std::min(box.low[i], position[i]);
      box.high[i] = std::max(box.high[i], position[i]);
    }
  }
  require(*scene.box == box, "the box is that of the positions");
}

// The coordinates as the C library reads them; only of files without continued lines and NUL.
std::vector<Vec3> positionsIn(const std::string& text) {
  std::vector<Vec3> positions;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string word;
    words >> word;
    if (word != "v") continue;
    Vec3 position;
    for (int i = 0; i < 3 && words >> word; ++i) position[i] = std::strtod(word.c_str(), nullptr);
    positions.push_back(position);
  }
  return positions;
}

bool plain(std::string_view text) {
  constexpr std::string_view kOdd("\\\v\f\0", 4);
  return text.find_first_of(kOdd) == text.npos && !text.starts_with("\xef\xbb\xbf");
}

void checkDrawable(const SceneGeometry& scene) {
  const SharedDrawable drawable = DrawableScene::make(scene);
  const auto check = [](const DrawableScene::Tiles& tiles, std::size_t elements) {
    std::size_t sum = 0;
    for (const auto& tile : tiles) {
      for (const GeometryPoint& p : tile.details.front().geometry->points) {
        require(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 1.0f,
                "what is drawn is within -1 and 1");
      }
      sum += tile.details.front().geometry->elements();
    }
    require(sum == elements, "everything is drawn");
  };
  check(drawable->edges(), scene.edges.size());
  check(drawable->points(), scene.points.size());
  check(drawable->positions(), scene.positions.size());
}

void checkScene(std::string_view text, const SceneGeometry& scene) {
  require(!scene.positions.empty(), "a scene has a vertex");
  // "v 0 0 0", "f 1 1 1": nothing grows beyond what the file has words for.
  require(scene.positions.size() * 6 <= text.size(), "no vertex comes from nowhere");
  require((scene.edges.size() + scene.triangles.size() + scene.points.size()) <= text.size() * 2,
          "no more is drawn than the file has words for");
  const std::size_t count = scene.positions.size();
  for (const auto& edge : scene.edges) {
    require(edge[0] < edge[1] && edge[1] < count, "an edge goes from a vertex to a later one");
  }
  require(std::adjacent_find(scene.edges.begin(), scene.edges.end(),
                             [](const auto& a, const auto& b) { return !(a < b); }) ==
              scene.edges.end(),
          "edges are sorted, each there once");
  for (const auto& triangle : scene.triangles) {
    for (const std::uint32_t corner : triangle) require(corner < count, "corners are vertices");
  }
  for (const std::uint32_t point : scene.points) require(point < count, "points are vertices");
  checkBox(scene);
  checkDrawable(scene);
  if (plain(text)) {
    require(scene.positions == positionsIn(std::string(text)), "numbers are as others read them");
  }
}

bool same(const SceneGeometry& a, const SceneGeometry& b) {
  return a.positions == b.positions && a.edges == b.edges && a.triangles == b.triangles &&
         a.points == b.points && a.box == b.box;
}

}  // namespace
}  // namespace vides::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vides;
  using namespace vides::test;
  const std::string_view text = asText(data, size);
  const ReadScene scene = readObj(text);
  if (!scene) {
    checkProblem(text, scene.error());
    return 0;
  }
  checkScene(text, *scene);
  // A line more, which doesn't count, changes nothing; a damaged one gives nothing at all. (After
  // an empty line, because the last one may end with a mark to go on.)
  const std::string before(text);
  const ReadScene more = readObj(before + "\n\ng more\n");
  require(more && same(*more, *scene), "what doesn't count is passed over");
  require(!readObj(before + "\n\nv 1 2 x\n"), "a scene is never read in part");
  return 0;
}
