// SPDX-License-Identifier: MIT
// A line that overwrites itself.
#include "app/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace vides {
namespace {

constexpr std::chrono::milliseconds kPatience{1000};
constexpr std::chrono::milliseconds kInterval{100};
constexpr std::size_t kMostBar = 40;

std::string_view environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

void show(std::string_view text) {
  [[maybe_unused]] const auto ignored = write(STDERR_FILENO, text.data(), text.size());
}

std::size_t terminalWidth() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

}  // namespace

Progress::Progress(std::string label, bool quiet)
    : label_(std::move(label)),
      wanted_(!quiet && isatty(STDERR_FILENO) != 0 && environment("TERM") != "dumb"),
      coloured_(environment("NO_COLOR").empty()),
      next_(Clock::now() + kPatience) {}

Progress::~Progress() {
  if (shown_) show("\r\033[K");
}

void Progress::report(std::int64_t done, std::int64_t all) {
  if (!wanted_ || all <= 0 || Clock::now() < next_) return;
  next_ = Clock::now() + kInterval;
  shown_ = true;
  draw(done, all);
}

void Progress::draw(std::int64_t done, std::int64_t all) {
  const double share = std::clamp(static_cast<double>(done) / static_cast<double>(all), 0.0, 1.0);
  const std::size_t width = terminalWidth();
  const std::size_t around = label_.size() + 10;  // blanks, brackets, per cent
  const std::size_t bar = width > around ? std::min(kMostBar, width - around) : 0;
  const auto full = static_cast<std::size_t>(share * static_cast<double>(bar));
  std::string line = fmt::format("\r{:.{}}", label_, width);
  if (bar > 0) {
    line += fmt::format(" [{}{:#>{}}{}{:>{}}] {:3.0f} %", coloured_ ? "\033[36m" : "", "", full,
                        coloured_ ? "\033[0m" : "", "", bar - full, 100.0 * share);
  }
  show(line + "\033[K");
}

}  // namespace vides
