// SPDX-License-Identifier: MIT
// What an import tells and offers: the up axis, flying round it, the same file again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "edit/edit_fixture.hpp"
#include "edit/scene_edits.hpp"
#include "edit/texts.hpp"

namespace vides {
namespace {

using testing::HasSubstr;

class Import : public FolderTest {
 protected:
  Import() {
    // 4 x 2 x 1 about (12, 1, -2.5).
    writeFile(path("box.obj"), "v 10 0 -3\nv 14 2 -2\nv 10 2 -2\nf 1 2 3\n");
    writeFile(path("other.obj"), "v 0 0 0\nv 1 1 1\nl 1 2\n");
  }
  std::string said() const { return Texts(Language::kEnglish).tell(session_.output().text); }
  Session session_;
};

TEST_F(Import, TellsWhatCameIn) {
  run(session_, "import-scene " + path("box.obj"));
  EXPECT_EQ(session_.output().kind, MessageKind::kDone);
  EXPECT_EQ(said(), "box.obj: 3 vertices, 1 face · 4 × 2 × 1 in the file’s own unit · up axis y");
  ASSERT_TRUE(session_.importNote());
  EXPECT_TRUE(session_.importNote()->fitted);
  EXPECT_EQ(session_.flight().space, (Space{{12, 1, -2.5}, 2.5}));
  EXPECT_EQ(session_.history().steps(), 1u);
  run(session_, "set-zoom 20");
  EXPECT_FALSE(session_.importNote());
}

TEST_F(Import, AnotherUpAxisFitsAgainInOneStep) {
  run(session_, "import-scene " + path("box.obj"));
  run(session_, "set-scene-up 0 z");
  EXPECT_EQ(session_.flight().scene[0].up, UpAxis::kZ);
  // (x, z, -y)
  EXPECT_EQ(session_.flight().space, (Space{{12, -2.5, -1}, 2.5}));
  EXPECT_EQ(session_.scenes().at(0).box(), (BoundingBox{{10, -3, -2}, {14, -2, 0}}));
  EXPECT_EQ(session_.history().steps(), 2u);
  ASSERT_TRUE(session_.importNote());
  run(session_, "set-scene-up 0 x");
  EXPECT_EQ(session_.flight().space, (Space{{-1, 12, -2.5}, 2.5}));
  run(session_, "undo");
  run(session_, "undo");
  EXPECT_EQ(session_.flight().scene[0].up, UpAxis::kY);
  EXPECT_EQ(session_.flight().space, (Space{{12, 1, -2.5}, 2.5}));
  EXPECT_FALSE(session_.importNote());
}

TEST_F(Import, AfterTheNextEditTheSpaceStays) {
  run(session_, "import-scene " + path("box.obj"));
  const Space fitted = session_.flight().space;
  run(session_, "set-zoom 20");
  run(session_, "set-scene-up 0 z");
  EXPECT_EQ(session_.flight().space, fitted);
  EXPECT_TRUE(session_.setup().importUp.empty());
  // A later import has fitted nothing.
  run(session_, "import-scene " + path("other.obj"));
  ASSERT_TRUE(session_.importNote());
  EXPECT_FALSE(session_.importNote()->fitted);
  run(session_, "set-scene-up 1 -x");
  EXPECT_EQ(session_.flight().space, fitted);
  refused(session_, "set-scene-up 2 z", "refusal.no-such-scene");
  EXPECT_FALSE(session_.execute("set-scene-up 0 up"));
}

TEST_F(Import, TheAxisIsRememberedForTheFormat) {
  run(session_, "import-scene " + path("box.obj"));
  run(session_, "set-scene-up 0 z");
  const vides::Setup setup = session_.setup();
  EXPECT_EQ(setup.importUp, (std::map<std::string, UpAxis>{{"obj", UpAxis::kZ}}));
  const auto read = readSetup(writeSetup(setup));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, setup);

  Session next;
  next.setSetup(*read);
  run(next, "import-scene " + path("box.obj"));
  EXPECT_EQ(next.flight().scene[0].up, UpAxis::kZ);
  EXPECT_EQ(next.flight().space, (Space{{12, -2.5, -1}, 2.5}));
  run(next, "set-scene-up 0 y");
  EXPECT_TRUE(next.setup().importUp.empty());
  // What a later version knows is passed over, what is wrong is told.
  EXPECT_TRUE(readSetup(R"({"format":"vides-setup","version":1,"import_up":{"e57":"q"}})"));
  EXPECT_FALSE(readSetup(R"({"format":"vides-setup","version":1,"import_up":{"obj":"q"}})"));
}

TEST_F(Import, TheSameFileAgainIsAsked) {
  run(session_, "import-scene " + path("box.obj") + " ask");
  EXPECT_FALSE(session_.question());
  run(session_, "import-scene " + path("box.obj") + " ask");
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->choices, (std::vector<std::string>{"again", "cancel"}));
  run(session_, "answer cancel");
  EXPECT_EQ(session_.flight().scene.size(), 1u);
  std::filesystem::create_directories(folder_ / "x");
  run(session_, "import-scene " + path("x/../box.obj") + " ask");
  ASSERT_TRUE(session_.question());
  run(session_, "answer again");
  EXPECT_EQ(session_.flight().scene.size(), 2u);
  // Without anybody to ask it is added, and told.
  run(session_, "import-scene " + path("box.obj"));
  EXPECT_EQ(session_.flight().scene.size(), 3u);
  EXPECT_THAT(said(), HasSubstr("box.obj once more"));
}

