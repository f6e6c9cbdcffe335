// SPDX-License-Identifier: MIT
// A bar on standard error for work that takes longer than a second; on a terminal only.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace vides {

class Progress {
 public:
  // `quiet`: never show it, because results go to the same terminal.
  explicit Progress(std::string label, bool quiet = false);
  // Takes the bar away.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void report(std::int64_t done, std::int64_t all);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(std::int64_t done, std::int64_t all);

  std::string label_;
  bool wanted_;
  bool coloured_;
  bool shown_ = false;
  Clock::time_point next_;
};

}  // namespace vides
