// SPDX-License-Identifier: MIT
// Marks of the timeline moved along: what each section gets and what stays.
#include "edit/mark_edits.hpp"

#include <fmt/format.h>

#include <vector>

#include "edit/edit_fixture.hpp"

namespace vides {
namespace {

// Kind, from, to and frames of all entries; a film's shape in time.
std::vector<std::int64_t> framesOf(const Session& session) {
  std::vector<std::int64_t> frames;
  for (std::int64_t i = 0; i < session.evaluation().sectionCount(); ++i)
    frames.push_back(session.evaluation().section(i).frames);
  return frames;
}

// Two entries of the list differ by `by`, all others are as they were.
void expectMoved(const Session& session, std::vector<std::int64_t> before, std::size_t from,
                 std::size_t to, std::int64_t by) {
  before[from] += by;
  before[to] -= by;
  EXPECT_EQ(framesOf(session), before);
}

TEST(MarkEdits, TheSectionBeforeGetsWhatTheOneAfterGives) {
  Session session;
  makeFive(session);
  run(session, "select-key 2");
  const auto before = framesOf(session);
  const std::int64_t all = session.evaluation().frameCount();
  const std::int64_t frame = session.evaluation().frameOf({3, 0});
  ASSERT_EQ(before.size(), 6u);  // move, pan, pan or roll, three moves
  const std::size_t steps = session.history().steps();
  run(session, "move-mark 3 0 7");
  EXPECT_EQ(session.history().steps(), steps + 1);
  EXPECT_EQ(session.evaluation().frameOf({3, 0}), frame + 7);
  EXPECT_EQ(session.evaluation().frameCount(), all);
  expectMoved(session, before, 4, 5, 7);
  const double fps = session.flight().frameRate;
  EXPECT_EQ(session.flight().keys[2].orientations[0].duration,
            static_cast<double>(before[4] + 7) / fps);
  EXPECT_EQ(session.flight().keys[3].orientations[0].duration,
            static_cast<double>(before[5] - 7) / fps);
  EXPECT_EQ(session.output().text.key, "output.mark-moved");
  run(session, "undo");
  EXPECT_EQ(framesOf(session), before);
  EXPECT_FALSE(session.flight().keys[2].orientations[0].duration);
  // One of a key's further orientations, backwards.
  run(session, "move-mark 1 2 -3");
  expectMoved(session, before, 2, 3, -3);
}

TEST(MarkEdits, EachKeepsAFrame) {
  Session session;
  makeFive(session);
  const auto before = framesOf(session);
  refused(session, fmt::format("move-mark 3 0 {}", before[5]), "refusal.mark-range");
  refused(session, fmt::format("move-mark 3 0 -{}", before[4]), "refusal.mark-range");
  refused(session, "move-mark 3 0 1.5", "refusal.mark-range");
  refused(session, "move-mark 9 0 1", "refusal.no-such-key");
  refused(session, "move-mark 3 4 1", "refusal.no-such-orientation");
  run(session, fmt::format("move-mark 3 0 {}", before[5] - 1));
  EXPECT_EQ(framesOf(session)[5], 1);
  const std::size_t steps = session.history().steps();
  run(session, "move-mark 3 0 0");
  EXPECT_EQ(session.history().steps(), steps);
}

TEST(MarkEdits, TheFirstAndTheLastAreFixed) {
  Session session;
  makeFive(session);
  refused(session, "move-mark 0 0 1", "refusal.mark-fixed");
  refused(session, "move-mark 4 0 -1", "refusal.mark-fixed");
  // A hold at the end doesn't make the last mark one between two sections.
  run(session, "select-key 4");
  run(session, "set-hold 1");
  refused(session, "move-mark 4 0 1", "refusal.mark-fixed");
}

TEST(MarkEdits, HoldsStayWithTheirMark) {
  Session session;
  makeFive(session);
  run(session, "select-key 3");
  run(session, "set-hold 0.8");
  const auto before = framesOf(session);
  ASSERT_EQ(before[5], 20);
  run(session, "move-mark 3 0 -5");
  expectMoved(session, before, 4, 6, -5);
  EXPECT_EQ(session.flight().keys[3].orientations[0].hold, 0.8);
}

TEST(MarkEdits, OrientationsOnOneFrameAreOneMark) {
  Session session;
  makeFive(session);
  run(session, "select-key 3");
  run(session, "insert-orientation");  // a copy: nothing differs, no frames
  const auto before = framesOf(session);
  run(session, "move-mark 3 1 4");
  expectMoved(session, before, 4, 5, 4);
  EXPECT_FALSE(session.flight().keys[3].orientations[0].duration);
  run(session, "undo");
  run(session, "move-mark 3 0 4");
  expectMoved(session, before, 4, 5, 4);
}

TEST(MarkEdits, InAClosedFlightTheSeamIsFixedAndTheLastKeyIsNot) {
  Session session;
  makeFive(session);
  run(session, "set-closed on");
  const auto before = framesOf(session);
  ASSERT_EQ(before.size(), 7u);
  refused(session, "move-mark 0 0 1", "refusal.mark-fixed");
  run(session, "move-mark 4 0 6");
  expectMoved(session, before, 5, 6, 6);
}

// What is given in seconds is rounded together: thirds and elevenths of seconds, holds of halves.
TEST(MarkEdits, WhatIsTimedKeepsItsFrames) {
  Session session;
  makeFive(session);
  for (int k = 0; k < 4; ++k) {
    run(session, fmt::format("select-key {}", k));
    run(session, fmt::format("set-duration {}", 3.0 / 11.0 + 0.1 * k));
    run(session, fmt::format("set-hold {}", 0.1 + k / 7.0));
  }
  run(session, "select-key 1");
  run(session, "make-current 1 1");
  run(session, "set-duration 0.37");
  const auto before = framesOf(session);
  const Flight start = session.flight();
  for (const char* mark : {"1 0", "1 1", "2 0", "3 0"}) {
    for (const std::int64_t by : {-4, -1, 1, 2, 5}) {
      if (!session.execute(fmt::format("move-mark {} {}", mark, by))) continue;
      auto after = framesOf(session);
      ASSERT_EQ(after.size(), before.size()) << mark;
      int changed = 0;
      for (std::size_t i = 0; i < after.size(); ++i) {
        if (after[i] == before[i]) continue;
        ++changed;
        EXPECT_EQ(std::abs(after[i] - before[i]), std::abs(by)) << mark << ' ' << by << ' ' << i;
      }
      EXPECT_EQ(changed, 2) << mark << ' ' << by;
      run(session, "undo");
      ASSERT_EQ(session.flight(), start);
    }
  }
}

// A drag previews from the press: each step counts from there, none adds up.
TEST(MarkEdits, APreviewCountsFromThePress) {
  Session session;
  makeFive(session);
  const auto before = framesOf(session);
  const Flight start = session.flight();
  const auto preview = [&](std::int64_t by) {
    return session.preview(Command("move-mark", 3, 0, by), Session::PreviewOn::kStart);
  };
  session.begin({});
  EXPECT_TRUE(preview(3));
  EXPECT_TRUE(preview(-2));
  expectMoved(session, before, 4, 5, -2);
  EXPECT_TRUE(preview(0));
  EXPECT_EQ(session.flight(), start);
  EXPECT_TRUE(preview(9));
  session.commit();
  expectMoved(session, before, 4, 5, 9);
  EXPECT_EQ(session.undoName()->parts.size(), 1u);
  session.begin({});
  EXPECT_TRUE(preview(-2));
  session.cancel();
  expectMoved(session, before, 4, 5, 9);
}

}  // namespace
}  // namespace vides
