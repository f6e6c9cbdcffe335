// SPDX-License-Identifier: MIT
// OBJ files: what they hold, each fault with its line, other readers' verdict, and damaged files.
#include "scene/obj_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <tiny_obj_loader.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace vides {
namespace {

namespace fs = std::filesystem;
using Edge = std::array<std::uint32_t, 2>;
using Triangle = std::array<std::uint32_t, 3>;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

constexpr std::string_view kPyramid = R"(# a pyramid
mtllib ../../../etc/passwd
o pyramid
v -0.5 0 0.5
v 0.5 0 0.5
v 0.5 0 -0.5
v -0.5 0 -0.5
v 0 0.5 0
vn 0 -1 0
usemtl stone
f 4//1 3//1 2//1 1//1
f 1 2 5
f 2 3 5
f 3 4 -1
f -2 1 5
)";

class ObjFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("obj_files_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, std::string_view text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  fs::path folder_;
};

SceneProblem problemOf(std::string_view text) {
  const auto scene = readObj(text);
  EXPECT_FALSE(scene) << text;
  return scene ? SceneProblem{} : scene.error();
}

TEST(Obj, Pyramid) {
  const auto scene = readObj(kPyramid);
  ASSERT_TRUE(scene) << "line " << scene.error().line;
  EXPECT_EQ(scene->positions.size(), 5u);
  EXPECT_THAT(scene->edges, ElementsAre(Edge{0, 1}, Edge{0, 3}, Edge{0, 4}, Edge{1, 2}, Edge{1, 4},
                                        Edge{2, 3}, Edge{2, 4}, Edge{3, 4}));
  EXPECT_THAT(scene->triangles,
              ElementsAre(Triangle{3, 2, 1}, Triangle{3, 1, 0}, Triangle{0, 1, 4},
                          Triangle{1, 2, 4}, Triangle{2, 3, 4}, Triangle{3, 0, 4}));
  EXPECT_TRUE(scene->points.empty());
  EXPECT_EQ(scene->box, (BoundingBox{{-0.5, 0, -0.5}, {0.5, 0.5, 0.5}}));
}

TEST(Obj, LinesAndPoints) {
  const auto scene =
      readObj("v 0 0 0\nv 1 0 0 0.5\nv 1 1 0 1 0 0\nl 1/1 2/2 3\nl -1 -3\np 1 3\np 2");
  ASSERT_TRUE(scene);
  EXPECT_THAT(scene->edges, ElementsAre(Edge{0, 1}, Edge{0, 2}, Edge{1, 2}));
  EXPECT_THAT(scene->points, ElementsAre(0u, 2u, 1u));
}

TEST(Obj, WrittenInMoreThanOneWay) {
  // Windows' line ends, a continued line, a comment behind, a byte order mark, signs and exponents.
  const auto scene = readObj(
      "\xef\xbb\xbfv +1 -2.5e-1 1E2\r\nv 0 0\\\r\n 7 # seven\r\n# C:\\\n"
      "\tl\t1 \\\n2\nv .5 5. -0\np 3");
  ASSERT_TRUE(scene) << "line " << scene.error().line;
  EXPECT_THAT(scene->positions, ElementsAre(Vec3(1, -0.25, 100), Vec3(0, 0, 7), Vec3(0.5, 5, 0)));
  EXPECT_THAT(scene->edges, ElementsAre(Edge{0, 1}));
  EXPECT_EQ(readObj("v 1e-400 0 0")->positions.front(), Vec3(0));
}

TEST(Obj, FacesOfAnySize) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "v " + std::to_string(i) + " 0 0\n";
  text += "f";
  for (int i = 1; i <= 1000; ++i) text += " " + std::to_string(i);
  const auto scene = readObj(text);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->edges.size(), 1000u);
  EXPECT_EQ(scene->triangles.size(), 998u);
}

// What counts is how large the number is, not how it is written.
TEST(Obj, NumbersBeyondADoubleAreNothingOrAFault) {
  const std::string zeros(400, '0');
  for (const std::string& tiny :
       {std::string("1e-400"), "-0." + zeros + "1", "0." + zeros + "1e+50", "." + zeros + "7e20",
        zeros + "." + zeros + "1", "1" + zeros + "e-800", std::string("1e-99999999999999999999")}) {
    const auto scene = readObj("v 0 " + tiny + " 1");
    ASSERT_TRUE(scene) << tiny;
    EXPECT_EQ(scene->positions.front(), (Vec3{0.0, 0.0, 1.0})) << tiny;
  }
  for (const std::string& huge :
       {std::string("1e400"), "1" + zeros, "1" + zeros + "e-5", "-1" + zeros + ".5E-20",
        "0." + zeros + "1e800", std::string("1e99999999999999999999")}) {
    EXPECT_EQ(problemOf("v 0 " + huge + " 1\np 1").fault, SceneFault::kBadVertex) << huge;
  }
  // Not every one with that many digits lies beyond it.
  EXPECT_EQ(readObj("v 1" + zeros + "e-400 0 0")->positions.front().x, 1.0);
  EXPECT_EQ(readObj("v 0." + zeros + "1e401 0 0")->positions.front().x, 1.0);
}

