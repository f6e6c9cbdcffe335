// SPDX-License-Identifier: MIT
// Walks over the frames and hands their text on in pieces.
#include "io/frame_writer.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <span>

#include "io/frame_text.hpp"

namespace vides {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 16;

}  // namespace

const FrameFormat* frameFormat(std::string_view wanted) {
  const auto all = frameFormats();
  const auto found =
      std::ranges::find(all, wanted, [](const FrameFormat* format) { return format->name; });
  return found == all.end() ? nullptr : *found;
}

FrameSpace spaceOf(const FrameOptions& options) {
  return options.space.value_or(options.format->space);
}

FrameRange clipped(const FrameOptions& options, std::int64_t frames) {
  const std::int64_t last = std::clamp<std::int64_t>(options.last, 0, frames);
  return {std::clamp<std::int64_t>(options.first, 0, last), last};
}

bool writeFrames(const Evaluation& evaluation, const FrameOptions& options, const TextSink& sink,
                 const FrameProgress& progress) {
  const auto [first, last] = clipped(options, evaluation.frameCount());
  const Flight& flight = evaluation.flight();
  const Space space = spaceOf(options) == FrameSpace::kWorld ? flight.space : Space{};
  const std::unique_ptr<FrameText> text =
      options.format->make({flight, space, options.firstNumber});
  if (const std::string head = text->head(); !head.empty() && !sink(head)) return false;

  const std::int64_t start = text->depends() ? 0 : first;
  FrameWalk walk(evaluation, start, last);
  const auto piece = std::make_unique_for_overwrite<char[]>(kPieceBytes + kMostFrameBytes);
  char* end = piece.get();
  const auto flush = [&] {
    const std::string_view full(piece.get(), static_cast<std::size_t>(end - piece.get()));
    end = piece.get();
    return full.empty() || sink(full);
  };
  // By the handful: evaluating and writing in turn frame by frame would cost a tenth more.
  std::array<Frame, 64> frames;
  while (walk.position() < walk.last()) {
    std::size_t count = 0;
    while (count < frames.size() && walk.next(frames[count])) ++count;
    for (const Frame& frame : std::span(frames.data(), count)) {
      if (frame.number < first) {
        text->follow(frame);
        continue;
      }
      end = text->write(frame, end);
      if (end - piece.get() >= static_cast<std::ptrdiff_t>(kPieceBytes) && !flush()) return false;
    }
    if (progress && !progress(walk.position() - start, last - start)) return false;
  }
  if (!flush()) return false;
  const std::string foot = text->foot();
  return foot.empty() || sink(foot);
}

}  // namespace vides
