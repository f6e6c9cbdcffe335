// SPDX-License-Identifier: MIT
// Files of unsaved work: written, found again when their editor is gone, and only then.
#include "edit/recovery.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "edit/edit_fixture.hpp"
#include "edit/texts.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"
#include "support/files.hpp"

namespace vides {
namespace {

std::size_t filesIn(const std::filesystem::path& folder) {
  std::error_code none;
  std::filesystem::directory_iterator each(folder, none);
  return static_cast<std::size_t>(std::distance(each, std::filesystem::directory_iterator()));
}

Flight flightWith(const std::string& name) {
  Flight flight = newFlight();
  flight.name = name;
  return flight;
}

TEST(RecoveryFile, IsOfferedOnceItsEditorIsGone) {
  const test::TemporaryFolder top;
  const auto folder = top / "state/recovery";
  EXPECT_TRUE(RecoveryFile::abandoned(folder).empty());
  const std::string path = "/home/Zo\xeb/a \"b\" 100%.vid";  // Latin 1: no UTF-8
  {
    RecoveryFile file(folder);
    EXPECT_EQ(filesIn(folder), 0u);
    EXPECT_EQ(file.write(flightWith("one"), path), std::nullopt);
    EXPECT_EQ(file.write(flightWith("two"), path), std::nullopt);
    EXPECT_TRUE(RecoveryFile::abandoned(folder).empty());  // its editor still runs
  }
  const auto found = RecoveryFile::abandoned(folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(RecoveryFile::abandoned(folder).empty());  // another editor is asking already
  const auto work = found.front()->read();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->flight, flightWith("two"));
  EXPECT_EQ(work->path, path);
  EXPECT_NEAR(static_cast<double>(work->time), static_cast<double>(std::time(nullptr)), 60.0);
  found.front()->remove();
  EXPECT_EQ(filesIn(folder), 0u);
}

TEST(RecoveryFile, EditorsSideBySideHaveTheirOwn) {
  const test::TemporaryFolder folder;
  {
    RecoveryFile a(folder.path()), b(folder.path());
    EXPECT_EQ(a.write(flightWith("a"), ""), std::nullopt);
    EXPECT_EQ(b.write(flightWith("b"), ""), std::nullopt);
    EXPECT_NE(a.file(), b.file());
    a.remove();
    EXPECT_FALSE(a.read());
    EXPECT_EQ(b.read()->flight, flightWith("b"));
    // What was removed can be written again.
    EXPECT_EQ(a.write(flightWith("c"), ""), std::nullopt);
    // One of them is older.
    const timespec old[2] = {{1000, 0}, {1000, 0}};
    ASSERT_EQ(::utimensat(0, a.file().c_str(), old, 0), 0);
  }
  const auto found = RecoveryFile::abandoned(folder.path());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0]->read()->flight, flightWith("b"));
  EXPECT_EQ(found[1]->read()->flight, flightWith("c"));
  EXPECT_EQ(found[1]->read()->time, 1000);
}

TEST(RecoveryFile, LocksWithoutAFileAreClearedAwayAndDamageIsLeftAlone) {
  const test::TemporaryFolder folder;
  test::writeAll(folder / "1-2-0.lock", "");
  EXPECT_TRUE(RecoveryFile::abandoned(folder.path()).empty());
  EXPECT_EQ(filesIn(folder.path()), 0u);
  test::writeAll(folder / "1-2-0.lock", "");
  test::writeAll(folder / "1-2-0.vid", "{");
  const auto found = RecoveryFile::abandoned(folder.path());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found.front()->read());
  EXPECT_EQ(filesIn(folder.path()), 2u);
}

TEST(RecoveryFile, WhatCannotBeWrittenIsTold) {
  const test::TemporaryFolder folder;
  test::writeAll(folder / "file", "");
  RecoveryFile file(folder / "file/recovery");
  const auto problem = file.write(newFlight(), "");
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->code, ProblemCode::kUnwritable);
}

TEST(RecoveryFile, OtherMembersOfTheFlightStay) {
  const test::TemporaryFolder folder;
  Flight flight = newFlight();
  flight.extras.flight =
      std::make_shared<const ExtraMembers>(ExtraMembers{{"\"x_mine\"", "[1, 2]"}});
  RecoveryFile file(folder.path());
  ASSERT_EQ(file.write(flight, "/a.vid"), std::nullopt);
  const auto work = file.read();
  ASSERT_TRUE(work && work->flight.extras.flight);
  EXPECT_TRUE(sameExtra(work->flight.extras.flight, flight.extras.flight));
}

