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

std::unique_ptr<FrameText> makeText(const Flight& flight, const FrameOptions& options) {
  const Space space = spaceOf(options) == FrameSpace::kWorld ? flight.space : Space{};
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

std::string_view name(FrameFormat format) {
  switch (format) {
    case FrameFormat::kVides:
      break;
    case FrameFormat::kCsv:
      return "csv";
    case FrameFormat::kJson:
      return "json";
    case FrameFormat::kChan:
      return "chan";
  }
  return "vides";
}

std::optional<FrameFormat> frameFormat(std::string_view wanted) {
  const auto found = std::find_if(kFrameFormats.begin(), kFrameFormats.end(),
                                  [&](FrameFormat format) { return name(format) == wanted; });
  return found == kFrameFormats.end() ? std::nullopt : std::optional(*found);
}

FrameSpace spaceOf(const FrameOptions& options) {
  const bool chan = options.format == FrameFormat::kChan;
  return options.space.value_or(chan ? FrameSpace::kWorld : FrameSpace::kCube);
}

FrameRange clipped(const FrameOptions& options, std::int64_t frames) {
  const std::int64_t last = std::clamp<std::int64_t>(options.last, 0, frames);
  return {std::clamp<std::int64_t>(options.first, 0, last), last};
}

bool writeFrames(const Evaluation& evaluation, const FrameOptions& options, const TextSink& sink,
                 const FrameProgress& progress) {
  const auto [first, last] = clipped(options, evaluation.frameCount());
  const std::unique_ptr<FrameText> text = makeText(evaluation.flight(), options);
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
