// SPDX-License-Identifier: MIT
// What of a flight is seen on a timeline.
#include "edit/timeline_marks.hpp"

#include <algorithm>
#include <cmath>

#include "math/whole.hpp"

namespace vides {
namespace {

// Whether sections without frames lie between entry `index` of the list of sections and the one
// before; behind the last one for an index past it.
bool silentBefore(const Evaluation& evaluation, std::int64_t index) {
  const std::int64_t count = evaluation.sectionCount();
  const OrientationPlace came = index > 0 ? evaluation.section(index - 1).to : OrientationPlace{};
  if (index < count) return came != evaluation.section(index).from;
  const Flight& flight = evaluation.flight();
  const std::size_t key = flight.keys.size() - 1;
  const OrientationPlace last{key, flight.keys[key].orientations.size() - 1};
  return came != (flight.closed ? OrientationPlace{} : last);
}

}  // namespace

std::vector<TimelineMark> timelineMarks(const Evaluation& evaluation, const TimelineRange& range) {
  std::vector<TimelineMark> marks;
  const std::int64_t last = evaluation.frameCount() - 1;
  const double right = range.frame(range.pixels);
  const auto add = [&](OrientationPlace place, std::int64_t frame, bool silent) {
    const bool key = place.orientation == 0 || evaluation.frameOf({place.key, 0}) == frame;
    if (key) place.orientation = 0;
    marks.push_back({place, frame, key, silent});
  };
  std::int64_t frame = wholeWithin(std::ceil(range.firstFrame), 0, evaluation.frameCount());
  while (frame <= last && static_cast<double>(frame) <= right) {
    const auto section = evaluation.sectionAtFrame(frame);
    if (!section) break;
    std::int64_t next = section->firstFrame + section->frames;
    // Where a section has begun before, its mark shares its pixels with the one before.
    const std::int64_t stands = evaluation.frameOf(section->from);
    if (stands >= frame && section->firstFrame >= frame) {
      add(section->from, stands, silentBefore(evaluation, section->index));
      const double apart = static_cast<double>(stands) + kLeastApart * range.framesPerPixel;
      next = std::max(next, wholeWithin(std::ceil(apart), 0, evaluation.frameCount()));
    }
    if (next <= frame) break;  // the last frame of an open flight
    frame = next;
  }
  const Flight& flight = evaluation.flight();
  if (!flight.closed && static_cast<double>(last) <= right &&
      static_cast<double>(last) >= range.firstFrame) {
    const std::size_t key = flight.keys.size() - 1;
    const OrientationPlace end{key, flight.keys[key].orientations.size() - 1};
    const bool there = !marks.empty() && marks.back().frame == evaluation.frameOf(end);
    const bool silent = silentBefore(evaluation, evaluation.sectionCount());
    if (!there) add(end, evaluation.frameOf(end), silent);
  }
  return marks;
}

std::vector<Section> timelineSections(const Evaluation& evaluation, const TimelineRange& range) {
  std::vector<Section> sections;
  const double right = range.frame(range.pixels);
  std::int64_t frame = wholeWithin(std::floor(range.firstFrame), 0, evaluation.frameCount());
  while (frame < evaluation.frameCount() && static_cast<double>(frame) < right) {
    const auto section = evaluation.sectionAtFrame(frame);
    if (!section) break;
    sections.push_back(*section);
    const double apart = static_cast<double>(frame) + kLeastApart * range.framesPerPixel;
    const std::int64_t next = std::max(section->firstFrame + section->frames,
                                       wholeWithin(std::ceil(apart), 0, evaluation.frameCount()));
    if (next <= frame) break;  // an open flight's last frame belongs to its last section
    frame = next;
  }
  return sections;
}

void TimelineCache::follow(const Evaluation& evaluation, double framesPerPixel) {
  const bool same = evaluation_ && evaluation_->sameAs(evaluation);
  if (same && framesPerPixel_ == framesPerPixel && chunks_.size() < kMostChunks) return;
  evaluation_ = evaluation;
  framesPerPixel_ = framesPerPixel;
  chunks_.clear();
}

const TimelineCache::Chunk& TimelineCache::chunk(std::int64_t number) {
  const auto [at, fresh] = chunks_.try_emplace(number);
  if (fresh) {
    const TimelineRange range{static_cast<double>(number) * kChunkPixels * framesPerPixel_,
                              framesPerPixel_, kChunkPixels};
    at->second = {timelineSections(*evaluation_, range), timelineMarks(*evaluation_, range)};
  }
  return at->second;
}

std::optional<Section> sectionEndAt(const Evaluation& evaluation, const TimelineRange& range,
                                    double x, double reach) {
  const auto here = evaluation.sectionAtFrame(
      wholeWithin(std::floor(range.frame(x)), 0, evaluation.frameCount() - 1));
  if (!here) return std::nullopt;
  const auto away = [&](const Section& section) {
    return std::abs(range.x(static_cast<double>(section.firstFrame + section.frames)) - x);
  };
  std::optional<Section> best;
  if (away(*here) <= reach) best = here;
  if (here->index > 0) {
    const Section before = evaluation.section(here->index - 1);
    if (away(before) <= reach && (!best || away(before) < away(*best))) best = before;
  }
  return best;
}

}  // namespace vides
