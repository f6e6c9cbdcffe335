// SPDX-License-Identifier: MIT
// Random sequences of edits, drags, windows, questions and all commands for files, on disks that
// fail: the flight stays valid, what is refused changes nothing, what is saved is what is shown,
// and nothing happens that wasn't asked for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "edit/edit_fixture.hpp"
#include "edit/frame_job.hpp"
#include "flight/validation.hpp"
#include "support/session_snapshot.hpp"
#include "support/troubled_folder.hpp"

namespace vides {
namespace {

class FilesAtRandom {
 public:
  FilesAtRandom(std::uint32_t seed, test::TroubledFolder& folder)
      : random_(seed), folder_(folder) {}

  std::size_t index(std::size_t size) {
    return std::uniform_int_distribution<std::size_t>(0, size - 1)(random_);
  }
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::string file() { return folder_.name(index(1000)); }

  Command edit() {
    switch (index(8)) {
      case 0:
        return Command("insert-key");
      case 1:
        return Command("set-roll", number(-50000, 50000));
      case 2:
        return Command("set-zoom", number(-10, 120));
      case 3:
        return Command("move-keys", number(-1, 1), number(-1, 1), number(-1, 1));
      case 4:
        return Command("set-preset", index(12));
      case 5:
        return Command("delete-keys");
      case 6:
        return Command("set-name", std::to_string(index(1000)));
      default:
        return Command("remove-scene", index(2));
    }
  }
  Command anything() {
    static constexpr const char* kAnswers[] = {"save",    "discard", "overwrite", "save-as",
                                               "enlarge", "stop",    "cancel",    "later"};
    static constexpr const char* kWithFile[] = {"open",       "open",       "save-as",
                                                "save-as",    "save-as",    "import-scene",
                                                "load-setup", "save-setup", "frames-file"};
    static constexpr const char* kPlain[] = {
        "new",        "save",         "save",         "revert",       "quit",   "write-frames",
        "undo",       "redo",         "cut",          "copy",         "paste",  "use-view",
        "shape-show", "shape-ok",     "shape-cancel", "close-window", "escape", "new-key-from-view",
        "next-key",   "cancel-frames"};
    switch (index(10)) {
      case 0:
      case 1:
        return Command("answer", kAnswers[index(std::size(kAnswers))]);
      case 2:
      case 3:
        return Command(kWithFile[index(std::size(kWithFile))], file());
      case 4:
      case 5:
        return Command(kPlain[index(std::size(kPlain))]);
      case 6:
        return index(2) == 0 ? Command("show-window", "shape")
                             : Command("shape-set", "bias", number(-2, 2));
      case 7:
        return index(2) == 0 ? Command("fly-move", number(-1, 1), number(-1, 1), number(-1, 1))
                             : Command("open-recent", index(12));
      default:
        return edit();
    }
  }

 private:
  std::mt19937 random_;
  test::TroubledFolder& folder_;
};

// A refusal that asks: that is all that happens then.
bool asked(const Session& session) {
  const std::string& key = session.output().text.key;
  return key == "refusal.changed-on-disk" || key == "refusal.outside-cube";
}

void checkCommand(Session& session, const Command& command) {
  SCOPED_TRACE(format(command));
  test::SessionSnapshot before(session);
  const bool waited = session.windowOpen("chooser-save");
  const bool done = session.execute(command);
  session.finishFrames();
  test::SessionSnapshot after(session);
  ASSERT_TRUE(validate(session.flight()).empty());
  ASSERT_LT(session.frame(), session.evaluation().frameCount());
  if (!done) {
    if (asked(session)) before.asks = after.asks;
    if (command.name == "answer" && !after.asks) before.asks = false;
    // What was answered may have opened the flight's next question, or the chooser for its name.
    ASSERT_TRUE(before == after) << session.output().text.key;
    return;
  }
  const bool saves = command.name == "save" || command.name == "save-as";
  if (saves && !waited && !session.windowOpen("chooser-save")) {
    EXPECT_EQ(after.flight.keys, before.flight.keys);
    EXPECT_EQ(after.quits, before.quits);
    EXPECT_EQ(fileText(session.path()), writeVid(session.flight()));
    EXPECT_FALSE(session.modified());
  }
  if (command.name != "quit" && command.name != "answer" && !saves) {
    EXPECT_EQ(after.quits, before.quits);
  }
}

void checkDrag(FilesAtRandom& random, Session& session) {
  if (session.inGesture()) return;
  const Flight before = session.flight();
  session.begin("step.move-keys");
  for (int i = 0; i < 3; ++i) {
    const test::SessionSnapshot shown(session);
    const Command edit = random.edit();
    const bool previewed = session.preview(edit);
    EXPECT_TRUE(previewed || shown == test::SessionSnapshot(session)) << format(edit);
    const Command other("save-as", random.file());
    const test::SessionSnapshot dragged(session);
    EXPECT_FALSE(session.execute(other));
    EXPECT_TRUE(dragged == test::SessionSnapshot(session)) << format(other);
  }
  if (random.index(2) == 0) return session.commit();
  session.cancel();
  EXPECT_EQ(session.flight(), before);
}

void runSequence(std::uint32_t seed, test::TroubledFolder& folder) {
  FilesAtRandom random(seed, folder);
  folder.mend();
  Session session;
  for (int i = 0; i < 40 && !testing::Test::HasFailure(); ++i) {
    switch (random.index(12)) {
      case 0:
        folder.trouble(random.index(5));
        session.checkDisk();
        break;
      case 1:
        checkDrag(random, session);
        break;
      default:
        checkCommand(session, random.anything());
    }
    session.advance(0.02 * i);
    session.scenes();
  }
  while (!session.windows().empty()) session.execute("close-window");
  if (session.question()) session.execute("escape");
  while (session.execute("undo")) ASSERT_TRUE(validate(session.flight()).empty());
}

class RandomFiles : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomFiles, RefusedMeansNothingHappened) {
  constexpr std::uint32_t kPart = 125;
  test::TroubledFolder folder;
  for (std::uint32_t i = 0; i < kPart; ++i) {
    const std::uint32_t seed = GetParam() * kPart + i;
    SCOPED_TRACE(fmt::format("seed {}", seed));
    runSequence(seed, folder);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Thousand, RandomFiles, testing::Range(0u, 8u));

}  // namespace
}  // namespace vides