TEST(Obj, FaultsAreToldWithTheirLine) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto is = [](SceneFault fault, std::int64_t line, const char* found) {
    return SceneProblem{fault, line, found};
  };
  EXPECT_EQ(problemOf("#\n\nv 1 2 x"), is(SceneFault::kNumber, 3, "x"));
  EXPECT_EQ(problemOf("v 1 2,5 3"), is(SceneFault::kNumber, 1, "2,5"));
  EXPECT_EQ(problemOf("v 1 +-2 3"), is(SceneFault::kNumber, 1, "+-2"));
  EXPECT_EQ(problemOf(three + "f 1 2 0"), is(SceneFault::kIndex, 4, "0"));
  EXPECT_EQ(problemOf(three + "f 1 2 three"), is(SceneFault::kIndex, 4, "three"));
  EXPECT_EQ(problemOf(three + "f 1 2 /3"), is(SceneFault::kIndex, 4, "/3"));
  EXPECT_EQ(problemOf(three + "f 1 2 3.0"), is(SceneFault::kIndex, 4, "3.0"));
  EXPECT_EQ(problemOf(three + "f 1/a 2 3"), is(SceneFault::kIndex, 4, "1/a"));
  EXPECT_EQ(problemOf(three + "f 1/1/1/1 2 3"), is(SceneFault::kIndex, 4, "1/1/1/1"));
  EXPECT_EQ(problemOf(three + "l 1 b"), is(SceneFault::kIndex, 4, "b"));
  EXPECT_EQ(problemOf(three + "p 1 p 2"), is(SceneFault::kIndex, 4, "p"));
  EXPECT_EQ(problemOf(three + "f 1 2 4"), is(SceneFault::kNoSuchVertex, 4, "4"));
  EXPECT_EQ(problemOf(three + "f 1 9"), is(SceneFault::kNoSuchVertex, 4, "9"));
  EXPECT_EQ(problemOf("f 1 2 4\nf 1 2 6\nf 5 6 7\n" + three + "v 1 1 1"),
            is(SceneFault::kNoSuchVertex, 2, "6"));
  EXPECT_EQ(problemOf(three + "f 1 2 -4/1/1"), is(SceneFault::kNoSuchVertex, 4, "-4/1/1"));
  EXPECT_EQ(problemOf("f -1 -2 -3\n" + three), is(SceneFault::kNoSuchVertex, 1, "-1"));
  for (const char* huge : {"4294967297", "99999999999999999999", "-99999999999999999999"}) {
    EXPECT_EQ(problemOf(three + "f 1 2 " + huge), is(SceneFault::kNoSuchVertex, 4, huge));
  }
  EXPECT_EQ(problemOf(""), is(SceneFault::kNothing, 0, ""));
  EXPECT_EQ(problemOf("# nothing\nvt 0 0\n"), is(SceneFault::kNothing, 0, ""));
  EXPECT_EQ(problemOf("\n{\"format\": \"vides\"}"), is(SceneFault::kNothing, 2, "{\"format\":"));
  EXPECT_EQ(problemOf("v 0 0 \x1b[31m\xe9" + std::string(100, 'a')).found,
            "\\x1b[31m\\xe9" + std::string(26, 'a') + "...");
}

TEST_F(ObjFiles, AreReadByTheirName) {
  EXPECT_TRUE(readSceneFile(write("pyramid.obj", kPyramid)));
  EXPECT_TRUE(readSceneFile(write("PYRAMID.OBJ", kPyramid)));
  EXPECT_EQ(readSceneFile(write("pyramid.ply", kPyramid)).error(),
            (SceneProblem{SceneFault::kUnknownFormat, 0, ".ply"}));
}

