// SPDX-License-Identifier: MIT
// Any bytes as an OBJ file: refused with the place of the fault, or a scene of which everything
// holds that scene_geometry.hpp promises.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "flight/text_encoding.hpp"
#include "flight/utf8.hpp"
#include "fuzz/require.hpp"
#include "scene/drawable_scene.hpp"
#include "scene/obj_reader.hpp"

namespace vides::test {
namespace {

// At most: UTF-16 has fewer.
std::int64_t linesOf(std::string_view text) {
  const auto end = [](char c) { return c == '\n' || c == '\r'; };
  return std::count_if(text.begin(), text.end(), end) + 1;
}

void checkWord(const std::string& word) {
  require(word.size() <= 4 * 32 + 3, "what was found is told shortly");
  require(codePoints(word).has_value() &&
              std::none_of(word.begin(), word.end(),
                           [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }),
          "what was found upsets no terminal");
}

void checkReport(std::string_view text, const SceneGeometry& scene) {
  const SceneReport& report = scene.report;
  require(report.vertices == static_cast<std::int64_t>(scene.positions.size()),
          "what is drawn is counted");
  require(report.points == static_cast<std::int64_t>(scene.points.size()), "points are counted");
  require(report.faces + report.lines <= linesOf(text), "faces and lines have statements");
  for (const SceneNote& note : report.notes) {
    const bool alone = note.remark == SceneRemark::kVerticesOnly;
    require(note.count > 0 && (alone || note.count <= linesOf(text)), "what is noted was there");
    require(alone ? note.line == 0 : note.line >= 1 && note.line <= linesOf(text),
            "a note is of a line");
    checkWord(note.found);
  }
}

void checkProblem(std::string_view text, const SceneProblem& problem) {
  require(problem.line >= 0 && problem.line <= linesOf(text), "a fault is in a line of the file");
  const std::string& words = problem.found;
  checkWord(words);
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

// The coordinates that are finite as the C library reads them; only of plain files.
std::vector<Vec3> positionsIn(const std::string& text) {
  std::vector<Vec3> positions;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string word;
    words >> word;
    if (word != "v") continue;
    Vec3 position(0.0);
    for (int i = 0; i < 3 && words >> word; ++i) position[i] = std::strtod(word.c_str(), nullptr);
    if (std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z)) {
      positions.push_back(position);
    }
  }
  return positions;
}

// Without continued lines, NUL, other line ends and what only looks like a comment.
bool plain(std::string_view text) {
  constexpr std::string_view kOdd("\\\v\f\0\r$", 6);
  return text.find_first_of(kOdd) == text.npos && text.find(".#") == text.npos &&
         !text.starts_with("\xef\xbb\xbf");
}

// Whether all of one list stand in the other, in the same order.
bool partOf(const std::vector<Vec3>& part, const std::vector<Vec3>& all) {
  auto at = all.begin();
  for (const Vec3& position : part) {
    at = std::find(at, all.end(), position);
    if (at++ == all.end()) return false;
  }
  return true;
}

void checkDrawable(const SceneGeometry& scene) {
  const SharedDrawable drawable = DrawableScene::make(scene);
  const auto check = [](const DrawableScene::Tiles& tiles, std::size_t elements) {
    std::size_t sum = 0;
    for (const auto& tile : tiles) {
      for (const GeometryPoint& p : tile.details.front().geometry->points) {
        require(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 2.0f,
                "what is drawn is within -2 and 2");
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
  require(scene.positions.size() * 5 <= text.size() + 1, "no vertex comes from nowhere");
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
  std::vector<bool> drawn(count);
  for (const auto& edge : scene.edges) drawn[edge[0]] = drawn[edge[1]] = true;
  for (const std::uint32_t point : scene.points) drawn[point] = true;
  require(std::find(drawn.begin(), drawn.end(), false) == drawn.end(), "every position is drawn");
  checkBox(scene);
  checkReport(text, scene);
  checkDrawable(scene);
  if (plain(text)) {
    const auto all = positionsIn(std::string(text));
    const auto& notes = scene.report.notes;
    const bool alone = !notes.empty() && notes.back().remark == SceneRemark::kVerticesOnly;
    require(alone ? scene.positions == all : partOf(scene.positions, all),
            "numbers are as others read them");
  }
}

bool same(const SceneGeometry& a, const SceneGeometry& b) {
  return a.positions == b.positions && a.edges == b.edges && a.triangles == b.triangles &&
         a.points == b.points && a.box == b.box && a.report == b.report;
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
  if (encodingOf(text) != TextEncoding::kUtf8) return 0;
  // A line more, which doesn't count, changes nothing; a damaged one gives nothing at all. (After
  // an empty line, because the last one may end with a mark to go on.)
  const std::string before(text);
  const ReadScene more = readObj(before + "\n\ng more\n");
  require(more && same(*more, *scene), "what doesn't count is passed over");
  require(!readObj(before + "\n\nv 1 2 x\n"), "a scene is never read in part");
  // Line ends of another kind change nothing: CR ends a line wherever LF does.
  if (before.find('\r') == before.npos) {
    std::string other = before;
    std::replace(other.begin(), other.end(), '\n', '\r');
    const ReadScene again = readObj(other);
    require(again && same(*again, *scene), "line ends are all the same");
  }
  return 0;
}
