// SPDX-License-Identifier: MIT
// Reads OBJ statement by statement, in one pass over the text.
#include "scene/obj_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace vides {
namespace {

constexpr bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\0'; }

// For a message: the first characters, without what would upset a terminal.
std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 32;
  std::string result(text.substr(0, kMost));
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
  }
  return text.size() > kMost ? result + "..." : result;
}

// The words of one statement. A backslash before the line's end goes on in the next line.
class Statements {
 public:
  explicit Statements(std::string_view text) : rest_(text), size_(text.size()) {}

  // False after the last line.
  bool nextLine() {
    skipLine();
    if (rest_.empty()) return false;
    ++line_;
    atEnd_ = false;
    return true;
  }

  // The next word of the line; empty at its end.
  std::string_view word() {
    skipBlanks();
    if (atEnd_) return {};
    std::size_t length = 0;
    while (length < rest_.size() && !isBlank(rest_[length]) && rest_[length] != '\n' &&
           rest_[length] != '#' && !continuesAt(length)) {
      ++length;
    }
    const std::string_view result = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return result;
  }

  std::int64_t line() const { return line_; }
  // How much of the text has been read, 0 to 1.
  double share() const {
    return 1.0 - static_cast<double>(rest_.size()) / static_cast<double>(size_);
  }

 private:
  // The length of a continuation mark at this place, or 0.
  std::size_t continuesAt(std::size_t at) const {
    if (rest_[at] != '\\') return 0;
    if (at + 1 < rest_.size() && rest_[at + 1] == '\n') return 2;
    if (at + 2 < rest_.size() && rest_[at + 1] == '\r' && rest_[at + 2] == '\n') return 3;
    return 0;
  }

  void skipBlanks() {
    while (!atEnd_) {
      if (rest_.empty() || rest_.front() == '\n' || rest_.front() == '#') {
        atEnd_ = true;
      } else if (const std::size_t length = continuesAt(0)) {
        rest_.remove_prefix(length);
        ++line_;
      } else if (isBlank(rest_.front())) {
        rest_.remove_prefix(1);
      } else {
        return;
      }
    }
  }

  // A comment and a statement that is passed over go on in the next line, too.
  void skipLine() {
    if (line_ == 0) return;
    while (!rest_.empty() && rest_.front() != '\n') {
      const std::size_t length = continuesAt(0);
      if (length > 0) ++line_;
      rest_.remove_prefix(length > 0 ? length : 1);
    }
    if (!rest_.empty()) rest_.remove_prefix(1);
  }

  std::string_view rest_;
  std::size_t size_;  // of the whole text
  std::int64_t line_ = 0;
  bool atEnd_ = true;
};

class Reader {
 public:
  Reader(std::string_view text, const KeepGoing& keepGoing)
      : statements_(text), keepGoing_(keepGoing) {}

  ReadScene read() {
    constexpr std::int64_t kBetween = 4096;  // lines from one telling to the next
    for (std::int64_t tell = kBetween; !problem_ && statements_.nextLine();) {
      if (keepGoing_ && statements_.line() >= tell) {
        tell = statements_.line() + kBetween;
        if (!keepGoing_(kFinishing * statements_.share())) return cancelled();
      }
      const std::string_view keyword = statements_.word();
      if (keyword == "v") {
        readVertex();
      } else if (keyword == "f") {
        readFace();
      } else if (keyword == "l") {
        readLine();
      } else if (keyword == "p") {
        readPoints();
      }
    }
    if (!problem_ && scene_.positions.empty()) problem_ = SceneProblem{SceneFault::kNothing, 0, ""};
    if (problem_) return tl::unexpected(std::move(*problem_));
    finishScene(scene_);
    if (keepGoing_ && !keepGoing_(1.0)) return cancelled();
    return std::move(scene_);
  }

 private:
  // Finishing begins at this share.
  static constexpr double kFinishing = 0.8;