TEST_F(ObjFiles, ThatCannotBeReadSayWhy) {
  EXPECT_THAT(readSceneFile(folder_ / "missing.obj").error().found, HasSubstr("No such file"));
  fs::create_directory(folder_ / "folder.obj");
  EXPECT_EQ(readSceneFile(folder_ / "folder.obj").error().fault, SceneFault::kNotAFile);
  ASSERT_EQ(mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
  EXPECT_EQ(readSceneFile(folder_ / "pipe.obj").error().fault, SceneFault::kNotAFile);
  write("huge.obj", "");
  fs::resize_file(folder_ / "huge.obj", kMostSceneBytes + 1);  // sparse: takes no room
  EXPECT_EQ(readSceneFile(folder_ / "huge.obj").error().fault, SceneFault::kTooLarge);
}

TEST(Obj, IsFoundFromTheFlightsFolder) {
  EXPECT_EQ(sceneFilePath("/home/a/flights", "pyramid.obj"), "/home/a/flights/pyramid.obj");
  EXPECT_EQ(sceneFilePath("/home/a/flights", "../scenes/b\xc3\xa4r.obj"),
            "/home/a/scenes/b\xc3\xa4r.obj");
  EXPECT_EQ(sceneFilePath("/home/a/flights", "/srv/c.obj"), "/srv/c.obj");
  EXPECT_EQ(sceneFilePath("", "c.obj"), "c.obj");
}

// A random file that both readers understand.
std::string randomObj(std::mt19937& random) {
  std::ostringstream text;
  int count = 0;
  const auto index = [&] {
    const int i = static_cast<int>(random() % static_cast<unsigned>(count)) + 1;
    return random() % 3 == 0 ? i - count - 1 : i;
  };
  for (int line = 0; line < 60; ++line) {
    const auto kind = count < 3 ? 0 : random() % 6;
    if (kind <= 2) {
      std::uniform_real_distribution<double> coordinate(-10, 10);
      text << "v " << coordinate(random) << ' ' << coordinate(random) << ' ' << coordinate(random);
      ++count;
    } else {
      text << (kind == 3 ? 'f' : kind == 4 ? 'l' : 'p');
      const auto n = kind == 3 ? 3 + random() % 4 : kind == 4 ? 2 + random() % 3 : 1;
      for (unsigned i = 0; i < n; ++i) text << ' ' << index();
    }
    text << '\n';
  }
  return text.str();
}

TEST(Obj, ReadsWhatTinyObjLoaderReads) {
  std::mt19937 random(20);
  for (int round = 0; round < 100; ++round) {
    const std::string text = randomObj(random);
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    std::istringstream stream(text);
    ASSERT_TRUE(tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream,
                                 nullptr, false))
        << error;
    SceneGeometry expected;
    const auto at = [](const tinyobj::index_t& i) {
      return static_cast<std::uint32_t>(i.vertex_index);
    };
    for (std::size_t i = 0; i + 2 < attributes.vertices.size(); i += 3) {
      expected.positions.emplace_back(attributes.vertices[i], attributes.vertices[i + 1],
                                      attributes.vertices[i + 2]);
    }
    for (const auto& shape : shapes) {
      std::size_t next = 0;
      for (const std::size_t corners : shape.mesh.num_face_vertices) {
        for (std::size_t i = 0; i < corners; ++i) {
          expected.edges.push_back(
              {at(shape.mesh.indices[next + i]), at(shape.mesh.indices[next + (i + 1) % corners])});
        }
        next += corners;
      }
      next = 0;
      for (const int places : shape.lines.num_line_vertices) {
        for (int i = 1; i < places; ++i) {
          expected.edges.push_back({at(shape.lines.indices[next + static_cast<std::size_t>(i) - 1]),
                                    at(shape.lines.indices[next + static_cast<std::size_t>(i)])});
        }
        next += static_cast<std::size_t>(places);
      }
      for (const auto& point : shape.points.indices) expected.points.push_back(at(point));
    }
    finishScene(expected);

    const auto scene = readObj(text);
    ASSERT_TRUE(scene) << "line " << scene.error().line << " of\n" << text;
    ASSERT_EQ(scene->positions.size(), expected.positions.size());
    for (std::size_t i = 0; i < expected.positions.size(); ++i) {
      EXPECT_LT(glm::distance(scene->positions[i], expected.positions[i]), 1e-9);
    }
    EXPECT_EQ(scene->edges, expected.edges);
    EXPECT_EQ(scene->points, expected.points);
  }
}

void expectSound(const SceneGeometry& scene) {
  const auto count = scene.positions.size();
  for (const auto& p : scene.positions) {
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  for (const auto& edge : scene.edges) {
    EXPECT_LT(edge[0], edge[1]);
    EXPECT_LT(edge[1], count);
  }
  for (const auto& t : scene.triangles) EXPECT_LT(std::max({t[0], t[1], t[2]}), count);
  for (const auto point : scene.points) EXPECT_LT(point, count);
}

TEST(Obj, DamagedFilesAreReadOrRefusedButNeverHalf) {
  std::mt19937 random(7);
  int read = 0, refused = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = round % 2 == 0 ? std::string(kPyramid) : randomObj(random);
    for (auto hits = 1 + random() % 4; hits > 0 && !text.empty(); --hits) {
      const std::size_t at = random() % text.size();
      switch (random() % 5) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, 1 + random() % 20);
          break;
        case 2:
          text.insert(at, "99999999999");
          break;
        case 3:
          text.resize(at + 1);
          break;
        default:
          text.insert(at, text.substr(at / 2, random() % 40));
      }
    }
    const auto scene = readObj(text);
    if (scene) {
      expectSound(*scene);
      ++read;
    } else {
      const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
      EXPECT_LE(scene.error().line, lines);
      ++refused;
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace vides
