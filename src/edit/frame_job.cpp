// SPDX-License-Identifier: MIT
// A thread that writes frames.
#include "edit/frame_job.hpp"

#include <cerrno>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

namespace vides {

FrameJob::FrameJob(Evaluation evaluation, const FrameOptions& options, std::string file)
    : evaluation_(std::move(evaluation)),
      options_(options),
      file_(std::move(file)),
      frames_(frameCountOf(options, evaluation_.frameCount())) {
  try {
    thread_ = std::thread([this] { work(); });
  } catch (const std::system_error& error) {
    finish(End::kFailed, FileError{error.code().value(), file_});
  }
}

FrameJob::~FrameJob() {
  cancel();
  wait();
}

void FrameJob::work() {
  try {
    write();
  } catch (const std::bad_alloc&) {
    finish(End::kFailed, FileError{ENOMEM, file_});
  } catch (const std::exception&) {
    finish(End::kFailed, FileError{EIO, file_});
  }
}

void FrameJob::write() {
  AtomicFile file(file_);
  const auto progress = [&](std::int64_t done, std::int64_t all) {
    share_ = static_cast<double>(done) / static_cast<double>(all);
    return !cancelled_;
  };
  writeFrames(
      evaluation_, options_, [&](std::string_view piece) { return file.write(piece); }, progress);
  if (cancelled_) {
    file.discard();
    return finish(End::kCancelled, std::nullopt);
  }
  // What writing a piece couldn't do is told here.
  const auto saved = file.commit();
  finish(saved ? End::kWritten : End::kFailed, saved ? std::nullopt : std::optional(saved.error()));
}

void FrameJob::finish(End end, std::optional<FileError> error) {
  end_ = end;
  error_ = std::move(error);
  ended_ = true;
}

std::optional<FrameJob::End> FrameJob::end() const {
  return ended_ ? std::optional(end_) : std::nullopt;
}

void FrameJob::wait() {
  if (thread_.joinable()) thread_.join();
}

}  // namespace vides
