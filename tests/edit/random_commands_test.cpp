// SPDX-License-Identifier: MIT
// 10,000 random sequences of edits: every flight on the way is valid, undoing all gives the start,
// redoing all the end, byte for byte, and the incremental evaluation equals one from scratch.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "edit/command_table.hpp"
#include "edit/ease.hpp"
#include "edit/edit_fixture.hpp"
#include "flight/validation.hpp"

namespace vides {
namespace {

class RandomCommands {
 public:
  explicit RandomCommands(std::uint32_t seed) : random_(seed) {}

  std::size_t index(std::size_t size) {
    return std::uniform_int_distribution<std::size_t>(0, size - 1)(random_);
  }
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // Mostly in range, now and then beyond it.
  double inOrOut(double low, double high) {
    const double margin = index(10) == 0 ? high - low : 0.0;
    return number(low - margin, high + margin);
  }

  Command any(const Session& session) {
    const std::size_t keys = session.flight().keys.size();
    switch (index(36)) {
      case 0:
        return Command(index(2) == 0 ? "insert-key" : "insert-at-playhead");
      case 1:
        return Command("insert-keys", index(12));
      case 2:
        return Command("insert-key-at", index(keys + 1), inOrOut(0, 1));
      case 3:
        return Command("append-key");
      case 4:
      case 5:
        return Command("delete-keys");
      case 6:
      case 7:
      case 8:
        return Command("move-key", index(keys), inOrOut(-1, 1), inOrOut(-1, 1), inOrOut(-1, 1));
      case 9:
        return Command("move-keys", number(-1, 1), number(-1, 1), number(-1, 1));
      case 10:
        return Command("set-preset", index(11));
      case 11:
        return Command("set-shape", inOrOut(-1, 1), inOrOut(-1, 1), inOrOut(-1, 1));
      case 12:
        return Command("set-preset-shape", index(10), number(-1, 1), number(-1, 1), 0.0);
      case 13:
      case 14:
        return Command("insert-orientation");
      case 15:
        return Command("delete-orientation");
      case 16:
        return Command("set-aim", number(-2, 2), number(-2, 2), number(-2, 2));
      case 17:
        return Command("set-aim-mode", index(2) == 0 ? "absolute" : "relative");
      case 18:
        return Command("set-roll", inOrOut(-36000, 36000));
      case 19:
        return Command("set-zoom", inOrOut(1, 100));
      case 20:
        return Command("set-speed-value", index(11), inOrOut(1, 100));
      case 21:
        return Command("ease", std::string(easeNames()[index(easeNames().size())]));
      case 22:
        return Command("set-duration", inOrOut(0.01, 20));
      case 23:
        return Command("clear-duration");
      case 24:
        return Command("set-hold", inOrOut(0, 3));
      case 25:
        return Command("set-closed", "toggle");
      case 26:
        return Command("set-space", number(-0.5, 0.5), 0.0, number(-1, 1), inOrOut(0.5, 4));
      case 27:
        return Command("copy");
      case 28:
        return Command("paste");
      case 29:
        return Command("cut");
      case 30:
        return Command("duplicate-keys");
      case 31:
        return Command("set-orientation-curve", index(3) == 0   ? "smooth"
                                                : index(2) == 0 ? "slerp"
                                                                : "catmull_rom");
      case 32:
        return Command("match-speed", index(2) == 0 ? "before" : "after");
      case 33:
        return Command("new-key-from-view");
      case 34:
        return Command("use-view");
      default:
        return Command("move-aims", number(-1, 1), number(-1, 1), number(-1, 1));
    }
  }

  void wander(Session& session) {
    const std::size_t keys = session.flight().keys.size();
    switch (index(6)) {
      case 0:
        session.execute("next-key");
        break;
      case 1:
        session.execute(Command("toggle-select", index(keys)));
        break;
      case 2:
        session.execute(Command("select-key", index(keys)));
        break;
      case 3:
        session.execute("next-orientation");
        break;
      case 4:
        session.execute(Command("go-to-frame", index(500)));
        break;
      default:
        session.execute(Command("fly-move", number(-1, 1), number(-1, 1), number(-1, 1)));
    }
  }

 private:
  std::mt19937 random_;
};

void expectSameEvaluation(const Evaluation& a, const Evaluation& b) {
  ASSERT_EQ(a.frameCount(), b.frameCount());
  ASSERT_EQ(a.sectionCount(), b.sectionCount());
  EXPECT_EQ(a.length(), b.length());
  const std::int64_t step = std::max<std::int64_t>(a.frameCount() / 13, 1);
  for (std::int64_t n = 0; n < a.frameCount(); n += step) EXPECT_EQ(a.frame(n), b.frame(n)) << n;
}

// A drag within the sequence: one step if it changes something, none if it is taken back.
void randomGesture(RandomCommands& random, Session& session) {
  session.begin("step.move-keys");
  for (int i = 0; i < 3; ++i) session.preview(random.any(session));
  if (random.index(3) == 0) {
    session.cancel();
  } else {
    session.commit();
  }
}

void runSequence(std::uint32_t seed) {
  RandomCommands random(seed);
  Session session;
  std::vector<std::string> flights{writeVid(session.flight())};
  const std::size_t length = 3 + random.index(18);
  for (std::size_t i = 0; i < length; ++i) {
    const std::size_t steps = session.history().steps();
    const Flight before = session.flight();
    Command command = random.any(session);
    if (random.index(8) == 0) {
      randomGesture(random, session);
      command = Command("gesture");
    } else {
      const bool done = session.execute(command);
      if (!done) {
        EXPECT_EQ(session.flight(), before) << format(command);
      }
    }
    if (session.question()) session.execute("answer cancel");
    const bool changed = !(session.flight() == before);
    ASSERT_EQ(session.history().steps(), steps + (changed ? 1 : 0)) << format(command);
    ASSERT_TRUE(validate(session.flight()).empty()) << format(command);
    if (changed) flights.push_back(writeVid(session.flight()));
    ASSERT_TRUE(session.selected().contains(session.current().key)) << format(command);
    ASSERT_LT(session.frame(), session.evaluation().frameCount());
    random.wander(session);
  }
  expectSameEvaluation(session.evaluation(), Evaluation(session.flight()));
  for (std::size_t i = flights.size(); i-- > 1;) {
    ASSERT_EQ(writeVid(session.flight()), flights[i]);
    ASSERT_TRUE(session.execute("undo"));
  }
  EXPECT_EQ(writeVid(session.flight()), flights.front());
  EXPECT_FALSE(session.undoName());
  EXPECT_FALSE(session.modified());
  for (std::size_t i = 1; i < flights.size(); ++i) ASSERT_TRUE(session.execute("redo"));
  EXPECT_EQ(writeVid(session.flight()), flights.back());
  EXPECT_FALSE(session.redoName());
  expectSameEvaluation(session.evaluation(), Evaluation(session.flight()));
}

class RandomSequences : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomSequences, UndoAllIsTheStartAndRedoAllTheEnd) {
  constexpr std::uint32_t kPart = 1250;
  for (std::uint32_t i = 0; i < kPart; ++i) {
    const std::uint32_t seed = GetParam() * kPart + i;
    SCOPED_TRACE(fmt::format("seed {}", seed));
    runSequence(seed);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(TenThousand, RandomSequences, testing::Range(0u, 8u));

}  // namespace
}  // namespace vides
