// SPDX-License-Identifier: MIT
// Reads OBJ statement by statement, in one pass over the text.
#include "scene/obj_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "flight/text_encoding.hpp"
#include "scene/obj_numbers.hpp"
#include "scene/obj_statements.hpp"

namespace vides {
namespace {

// What looks, names and groups are made of. All other words, free-form curves and surfaces among
// them, would be drawn and aren't, or mean nothing.
bool isPassedOver(std::string_view keyword) {
  static constexpr std::array<std::string_view, 20> kWords{
      "vt",     "vn",    "vp",    "g",          "o",         "s",        "usemtl",
      "mtllib", "mg",    "bevel", "usemap",     "maplib",    "c_interp", "d_interp",
      "lod",    "ctech", "stech", "shadow_obj", "trace_obj", "group"};
  return std::ranges::find(kWords, keyword) != kWords.end();
}

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
      readStatement();
    }
    if (!problem_) findMissingVertices();
    if (!problem_) findUsedBadVertices();
    if (problem_) return tl::unexpected(std::move(*problem_));
    finish();
    if (problem_) return tl::unexpected(std::move(*problem_));
    if (keepGoing_ && !keepGoing_(1.0)) return cancelled();
    return std::move(scene_);
  }

 private:
  // Finishing begins at this share.
  static constexpr double kFinishing = 0.8;
  static constexpr auto kMostVertices = std::numeric_limits<std::int32_t>::max();

  // Where a word stands that may turn out to be a fault.
  struct Place {
    std::int64_t line = 0;
    std::uint32_t vertex = 0;  // from 0
    std::string_view word;
  };

  static ReadScene cancelled() {
    return tl::unexpected(SceneProblem{SceneFault::kCancelled, 0, ""});
  }

  void fail(SceneFault fault, std::string_view found) { fail(fault, statements_.line(), found); }
  void fail(SceneFault fault, std::int64_t line, std::string_view found) {
    problem_ = SceneProblem{fault, line, shownWord(found)};
  }

  // Something is left out.
  void note(SceneRemark remark, std::string_view word) {
    SceneNote& note = notes_[static_cast<std::size_t>(remark)];
    if (note.count++ > 0) return;
    note.remark = remark;
    note.line = statements_.line();
    note.found = shownWord(word);
  }

  void readStatement() {
    const std::string_view keyword = statements_.word();
    if (keyword.empty()) return;
    if (keyword == "v") {
      readVertex();
    } else if (keyword == "f") {
      if (readIndices(3)) addFace();
    } else if (keyword == "l") {
      if (readIndices(2)) addLine();
    } else if (keyword == "p") {
      if (readIndices(1)) addPoints();
    } else if (!isPassedOver(keyword)) {
      note(SceneRemark::kUnknownLines, keyword);
    }
  }

  // x y, x y z, x y z w, x y z r g b, x y z r g b a; what follows the z is passed over.
  void readVertex() {
    Vec3 position(0.0);
    std::string_view bad;
    int count = 0;
    for (auto word = statements_.word(); !word.empty(); word = statements_.word(), ++count) {
      const auto number = objNumber(word);
      if (!number) return fail(SceneFault::kNumber, word);
      if (count > 2) continue;
      position[count] = *number;
      if (!std::isfinite(*number) && bad.empty()) bad = word;
    }
    if (count < 2 || count == 5 || count > 7) {
      return fail(SceneFault::kCoordinates, std::to_string(count));
    }
    if (scene_.positions.size() >= kMostVertices) return fail(SceneFault::kTooMany, "");
    if (!bad.empty()) {
      bad_.push_back(
          {statements_.line(), static_cast<std::uint32_t>(scene_.positions.size()), bad});
      note(SceneRemark::kBadVertices, bad);
    }
    scene_.positions.push_back(position);
  }

  // The vertices that the statement names come into `indices_`. False where there are fewer than
  // `least`, which is noted, or after a fault.
  bool readIndices(std::size_t least) {
    indices_.clear();
    for (auto word = statements_.word(); !word.empty(); word = statements_.word()) {
      if (!readIndex(word)) return false;
    }
    if (indices_.size() >= least) return true;
    note(SceneRemark::kTooFewCorners, {});
    return false;
  }

  bool readIndex(std::string_view word) {
    const auto index = objIndex(word);
    const auto count = static_cast<std::int64_t>(scene_.positions.size());
    if (!index) {
      fail(SceneFault::kIndex, word);
    } else if (*index < -count || *index > kMostVertices) {
      fail(SceneFault::kNoSuchVertex, word);
    } else {
      indices_.push_back(static_cast<std::uint32_t>(*index > 0 ? *index - 1 : count + *index));
      // It may come later. The first index that stays without a vertex is beyond all before it.
      const bool farthest = ahead_.empty() || indices_.back() > ahead_.back().vertex;
      if (*index > count && farthest) ahead_.push_back({statements_.line(), indices_.back(), word});
    }
    return !problem_;
  }

  void addFace() {
    ++scene_.report.faces;
    for (std::size_t i = 0; i < indices_.size(); ++i) {
      scene_.edges.push_back({indices_[i], indices_[(i + 1) % indices_.size()]});
    }
    for (std::size_t i = 2; i < indices_.size(); ++i) {
      scene_.triangles.push_back({indices_[0], indices_[i - 1], indices_[i]});
    }
  }

  void addLine() {
    ++scene_.report.lines;
    for (std::size_t i = 1; i < indices_.size(); ++i) {
      scene_.edges.push_back({indices_[i - 1], indices_[i]});
    }
  }

  void addPoints() {
    scene_.report.points += static_cast<std::int64_t>(indices_.size());
    scene_.points.insert(scene_.points.end(), indices_.begin(), indices_.end());
  }

  void findMissingVertices() {
    const auto missing = std::ranges::find_if(
        ahead_, [&](const Place& place) { return place.vertex >= scene_.positions.size(); });
    if (missing != ahead_.end()) fail(SceneFault::kNoSuchVertex, missing->line, missing->word);
  }

  void findUsedBadVertices() {
    if (bad_.empty()) return;
    std::vector<std::uint8_t> used(scene_.positions.size(), 0);
    for (const auto& edge : scene_.edges) used[edge[0]] = used[edge[1]] = 1;
    for (const auto point : scene_.points) used[point] = 1;
    const auto first =
        std::ranges::find_if(bad_, [&](const Place& place) { return used[place.vertex] != 0; });
    if (first != bad_.end()) fail(SceneFault::kBadVertex, first->line, first->word);
  }

  void finish() {
    for (SceneNote& note : notes_) {
      if (note.count > 0) scene_.report.notes.push_back(note);
    }
    finishScene(scene_);
    if (!scene_.empty()) return;
    const SceneNote& unknown = notes_[static_cast<std::size_t>(SceneRemark::kUnknownLines)];
    problem_ = bad_.empty() ? SceneProblem{SceneFault::kNothing, unknown.line, unknown.found}
                            : SceneProblem{SceneFault::kNothingDrawn, bad_.front().line,
                                           shownWord(bad_.front().word)};
  }

  ObjStatements statements_;
  const KeepGoing& keepGoing_;
  SceneGeometry scene_;
  std::vector<std::uint32_t> indices_;  // of the statement
  std::vector<Place> ahead_;            // indices of vertices that had not come yet, ascending
  std::vector<Place> bad_;              // vertices that aren't finite
  std::array<SceneNote, 3> notes_;      // by remark; count 0: none
  std::optional<SceneProblem> problem_;
};

ReadScene refused(SceneFault fault, std::int64_t line, std::string found) {
  return tl::unexpected(SceneProblem{fault, line, std::move(found)});
}

}  // namespace

ReadScene readObj(std::string_view text, const KeepGoing& keepGoing) {
  const TextEncoding encoding = encodingOf(text);
  if (encoding == TextEncoding::kUtf32) return refused(SceneFault::kEncoding, 0, name(encoding));
  std::optional<std::string> converted;
  if (encoding != TextEncoding::kUtf8) {
    converted = utf8FromUtf16(text, encoding);
    if (!converted) return refused(SceneFault::kEncoding, 0, name(encoding));
    text = *converted;
  }
  text = withoutByteOrderMark(text);
  if (const std::size_t nul = text.find('\0'); nul != text.npos) {
    return refused(SceneFault::kNul, 1 + lineEnds(text.substr(0, nul)), "");
  }
  return Reader(text, keepGoing).read();
}

}  // namespace vides
