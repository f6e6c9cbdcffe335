// SPDX-License-Identifier: MIT
// Undo and redo, and what a step costs.
#include "edit/history.hpp"

namespace vides {
namespace {

// A leaf or inner node of the tree of keys with its arrays, and the shared pointers' blocks.
constexpr std::size_t kNodeBytes = 1600;
constexpr std::size_t kNodeItems = 16;  // at least, on average
constexpr std::size_t kBlockBytes = 32;

std::size_t bytesOf(const Key& key) {
  return sizeof(Key) + kBlockBytes + key.orientations.capacity() * sizeof(Orientation);
}

std::size_t bytesOfScene(const Flight& flight) {
  std::size_t bytes = flight.scene.size() * sizeof(SceneFile);
  for (const SceneFile& file : flight.scene) bytes += file.file.size();
  return bytes;
}

std::size_t bytesOf(const KeySelection& selection) {
  return selection.size() * sizeof(std::size_t);
}

}  // namespace

std::size_t unsharedBytes(const Flight& from, const Flight& to) {
  std::size_t bytes = sizeof(Flight) + to.name.size() + bytesOfScene(to);
  std::size_t depth = 1;
  for (std::size_t n = to.keys.size(); n > kNodeItems; n /= kNodeItems) ++depth;
  std::size_t changed = 0;
  for (const auto& change : KeyList::Sequence::changes(from.keys.sequence(), to.keys.sequence())) {
    to.keys.forEach(change.first, change.newLast, [&](const Key& key) { bytes += bytesOf(key); });
    bytes += depth * kNodeBytes;
    changed += change.newLast - change.first;
  }
  bytes += changed / kNodeItems * kNodeBytes;
  // So large a change rebuilds the tree.
  if (changed > 64 + to.keys.size() / 8) bytes += to.keys.size() / kNodeItems * kNodeBytes;
  return bytes;
}

void History::push(Step step) {
  while (canRedo()) {
    bytes_ -= steps_.back().bytes;
    steps_.pop_back();
  }
  ++revision_;
  // Undo needs `before`, which may be the whole of an imported flight that nothing else holds.
  step.bytes = unsharedBytes(step.before, step.after) + unsharedBytes(step.after, step.before) +
               bytesOf(step.marksBefore.selected) + bytesOf(step.marksAfter.selected);
  bytes_ += step.bytes;
  steps_.push_back(std::move(step));
  while (bytes_ > mostBytes_ && steps_.size() > 1) {
    bytes_ -= steps_.front().bytes;
    steps_.pop_front();
  }
  at_ = steps_.size();
}

void History::extend(const Flight& after, const Marks& marksAfter) {
  Step step = std::move(steps_.back());
  bytes_ -= step.bytes;
  steps_.pop_back();
  --at_;
  step.after = after;
  step.marksAfter = marksAfter;
  push(std::move(step));
}

void History::clear() {
  ++revision_;
  steps_.clear();
  at_ = 0;
  bytes_ = 0;
}

void History::rewrite(const std::function<void(Flight&)>& change) {
  for (Step& step : steps_) {
    change(step.before);
    change(step.after);
  }
}

}  // namespace vides
