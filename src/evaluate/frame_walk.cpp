// SPDX-License-Identifier: MIT
// All frames in order: the section is looked up once, not once a frame.
#include <algorithm>

#include "evaluate/evaluation.hpp"
#include "evaluate/evaluation_state.hpp"

namespace vides {

// The stretch of frames that the walk is in: a hold or a section.
struct FrameWalk::Place {
  explicit Place(const Evaluation::State& state) : chain(state.chain()) {}
  Chain chain;
  Section section;                    // the entry; frames is 0 at the very end
  const KeyRecord* record = nullptr;  // of the key that it begins at
  const SectionRecord* begins = nullptr;
  const OrientationPath* path = nullptr;
  OrientationPath made;
  bool inHold = false;
};

FrameWalk::FrameWalk(const Evaluation& evaluation)
    : FrameWalk(evaluation, 0, evaluation.frameCount()) {}

FrameWalk::FrameWalk(const Evaluation& evaluation, std::int64_t first, std::int64_t last)
    : state_(evaluation.state_),
      position_(std::max<std::int64_t>(first, 0)),
      last_(std::min(last, evaluation.frameCount())),
      place_(std::make_unique<Place>(*state_)) {}

FrameWalk::~FrameWalk() = default;
FrameWalk::FrameWalk(FrameWalk&&) noexcept = default;
FrameWalk& FrameWalk::operator=(FrameWalk&&) noexcept = default;

bool FrameWalk::next(Frame& frame) {
  if (position_ >= last_) return false;
  Place& at = *place_;
  if (position_ >= at.section.firstFrame + at.section.frames) {
    const Evaluation evaluation(state_);
    const auto section = position_ < state_->tree.summary().index()
                             ? evaluation.sectionAtFrame(position_)
                             : std::nullopt;
    if (!section) {
      frame = evaluation.frame(position_++);
      return true;
    }
    at.section = *section;
    at.inHold = section->from == section->to && section->kind == SectionKind::kHold;
    at.record = state_->tree[section->from.key].get();
    at.begins = &at.record->sections[section->from.orientation];
    if (!at.inHold) at.path = &pathOf(at.chain, section->from, *at.begins, at.made);
  }
  frame.number = position_;
  frame.time = static_cast<double>(position_) / state_->flight.frameRate;
  frame.section = at.section.index;
  frame.kind = at.section.kind;
  const auto step = static_cast<double>(position_ - at.section.firstFrame);
  frame.camera = at.inHold ? cameraAtStart(*at.record, *at.begins)
                           : cameraInSection(*at.record, *at.begins, *at.path,
                                             step / static_cast<double>(at.section.frames));
  ++position_;
  return true;
}

}  // namespace vides
