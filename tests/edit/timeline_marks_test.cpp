// SPDX-License-Identifier: MIT
// What the timeline shows: every mark of a small flight, a pixel's worth of a large one.
#include "edit/timeline_marks.hpp"

#include <gtest/gtest.h>

#include "edit/edit_fixture.hpp"

namespace vides {
namespace {

TEST(TimelineMarks, EveryOrientationOfASmallFlight) {
  Session session;
  makeFive(session);
  run(session, "select-key 2");
  run(session, "set-hold 1");
  const Evaluation& evaluation = session.evaluation();
  const double frames = static_cast<double>(evaluation.frameCount() - 1);
  const auto marks = timelineMarks(evaluation, {0.0, frames / 1000.0, 1000.0});
  // Five keys and the second key's further orientations: a pan and a roll lead to them.
  ASSERT_EQ(marks.size(), 7u);
  std::size_t keys = 0;
  for (const TimelineMark& mark : marks) {
    EXPECT_EQ(mark.frame, evaluation.frameOf(mark.place));
    EXPECT_EQ(mark.key, mark.place.orientation == 0);
    keys += mark.key ? 1 : 0;
  }
  EXPECT_EQ(keys, 5u);
  EXPECT_EQ(marks.back().place.key, 4u);
  EXPECT_EQ(marks.back().frame, evaluation.frameCount() - 1);
  // A part of it: what stands there.
  const auto part = timelineMarks(evaluation, {1.0, 1.0, static_cast<double>(marks[2].frame)});
  ASSERT_EQ(part.size(), 2u);
  EXPECT_EQ(part[0].frame, marks[1].frame);
  EXPECT_EQ(part[1].frame, marks[2].frame);
}

// A section in which nothing differs has no frames: its mark is that of the frame.
TEST(TimelineMarks, SectionsWithoutFramesAreTold) {
  Session session;
  makeFive(session);
  const auto silent = [&] {
    const double frames = static_cast<double>(session.evaluation().frameCount() - 1);
    std::string keys;
    for (const TimelineMark& mark :
         timelineMarks(session.evaluation(), {0.0, frames / 1000.0, 1000.0})) {
      if (mark.silent) keys += std::to_string(mark.place.key);
    }
    return keys;
  };
  EXPECT_EQ(silent(), "");
  for (const int key : {0, 2, 4}) {  // the first, one within, the last
    run(session, "select-key " + std::to_string(key));
    run(session, "insert-orientation");
  }
  EXPECT_EQ(silent(), "024");
  run(session, "select-key 2");
  run(session, "set-hold 1");  // a hold between doesn't hide it
  EXPECT_EQ(silent(), "024");
  run(session, "set-closed on");
  EXPECT_EQ(silent(), "024");
  run(session, "make-current 2 1");
  run(session, "set-roll 20");
  EXPECT_EQ(silent(), "04");
}

TEST(TimelineMarks, NoMoreThanPixelsInALargeFlight) {
  Flight flight = newFlight();
  std::vector<KeyPointer> keys;
  for (int i = 0; i < 100'000; ++i) {
    Key key;
    key.position = {0.8 * std::sin(0.01 * i), 0.8 * std::cos(0.013 * i), 0.9 * std::sin(0.017 * i)};
    key.orientations.front().aim = {0, 2, 0};
    keys.emplace_back(std::move(key));
  }
  flight.keys = KeyList(keys);
  const Evaluation evaluation(flight);
  const double last = static_cast<double>(evaluation.frameCount() - 1);
  for (const double share : {1.0, 0.1, 0.001}) {
    const TimelineRange range{last * 0.3 * (1.0 - share), last * share / 1200.0, 1200.0};
    const auto marks = timelineMarks(evaluation, range);
    EXPECT_LE(marks.size(), 602u);
    EXPECT_GT(marks.size(), share == 1.0 ? 500u : 50u);
    for (std::size_t i = 1; i < marks.size(); ++i) {
      EXPECT_GT(marks[i].frame, marks[i - 1].frame);
      EXPECT_GE(range.x(static_cast<double>(marks[i].frame)), -1e-9);
    }
  }
}

// Scrolled or not, every section and every mark that is seen is there once, in its place.
TEST(TimelineMarks, TheCacheKnowsWhatIsLookedUpAnew) {
  Session session;
  makeFive(session);
  TimelineCache cache;
  for (const double framesPerPixel : {0.05, 0.31, 3.0}) {
    const Evaluation& evaluation = session.evaluation();
    cache.follow(evaluation, framesPerPixel);
    std::vector<std::int64_t> sections, marks;
    const double frames = static_cast<double>(evaluation.frameCount());
    const auto chunks =
        static_cast<std::int64_t>(frames / framesPerPixel / TimelineCache::kChunkPixels) + 1;
    for (std::int64_t n = 0; n < chunks; ++n) {
      for (const Section& section : cache.chunk(n).sections) {
        if (sections.empty() || sections.back() != section.index) sections.push_back(section.index);
      }
      for (const TimelineMark& mark : cache.chunk(n).marks) {
        if (marks.empty() || marks.back() != mark.frame) marks.push_back(mark.frame);
      }
    }
    EXPECT_EQ(sections.size(), static_cast<std::size_t>(evaluation.sectionCount()));
    std::vector<std::int64_t> all;
    for (const TimelineMark& mark :
         timelineMarks(evaluation, {0.0, framesPerPixel, frames / framesPerPixel})) {
      all.push_back(mark.frame);
    }
    EXPECT_EQ(marks, all);
    // What is edited is seen.
    run(session, "make-current 0 0");
    run(session, "set-hold 2");
    cache.follow(session.evaluation(), framesPerPixel);
    EXPECT_EQ(cache.chunk(0).sections.front().kind, SectionKind::kHold);
    run(session, "undo");
  }
}

TEST(TimelineMarks, FindsTheEndUnderThePointer) {
  Session session;
  makeFive(session);
  const Evaluation& evaluation = session.evaluation();
  const TimelineRange range{0.0, 0.5, 4000.0};
  for (std::int64_t i = 0; i < evaluation.sectionCount(); ++i) {
    const Section section = evaluation.section(i);
    const double end = range.x(static_cast<double>(section.firstFrame + section.frames));
    for (const double off : {-3.0, 0.0, 3.0}) {
      const auto found = sectionEndAt(evaluation, range, end + off, 4.0);
      ASSERT_TRUE(found) << i << ' ' << off;
      EXPECT_EQ(found->index, i) << off;
    }
    EXPECT_FALSE(sectionEndAt(evaluation, range, end - 6.0, 4.0));
  }
  EXPECT_FALSE(sectionEndAt(evaluation, range, 0.0, 4.0));
}

}  // namespace
}  // namespace vides