// Whether all corners of the drawn box lie in a key's picture, and how near to its edge one comes.
double reachIn(const Session& session, std::size_t k, const BoundingBox& box) {
  const Flight& flight = session.flight();
  const Key& key = flight.keys[k];
  const Orientation& o = key.orientations[0];
  const Vec3 n = glm::normalize(aimOffset(key, o));
  const Vec3 right = glm::normalize(glm::cross(n, Vec3(0, 1, 0)));
  const Vec3 up = glm::cross(right, n);
  const double across = std::tan(0.5 * flight.lens.horizontalFieldOfView(o.zoom));
  const double high = across * flight.picture.height / flight.picture.width;
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = flight.space.toCube({corner & 1 ? box.high.x : box.low.x,
                                        corner & 2 ? box.high.y : box.low.y,
                                        corner & 4 ? box.high.z : box.low.z}) -
                   key.position;
    const double ahead = glm::dot(p, n);
    most = std::max({most, std::abs(glm::dot(p, right)) / ahead / across,
                     std::abs(glm::dot(p, up)) / ahead / high});
  }
  return most;
}

TEST_F(Import, FlyRoundIt) {
  run(session_, "import-scene " + path("box.obj"));
  run(session_, "fit-space 0.3");
  EXPECT_EQ(session_.flight().space.center, Vec3(12, 1, -2.5));
  EXPECT_DOUBLE_EQ(session_.flight().space.halfSize, 2 / 0.3);
  EXPECT_EQ(session_.flight().keys[0].position, Vec3(-0.5, 0.3, 0.8));
  EXPECT_EQ(session_.flight().keys[1].position, Vec3(0.5, 0.3, 0.8));
  EXPECT_EQ(session_.flight().keys[0].orientations[0].aim, Vec3(0));
  EXPECT_EQ(session_.history().steps(), 2u);
  EXPECT_FALSE(session_.importNote());
  const BoundingBox box = session_.scenes().at(0).box();
  EXPECT_LE(session_.currentOrientation().zoom, 12.0);
  EXPECT_LE(std::max(reachIn(session_, 0, box), reachIn(session_, 1, box)), 1.0 + 1e-12);
  run(session_, "undo");
  EXPECT_EQ(session_.flight().keys, newFlight().keys);

  // A larger share needs a wider lens: then a corner lies on the picture's edge.
  run(session_, "fit-space 0.6");
  EXPECT_LT(session_.currentOrientation().zoom, 12.0);
  EXPECT_GT(session_.currentOrientation().zoom, 1.0);
  EXPECT_NEAR(std::max(reachIn(session_, 0, box), reachIn(session_, 1, box)), 1.0, 1e-9);
}

TEST_F(Import, FittingLaterKeepsThePlaces) {
  run(session_, "import-scene " + path("box.obj"));
  run(session_, "move-key 0 -0.1 0.1 0.1");
  run(session_, "move-key 1 0.1 0.1 0.1");
  const Vec3 place = session_.flight().space.toWorld(session_.flight().keys[0].position);
  run(session_, "fit-space 1");
  EXPECT_DOUBLE_EQ(session_.flight().space.halfSize, 2.0);
  EXPECT_NEAR(
      glm::distance(session_.flight().space.toWorld(session_.flight().keys[0].position), place),
      0.0, 1e-12);
  EXPECT_DOUBLE_EQ(session_.flight().rates.move, 80.0);
  run(session_, "fit-space 0.3");
  run(session_, "move-key 0 -1 1 1");
  refused(session_, "fit-space 1", "refusal.space-too-small");
  refused(session_, "fit-space 0.04", "refusal.fit-share");
  refused(session_, "fit-space 1.01", "refusal.fit-share");
  run(session_, "show-scene 0 off");
  refused(session_, "fit-space 0.3", "refusal.nothing-drawn");
  Session empty;
  refused(empty, "fit-space 0.3", "refusal.nothing-drawn");
}

}  // namespace
}  // namespace vides
