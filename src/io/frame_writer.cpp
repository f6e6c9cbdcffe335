// SPDX-License-Identifier: MIT
// Walks over the frames and hands their text on in pieces.
#include "io/frame_writer.hpp"

#include <algorithm>
#include <vector>

#include "io/frame_text.hpp"

namespace vides {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 16;
constexpr std::int64_t kFramesPerReport = 1 << 14;

std::unique_ptr<FrameText> makeText(const Flight& flight, const FrameOptions& options) {
  const bool chan = options.format == FrameFormat::kChan;
  const FrameSpace wanted = options.space.value_or(chan ? FrameSpace::kWorld : FrameSpace::kCube);
  const Space space = wanted == FrameSpace::kWorld ? flight.space : Space{};
  switch (options.format) {
    case FrameFormat::kVides:
      return makeVidesText(space);
    case FrameFormat::kCsv:
      return makeCsvText(space);
    case FrameFormat::kJson:
      return makeJsonText(flight, space);
    case FrameFormat::kChan:
      return makeChanText(flight, space, options.firstNumber);
  }
  return nullptr;
}

}  // namespace

bool writeFrames(const Evaluation& evaluation, const FrameOptions& options, const TextSink& sink,
                 const FrameProgress& progress) {
  const std::int64_t last = std::clamp<std::int64_t>(options.last, 0, evaluation.frameCount());
  const std::int64_t first = std::clamp<std::int64_t>(options.first, 0, last);
  const std::unique_ptr<FrameText> text = makeText(evaluation.flight(), options);
  if (const std::string head = text->head(); !head.empty() && !sink(head)) return false;

  const std::int64_t start = text->depends() ? 0 : first;
  FrameWalk walk(evaluation, start, last);
  std::vector<char> piece(kPieceBytes + kMostFrameBytes);
  char* end = piece.data();
  const auto flush = [&] {
    const std::string_view full(piece.data(), static_cast<std::size_t>(end - piece.data()));
    end = piece.data();
    return full.empty() || sink(full);
  };
  Frame frame;
  while (walk.next(frame)) {
    if (frame.number < first) {
      text->follow(frame);
    } else {
      end = text->write(frame, end);
      if (end - piece.data() >= static_cast<std::ptrdiff_t>(kPieceBytes) && !flush()) return false;
    }
    if (progress && frame.number % kFramesPerReport == 0) {
      progress(frame.number - start, last - start);
    }
  }
  if (!flush()) return false;
  const std::string foot = text->foot();
  return foot.empty() || sink(foot);
}

}  // namespace vides