TEST(RecoveryFile, AFlightThatWasItselfOpenedFromSuchAFileIsKept) {
  const test::TemporaryFolder folder;
  RecoveryFile first(folder.path());
  ASSERT_EQ(first.write(flightWith("a"), "/first.vid"), std::nullopt);
  const auto opened = readVidFile(first.file().string());
  ASSERT_TRUE(opened);
  RecoveryFile second(folder.path());
  ASSERT_EQ(second.write(*opened, "/second.vid"), std::nullopt);
  const auto work = second.read();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->flight, flightWith("a"));
  EXPECT_EQ(work->path, "/second.vid");
}

TEST(RecoveryFile, ADamagedPathCostsThePathOnly) {
  const auto pathIn = [](const std::string& member) {
    Flight flight = flightWith("a");
    flight.extras.flight =
        std::make_shared<const ExtraMembers>(ExtraMembers{{"\"x_vides_unsaved_path\"", member}});
    const auto work = readUnsavedWork(writeVid(flight));
    EXPECT_TRUE(work && work->flight == flightWith("a")) << member;
    return work ? work->path : "no work";
  };
  EXPECT_EQ(pathIn(R"("/a%20%C3%A4%25.vid")"), "/a \u00e4%.vid");
  EXPECT_EQ(pathIn(R"("")"), "");
  for (const char* damaged : {R"("/a%zz.vid")", R"("/a%2")", R"("%")", R"("/a%00b")",
                              R"("/\u0061")", "[1, 2]", "7", "null", "{\"a\": 1}"}) {
    EXPECT_EQ(pathIn(damaged), "") << damaged;
  }
}

class OfferTest : public testing::Test {
 protected:
  std::string told() const {
    Text more = session_.question()->text;
    more.key += ".more";
    const Texts texts(Language::kEnglish);
    return texts.tell(session_.question()->text) + " " + texts.tell(more);
  }
  test::TemporaryFolder folder_;
  Session session_;
};

TEST_F(OfferTest, RecoveredItIsUnsavedAndInItsFile) {
  const std::string path = (folder_ / "a.vid").string();
  ASSERT_EQ(saveVid(newFlight(), path), std::nullopt);
  session_.offerRecovery(flightWith("kept"), path, "2026-11-22 08:15");
  EXPECT_EQ(told(), "Recover a.vid? It was not saved when vides ended. Kept on 2026-11-22 08:15.");
  EXPECT_EQ(session_.takeRecoveryAnswer(), std::nullopt);
  refused(session_, "insert-key", "refusal.answer-first");
  run(session_, "answer recover");
  EXPECT_EQ(session_.takeRecoveryAnswer(), RecoveryAnswer::kRecover);
  EXPECT_EQ(session_.takeRecoveryAnswer(), std::nullopt);
  EXPECT_EQ(session_.flight().name, "kept");
  EXPECT_EQ(session_.path(), path);
  EXPECT_TRUE(session_.modified());
  run(session_, "save");
  EXPECT_EQ(test::readAll(path), writeVid(flightWith("kept")));
}

TEST_F(OfferTest, WithoutItsFileItIsUntitledAndWritesOverNoOther) {
  const std::string other = (folder_ / "other.vid").string();
  ASSERT_EQ(saveVid(newFlight(), other), std::nullopt);
  ASSERT_TRUE(session_.execute(Command("open", other)));
  Flight flight = flightWith("kept");
  flight.scene.push_back({"scenes/a.obj", {}});
  session_.offerRecovery(flight, (folder_ / "gone/b.vid").string(), "");
  run(session_, "answer recover");
  EXPECT_EQ(session_.path(), "");
  EXPECT_EQ(session_.flight().scene.front().file, (folder_ / "gone/scenes/a.obj").string());
  run(session_, "save");
  EXPECT_TRUE(session_.windowOpen("chooser-save"));
}

TEST_F(OfferTest, OtherwiseNothingHappens) {
  for (const auto& [answer, wanted] : {std::pair("answer forget", RecoveryAnswer::kForget),
                                       std::pair("answer later", RecoveryAnswer::kLater),
                                       std::pair("escape", RecoveryAnswer::kLater)}) {
    session_.offerRecovery(flightWith("kept"), "", "");
    EXPECT_EQ(told(), "Recover untitled? It was not saved when vides ended. Kept on .");
    run(session_, answer);
    EXPECT_EQ(session_.takeRecoveryAnswer(), wanted) << answer;
    EXPECT_FALSE(session_.question());
    EXPECT_EQ(session_.flight(), newFlight());
    EXPECT_FALSE(session_.modified());
  }
}

}  // namespace
}  // namespace vides
