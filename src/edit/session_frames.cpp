// SPDX-License-Identifier: MIT
// Commands of Output → Frames…: what is written, and the writing.
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

#include "edit/folder.hpp"
#include "edit/frame_job.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;
using Result = SessionActions::Result;

// Why frames must not go there; nothing where they may.
std::optional<Text> obstacleAt(const std::string& file, const std::string& flightPath) {
  std::error_code error;
  if (!flightPath.empty() && fs::equivalent(file, flightPath, error)) {
    return Text("refusal.frames-over-flight", {fileName(file)});
  }
  const fs::file_status status = fs::status(file, error);
  // A pipe may never be read from: the thread that waits for it couldn't be ended.
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    return Text("refusal.no-file", {fileName(file)});
  }
  return std::nullopt;
}

}  // namespace

std::string Session::framesFile() const { return frameFile(frameOutput_, path(), "untitled"); }

Result SessionActions::framesFormat(Session& session, const Arguments& arguments) {
  FrameOutput& output = session.frameOutput_;
  output.options.format = frameFormat(arguments.text(0));  // checked before
  output.file = withEndingOf(output.file, *output.options.format);
  return {};
}

Result SessionActions::framesSpace(Session& session, const Arguments& arguments) {
  session.frameOutput_.options.space =
      arguments.text(0) == "world" ? FrameSpace::kWorld : FrameSpace::kCube;
  return {};
}

Result SessionActions::framesRange(Session& session, const Arguments& arguments) {
  FrameOptions& options = session.frameOutput_.options;
  if (!arguments.has(0)) {
    options.first = 0;
    options.last = std::numeric_limits<std::int64_t>::max();
    return {};
  }
  const auto first = static_cast<std::int64_t>(arguments.number(0));
  const auto end = static_cast<std::int64_t>(arguments.number(1));
  const std::int64_t frames = session.evaluation().frameCount();
  if (first >= end || first >= frames) {
    return tl::unexpected(Text("refusal.frame-range", {first, end - 1, frames - 1}));
  }
  options.first = first;
  options.last = end >= frames ? std::numeric_limits<std::int64_t>::max() : end;
  return {};
}

Result SessionActions::framesFirstNumber(Session& session, const Arguments& arguments) {
  const double number = arguments.number(0);
  if (number != std::floor(number) || std::abs(number) > 1e12) {
    return tl::unexpected(Text("refusal.first-number", {number}));
  }
  session.frameOutput_.options.firstNumber = static_cast<std::int64_t>(number);
  return {};
}

Result SessionActions::framesFile(Session& session, const Arguments& arguments) {
  session.frameOutput_.file = arguments.text(0);
  hideWindow(session, "chooser-frames");
  return {};
}

Result SessionActions::writeFrames(Session& session, const Arguments&) {
  if (session.frameJob_) return tl::unexpected(Text("refusal.writing-frames"));
  const std::string file = session.framesFile();
  if (auto why = obstacleAt(file, session.path())) return tl::unexpected(std::move(*why));
  const FrameOptions& options = session.frameOutput_.options;
  const std::int64_t frames = session.evaluation().frameCount();
  if (frameCountOf(options, frames) == 0) {
    return tl::unexpected(
        Text("refusal.frame-range", {options.first, options.last - 1, frames - 1}));
  }
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error)) && file != session.framesAgreed_) {
    session.question_ = Question{Question::Kind::kFramesExist,
                                 Text("question.frames-exist", {fileName(file)}),
                                 {"overwrite", "cancel"}};
    session.afterAnswer_ = Command("write-frames");
    session.output_ = {};  // of what was refused before
    return {};
  }
  session.framesAgreed_ = file;
  session.frameJob_ = std::make_unique<FrameJob>(session.evaluation(), options, file);
  session.output_ = {MessageKind::kDone, Text("output.writing-frames", {fileName(file)})};
  return {};
}

Result SessionActions::cancelFrames(Session& session, const Arguments&) {
  session.frameJob_->cancel();
  return {};
}

void Session::finishFrames() {
  if (!frameJob_) return;
  frameJob_->wait();
  collectFrames();
}

// What came of the writing is told as soon as it is known.
void Session::collectFrames() {
  if (!frameJob_ || !frameJob_->end()) return;
  const std::unique_ptr<FrameJob> job = std::move(frameJob_);
  const std::string file = fileName(job->file());
  switch (*job->end()) {
    case FrameJob::End::kWritten:
      say(MessageKind::kDone, Text("output.frames-written", {job->frames(), file}));
      SessionActions::hideWindow(*this, "frames");
      break;
    case FrameJob::End::kCancelled:
      say(MessageKind::kDone, Text("output.frames-cancelled", {file}));
      break;
    case FrameJob::End::kFailed:
      say(MessageKind::kError, Text("output.frames-failed", {file, problemOf(*job->error())}));
      break;
  }
  if (question_ && question_->kind == Question::Kind::kWritingFrames) {
    question_.reset();
    const Command command = *afterAnswer_;
    afterAnswer_.reset();
    execute(command);
  }
}

}  // namespace vides
