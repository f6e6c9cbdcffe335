// SPDX-License-Identifier: MIT
// Writes frames into a file in a thread of its own: the window goes on meanwhile.
//
// Works on its own copy of an evaluation, so that the flight may change while it writes. The file
// appears whole or not at all; one that is replaced stays as it was until then. All functions
// belong to the thread that made the job.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>

#include "edit/frame_output.hpp"
#include "evaluate/evaluation.hpp"
#include "io/atomic_file.hpp"
#include "io/frame_writer.hpp"

namespace vides {

class FrameJob {
 public:
  enum class End { kWritten, kCancelled, kFailed };

  // Begins at once. Where the system has no thread left it has failed at once.
  FrameJob(Evaluation evaluation, const FrameOptions& options, std::string file);
  // Cancels what isn't done and waits for it.
  ~FrameJob();
  FrameJob(const FrameJob&) = delete;
  FrameJob& operator=(const FrameJob&) = delete;

  const std::string& file() const { return file_; }
  // Frames that it writes.
  std::int64_t frames() const { return frames_; }
  // 0 to 1.
  double share() const { return share_; }
  // It ends soon after; unless it is done already, without a trace.
  void cancel() { cancelled_ = true; }
  // Nothing while it works.
  std::optional<End> end() const;
  // What the system refused, where the end is kFailed.
  const std::optional<FileError>& error() const { return error_; }
  // Until it has ended.
  void wait();

 private:
  void work();
  void write();
  void finish(End end, std::optional<FileError> error);

  const Evaluation evaluation_;
  const FrameOptions options_;
  const std::string file_;
  const std::int64_t frames_;
  std::atomic<double> share_{0.0};
  std::atomic<bool> cancelled_{false};
  std::atomic<bool> ended_{false};
  // Written by the thread before it sets ended_.
  End end_ = End::kFailed;
  std::optional<FileError> error_;
  std::thread thread_;  // the last member: it uses the others
};

}  // namespace vides
