// SPDX-License-Identifier: MIT
// Scene files are read once, in the background where wanted, and can be stopped.
#include "scene/scene_store.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "support/files.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

class SceneStoreTest : public ::testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) {
    test::writeAll(folder_ / name, text);
    return folder_ / name;
  }
  // Takes far longer to read than a store is ready to wait.
  fs::path writeLarge(const std::string& name) {
    std::string text = "v 0 0 0\nv 976 330 0.125\np 1 2\n";
    for (int i = 0; i < 4000000; ++i) text += "vn 0 0 1\n";
    return write(name, text);
  }
  test::TemporaryFolder folder_;
};

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_F(SceneStoreTest, EveryFileIsReadOnce) {
  SceneStore store(true);
  const fs::path a = write("a.obj", kTriangle), b = write("b.obj", "v 5 5 5\np 1\n");
  const auto first = store.scenes({a, b}, 1);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[1]->box().low, Vec3(5));
  EXPECT_EQ(store.scenes({a, b}, 1), first);
  EXPECT_EQ(store.scenes({b}, 1).at(0), first[1]);
  EXPECT_EQ(store.scenes({b, a}, 1).at(1), first[0]);  // undone and done again
  EXPECT_EQ(**store.read(a)->result(), first[0]);      // imported once more
  EXPECT_EQ(store.scenes({a, a}, 2).at(1), first[0]);  // named twice
  EXPECT_TRUE(store.scenes({}, 2).empty());
  EXPECT_TRUE(store.takeRefused().empty());
}

TEST_F(SceneStoreTest, AFileThatChangedIsReadAgain) {
  SceneStore store(true);
  const fs::path a = write("a.obj", kTriangle);
  EXPECT_EQ(store.scenes({a}, 1).at(0)->box().high, Vec3(1, 1, 0));
  write("a.obj", "v 0 0 0\nv 2 2 2\nl 1 2\n# longer than before\n");
  EXPECT_EQ((**store.read(a)->result())->box().high, Vec3(2));
  EXPECT_EQ(store.scenes({a}, 2).at(0)->box().high, Vec3(2));
}

TEST_F(SceneStoreTest, WhatCannotBeReadIsToldOnce) {
  SceneStore store(true);
  const fs::path a = write("a.obj", kTriangle), b = write("b.obj", "v 1 2 x\n");
  EXPECT_EQ(store.scenes({a, b, folder_ / "none.obj"}, 1).size(), 1u);
  const auto refused = store.takeRefused();
  ASSERT_EQ(refused.size(), 2u);
  EXPECT_EQ(refused[0]->file(), b);
  EXPECT_EQ(refused[0]->result()->error(), (SceneProblem{SceneFault::kNumber, 1, "x"}));
  EXPECT_EQ(refused[1]->result()->error().fault, SceneFault::kUnreadable);
  EXPECT_EQ(store.scenes({a, b, folder_ / "none.obj"}, 1).size(), 1u);
  EXPECT_EQ(store.scenes({a, b}, 1).size(), 1u);
  EXPECT_TRUE(store.takeRefused().empty());
  // With the flight opened again it is tried again.
  EXPECT_EQ(store.scenes({a, b}, 2).size(), 1u);
  EXPECT_EQ(store.takeRefused().size(), 1u);
}

TEST_F(SceneStoreTest, LargeScenesComeLater) {
  SceneStore store(false);
  const fs::path small = write("a.obj", kTriangle), large = writeLarge("large.obj");
  EXPECT_EQ(store.scenes({small, large}, 1).size(), 1u);
  ASSERT_EQ(store.reading().size(), 1u);
  EXPECT_EQ(store.reading()[0]->file(), large);
  EXPECT_EQ(store.read(large), store.reading()[0]);  // what is read already is not begun again
  const SharedReading reading = store.reading()[0];
  reading->wait();
  EXPECT_EQ(reading->share(), 1.0);
  EXPECT_EQ(store.scenes({small, large}, 1).size(), 2u);
  EXPECT_TRUE(store.reading().empty());
}

TEST_F(SceneStoreTest, ReadingCanBeStopped) {
  SceneStore store(false);
  const fs::path large = writeLarge("large.obj");
  EXPECT_TRUE(store.scenes({large}, 1).empty());
  const SharedReading reading = store.reading().at(0);
  store.cancel();
  reading->wait();
  EXPECT_EQ(reading->result()->error().fault, SceneFault::kCancelled);
  EXPECT_TRUE(store.scenes({large}, 1).empty());
  EXPECT_EQ(store.takeRefused().size(), 1u);
  EXPECT_TRUE(store.scenes({large}, 1).empty());  // it stays so
  EXPECT_TRUE(store.reading().empty());
  store.scenes({large}, 2);
  EXPECT_EQ(store.reading().size(), 1u);
}  // going away stops it

TEST_F(SceneStoreTest, WhatIsNamedNoMoreIsGivenUp) {
  SceneStore store(false);
  const fs::path large = writeLarge("large.obj");
  store.scenes({large}, 1);
  const std::weak_ptr<SceneReading> first = store.reading().at(0);
  store.scenes({}, 1);  // undone
  EXPECT_TRUE(store.reading().empty());
  store.scenes({large}, 1);  // and done again: begun anew, and nobody is told of the first
  ASSERT_EQ(store.reading().size(), 1u);
  EXPECT_NE(store.reading()[0], first.lock());
  store.reading()[0]->wait();
  EXPECT_EQ(store.scenes({large}, 1).size(), 1u);
  EXPECT_TRUE(store.takeRefused().empty());
  EXPECT_TRUE(first.expired() || first.lock()->ended());

  // Stopped by hand, too, it is tried again when it is named again.
  test::writeAll(large, test::readAll(large) + "# changed\n");
  store.scenes({large}, 2);
  store.cancel();
  for (const SharedReading& reading : store.reading()) reading->wait();
  store.scenes({large}, 2);
  EXPECT_EQ(store.takeRefused().size(), 1u);
  store.scenes({}, 2);
  store.scenes({large}, 2);
  EXPECT_EQ(store.reading().size(), 1u);
}

// An import waits for what the flight doesn't name yet, however many others come and go.
TEST_F(SceneStoreTest, WhatAnImportWaitsForGoesOn) {
  SceneStore store(false);
  const fs::path large = writeLarge("large.obj");
  const SharedReading import = store.read(large);
  for (int i = 0; i < 8; ++i) store.scenes({write(std::to_string(i) + ".obj", kTriangle)}, 1);
  import->wait();
  EXPECT_TRUE(*import->result());
  EXPECT_EQ(store.read(large), import);
}

TEST_F(SceneStoreTest, ManyFilesAreReadAFewAtATime) {
  SceneStore store(false);
  const fs::path large = writeLarge("0.obj");
  std::vector<fs::path> files{large};
  for (int i = 1; i < 8; ++i) {
    files.push_back(folder_ / (std::to_string(i) + ".obj"));
    fs::create_hard_link(large, files.back());
  }
  store.scenes(files, 1);
  EXPECT_EQ(store.reading().size(), 4u);
  store.cancel();
}

}  // namespace
}  // namespace vides