  static ReadScene cancelled() {
    return tl::unexpected(SceneProblem{SceneFault::kCancelled, 0, ""});
  }

  void fail(SceneFault fault, std::string_view found) {
    problem_ = SceneProblem{fault, statements_.line(), shown(found)};
  }

  // x, y, z; a weight or a colour behind them is passed over.
  void readVertex() {
    Vec3 position;
    for (int i = 0; i < 3; ++i) {
      std::string_view word = statements_.word();
      const std::string_view whole = word;
      if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
      const auto [end, error] = std::from_chars(word.begin(), word.end(), position[i]);
      // Numbers too small for a double are as good as 0.
      const bool tiny = error == std::errc::result_out_of_range && isTiny(word);
      if (tiny) position[i] = 0.0;
      if ((error != std::errc() && !tiny) || end != word.end() || !std::isfinite(position[i])) {
        return fail(SceneFault::kNumber, whole);
      }
    }
    if (scene_.positions.size() >= std::numeric_limits<std::int32_t>::max()) {
      return fail(SceneFault::kTooMany, "");
    }
    scene_.positions.push_back(position);
  }

  // Which end of what a double holds a number lies beyond: its first digit that isn't 0 tells,
  // before the point or behind it, moved by the exponent.
  static bool isTiny(std::string_view word) {
    const std::size_t e = std::min(word.find_first_of("eE"), word.size());
    std::string_view exponent = word.substr(std::min(e + 1, word.size()));
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    std::int32_t shift = 0;
    const auto read = std::from_chars(exponent.begin(), exponent.end(), shift);
    // No file is long enough to make up for such an exponent.
    if (read.ec == std::errc::result_out_of_range) return exponent.starts_with('-');
    const std::size_t point = std::min(word.find('.'), e);
    const auto before = static_cast<std::int64_t>(point) -
                        static_cast<std::int64_t>(word.find_first_of("123456789"));
    return before + shift < 0;
  }

  // The vertex that one index group ("7", "7/1/3", "-1//2") means; nothing at the statement's end
  // or after a fault.
  std::optional<std::uint32_t> readIndex() {
    const std::string_view word = statements_.word();
    if (word.empty()) return std::nullopt;
    const std::string_view digits = word.substr(0, word.find('/'));
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), index);
    const auto count = static_cast<std::int64_t>(scene_.positions.size());
    if (error == std::errc::result_out_of_range) {
      fail(SceneFault::kNoSuchVertex, word);
    } else if (error != std::errc() || end != digits.end() || index == 0) {
      fail(SceneFault::kIndex, word);
    } else if (index > count || index < -count) {
      fail(SceneFault::kNoSuchVertex, word);
    } else {
      return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
    }
    return std::nullopt;
  }

  // All indices of the statement, at least `least`; empty after a fault.
  const std::vector<std::uint32_t>& readIndices(std::size_t least) {
    indices_.clear();
    while (const auto index = readIndex()) indices_.push_back(*index);
    if (!problem_ && indices_.size() < least) {
      fail(SceneFault::kTooFew, std::to_string(indices_.size()));
    }
    if (problem_) indices_.clear();
    return indices_;
  }

  void readFace() {
    const auto& corners = readIndices(3);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      scene_.edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      scene_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }

  void readLine() {
    const auto& places = readIndices(2);
    for (std::size_t i = 1; i < places.size(); ++i) {
      scene_.edges.push_back({places[i - 1], places[i]});
    }
  }

  void readPoints() {
    const auto& places = readIndices(1);
    scene_.points.insert(scene_.points.end(), places.begin(), places.end());
  }

  Statements statements_;
  const KeepGoing& keepGoing_;
  SceneGeometry scene_;
  std::vector<std::uint32_t> indices_;
  std::optional<SceneProblem> problem_;
};

}  // namespace

ReadScene readObj(std::string_view text, const KeepGoing& keepGoing) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return Reader(text, keepGoing).read();
}

}  // namespace vides
