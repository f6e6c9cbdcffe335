// SPDX-License-Identifier: MIT
// Undo and redo: flights before and after each step, limited by the memory they don't share.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>

#include "edit/marks.hpp"
#include "edit/text.hpp"
#include "flight/flight.hpp"

namespace vides {

struct Step {
  Text name;
  Flight before, after;
  Marks marksBefore, marksAfter;
  bool keepsPlayhead = false;  // which else goes to what is current
  std::size_t bytes = 0;       // what `after` and `before` don't share, estimated
};

class History {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{512} << 20;
  explicit History(std::size_t mostBytes = kMostBytes) : mostBytes_(mostBytes) {}

  // Forgets what could be redone, and the oldest steps while the limit is exceeded; the newest
  // step always stays.
  void push(Step step);
  bool canUndo() const { return at_ > 0; }
  bool canRedo() const { return at_ < steps_.size(); }
  // The step that would be undone (redone); there must be one.
  const Step& undoStep() const { return steps_[at_ - 1]; }
  const Step& redoStep() const { return steps_[at_]; }
  void undo() { --at_; }
  void redo() { ++at_; }
  void clear();

  std::size_t steps() const { return steps_.size(); }
  std::size_t bytes() const { return bytes_; }
  // Changes every flight that is held, in the same way (scene paths when the file moves).
  void rewrite(const std::function<void(Flight&)>& change);

 private:
  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  std::deque<Step> steps_;
  std::size_t at_ = 0;  // steps [0, at_) are done
};

// The bytes of `to` that `from` doesn't hold too.
std::size_t unsharedBytes(const Flight& from, const Flight& to);

}  // namespace vides
