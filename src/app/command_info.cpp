// SPDX-License-Identifier: MIT
// `vides info`: what a flight consists of, and how well it flies; for people or for programs.
#include <fmt/compile.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <iterator>
#include <thread>
#include <vector>

#include "app/commands.hpp"
#include "app/flight_input.hpp"
#include "app/output.hpp"
#include "app/progress.hpp"
#include "evaluate/quality.hpp"

namespace vides {
namespace {

// Parts that a core measures in a few milliseconds.
constexpr std::int64_t kPart = 1 << 14;

// One part after the other, each to whoever is free: the greatest of all doesn't depend on who.
Quality measureParts(const Evaluation& evaluation, std::atomic<std::int64_t>& next,
                     const std::function<void(std::int64_t)>& report) {
  const std::int64_t all = evaluation.frameCount();
  Quality quality;
  for (std::int64_t first = 0; (first = next.fetch_add(kPart)) < all;) {
    report(first);
    quality = together(quality, measureQuality(evaluation, first, std::min(all, first + kPart)));
  }
  return quality;
}

// Two thousand million frames take minutes even so.
Quality measureWithProgress(const Evaluation& evaluation) {
  const std::int64_t all = evaluation.frameCount();
  Progress progress("Measuring");
  std::atomic<std::int64_t> next = 0;
  std::vector<std::future<Quality>> helpers;
  const auto cores = static_cast<std::int64_t>(std::thread::hardware_concurrency());
  for (std::int64_t i = 1; i < std::min(cores, all / kPart); ++i) {
    // Where no thread is to be had, nothing is left for it to do in the end.
    helpers.push_back(std::async(std::launch::async | std::launch::deferred, [&] {
      return measureParts(evaluation, next, [](std::int64_t) {});
    }));
  }
  Quality quality =
      measureParts(evaluation, next, [&](std::int64_t done) { progress.report(done, all); });
  for (auto& helper : helpers) quality = together(quality, helper.get());
  return quality;
}

double seconds(std::int64_t frames, const Flight& flight) {
  return static_cast<double>(frames) / flight.frameRate;
}

// --- for programs --------------------------------------------------------------------------------

std::string numberText(double value) {
  std::string text;
  appendJsonNumber(text, value);
  return text;
}

std::string sectionJson(const Section& s, const Flight& flight) {
  return fmt::format(FMT_COMPILE(R"({{"index":{},"kind":"{}","from":{{"key":{},"orientation":{}}},)"
                                 R"("to":{{"key":{},"orientation":{}}},"length":{},"angle_deg":{},)"
                                 R"("frames":{},"seconds":{},"first_frame":{}}})"),
                     s.index, name(s.kind), s.from.key, s.from.orientation, s.to.key,
                     s.to.orientation, numberText(s.length), numberText(s.angle), s.frames,
                     numberText(seconds(s.frames, flight)), s.firstFrame);
}

void writeJson(const Evaluation& evaluation, Output& output) {
  const Flight& flight = evaluation.flight();
  output.write(fmt::format(R"({{"keys":{},"orientations":{},"frames":{},"seconds":{},"length":{},)",
                           flight.keys.size(), flight.keys.orientations(), evaluation.frameCount(),
                           numberText(seconds(evaluation.frameCount(), flight)),
                           numberText(evaluation.length())));
  output.write("\"sections\":[");
  for (std::int64_t i = 0; i < evaluation.sectionCount(); ++i) {
    if (!output.write((i == 0 ? "\n" : ",\n") + sectionJson(evaluation.section(i), flight))) return;
  }
  const Quality quality = measureWithProgress(evaluation);
  output.write(fmt::format(
      "\n],\"quality\":{{\"max_speed\":{},\"max_angular_speed_deg\":{},\"max_speed_jump\":{},"
      "\"max_angular_speed_jump\":{},\"frames_outside_cube\":{}}}}}\n",
      numberText(quality.maxSpeed), numberText(quality.maxAngularSpeed),
      numberText(quality.maxSpeedJump), numberText(quality.maxAngularSpeedJump),
      quality.framesOutsideCube));
}

// --- for people ----------------------------------------------------------------------------------

// Control characters would play tricks with the terminal.
std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

std::string placeText(const OrientationPlace& place) {
  return fmt::format("{}.{}", place.key, place.orientation);
}

struct Widths {
  std::size_t index, place, frame, seconds;
};
Widths widthsFor(const Evaluation& evaluation) {
  const Flight& flight = evaluation.flight();
  return {
      std::max<std::size_t>(7, fmt::formatted_size("{}", evaluation.sectionCount())),
      std::max<std::size_t>(4, fmt::formatted_size("{}.9", flight.keys.size())),
      std::max<std::size_t>(11, fmt::formatted_size("{}", evaluation.frameCount())),
      std::max<std::size_t>(
          7, fmt::formatted_size("{:.2f}", seconds(evaluation.frameCount(), flight))),
  };
}

void writeTable(const Evaluation& evaluation, Output& output) {
  const Widths w = widthsFor(evaluation);
  output.write(fmt::format("{:>{}}  kind  {:<{}}  {:<{}}  {:>{}}  {:>{}}  {:>{}}  {:>9}  {:>7}\n",
                           "section", w.index, "from", w.place, "to", w.place, "first frame",
                           w.frame, "frames", w.frame, "seconds", w.seconds, "length", "degrees"));
  for (std::int64_t i = 0; i < evaluation.sectionCount(); ++i) {
    const Section s = evaluation.section(i);
    const std::string row = fmt::format(
        "{:>{}}  {:<4}  {:<{}}  {:<{}}  {:>{}}  {:>{}}  {:>{}.2f}  {:>9}  {:>7.2f}\n", s.index,
        w.index, name(s.kind), placeText(s.from), w.place, placeText(s.to), w.place, s.firstFrame,
        w.frame, s.frames, w.frame, seconds(s.frames, evaluation.flight()), w.seconds,
        s.kind == SectionKind::kMove ? fmt::format("{:.4f}", s.length) : "", s.angle);
    if (!output.write(row)) return;
  }
}

void writeText(const Evaluation& evaluation, const std::string& file, Output& output) {
  const Flight& flight = evaluation.flight();
  output.write(flight.name.empty() ? printable(file) + "\n\n" : printable(flight.name) + "\n\n");
  output.write(fmt::format("Keys          {} ({})\n", flight.keys.size(),
                           flight.closed ? "closed" : "open"));
  output.write(fmt::format("Orientations  {} (curve: {})\n", flight.keys.orientations(),
                           flight.orientationCurve->name));
  output.write(
      fmt::format("Frames        {} ({} a second)\n", evaluation.frameCount(), flight.frameRate));
  output.write(fmt::format("Seconds       {:.2f}\n", seconds(evaluation.frameCount(), flight)));
  output.write(fmt::format("Length        {:.4f} cube units\n\n", evaluation.length()));
  writeTable(evaluation, output);
  const Quality quality = measureWithProgress(evaluation);
  output.write(
      fmt::format("\nTop speed               {:.3f} cube units a second\n"
                  "Top turn rate           {:.2f} degrees a second\n"
                  "Largest speed jump      {:.1f} % from frame to frame\n"
                  "Largest turn rate jump  {:.1f} % from frame to frame\n"
                  "Frames outside cube     {}\n",
                  quality.maxSpeed, quality.maxAngularSpeed, 100.0 * quality.maxSpeedJump,
                  100.0 * quality.maxAngularSpeedJump, quality.framesOutsideCube));
}

}  // namespace

int runInfo(const InfoCommand& command) {
  const auto flight = readFlightOrTell(command.flight);
  if (!flight) return kFailed;
  const Evaluation evaluation(*flight);
  Output output;
  if (command.json) {
    writeJson(evaluation, output);
  } else {
    writeText(evaluation, command.flight, output);
  }
  return output.finish() ? kExitDone : kFailed;
}

}  // namespace vides
