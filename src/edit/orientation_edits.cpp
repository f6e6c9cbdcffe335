// SPDX-License-Identifier: MIT
// Edits of orientations and their sections.
#include "edit/orientation_edits.hpp"

#include <algorithm>

#include "edit/ease.hpp"
#include "edit/key_values.hpp"
#include "evaluate/joint.hpp"
#include "flight/limits.hpp"

namespace vides {
namespace {

// The current orientation with something changed.
template <class Change>
Edit changed(const EditState& state, const char* step, Change change) {
  Key key = state.key();
  change(key.orientations[state.current().orientation]);
  return Edit{withKey(state.flight, state.current().key, std::move(key)),
              Text(step, {state.current().key + 1}), state.marks};
}

tl::unexpected<Text> noSection() { return tl::unexpected(Text("refusal.no-section")); }

}  // namespace

bool ownsSection(const EditState& state) {
  return state.evaluation.next(state.current()) != state.current();
}

EditResult insertOrientationEdit(const EditState& state, const Arguments&) {
  Key key = state.key();
  if (key.orientations.size() >= kMostOrientations) {
    return tl::unexpected(Text("refusal.ten-orientations"));
  }
  const std::size_t at = state.current().orientation + 1;
  Orientation copy = state.orientation();
  key.orientations.insert(key.orientations.begin() + static_cast<std::ptrdiff_t>(at),
                          std::move(copy));
  Edit edit{withKey(state.flight, state.current().key, std::move(key)),
            Text("step.insert-orientation", {state.current().key + 1}), state.marks};
  edit.marks.current.orientation = at;
  return edit;
}

EditResult deleteOrientationEdit(const EditState& state, const Arguments&) {
  Key key = state.key();
  if (key.orientations.size() <= 1) return tl::unexpected(Text("refusal.one-orientation"));
  const std::size_t at = state.current().orientation;
  key.orientations.erase(key.orientations.begin() + static_cast<std::ptrdiff_t>(at));
  Edit edit{withKey(state.flight, state.current().key, std::move(key)),
            Text("step.delete-orientation", {state.current().key + 1}), state.marks};
  edit.marks.current.orientation = at == 0 ? 0 : at - 1;
  return edit;
}

EditResult setAimEdit(const EditState& state, const Arguments& arguments) {
  return changeSelected(state, "step.set-aim", "step.move-aims",
                        [&](Key& key, std::size_t orientation) -> std::optional<Text> {
                          setAimPoint(key, key.orientations[orientation], arguments.point(0));
                          return std::nullopt;
                        });
}

EditResult setAimCoordinateEdit(const EditState& state, const Arguments& arguments) {
  constexpr KeyValue kAxes[] = {KeyValue::kAimX, KeyValue::kAimY, KeyValue::kAimZ};
  return setInSelected(state, kAxes[arguments.text(0)[0] - 'x'], arguments.value(1),
                       unitsFrom(arguments, 2));
}

Flight withMovedAims(const EditState& state, const KeySelection& keys, const Vec3& offset) {
  Flight result = state.flight;
  for (const std::size_t k : keys.keys()) {
    Key key = state.flight.keys[k];
    key.orientations[state.orientationAt(k)].aim += offset;
    result.keys.set(k, std::move(key));
  }
  return result;
}

EditResult moveAimsEdit(const EditState& state, const Arguments& arguments) {
  const KeySelection& selected = state.marks.selected;
  return Edit{withMovedAims(state, selected, arguments.point(0)),
              selected.size() == 1 ? Text("step.set-aim", {selected.keys().front() + 1})
                                   : Text("step.move-aims", {selected.size()}),
              state.marks};
}

EditResult setAimModeEdit(const EditState& state, const Arguments& arguments) {
  const AimMode mode = arguments.text(0) == "absolute" ? AimMode::kAbsolute : AimMode::kRelative;
  return changed(state, "step.set-aim-mode", [&](Orientation& o) {
    if (o.aimMode == mode) return;
    const Vec3 point = aimPoint(state.key(), o);
    o.aimMode = mode;
    setAimPoint(state.key(), o, point);
  });
}

EditResult setRollEdit(const EditState& state, const Arguments& arguments) {
  return setInSelected(state, KeyValue::kRoll, arguments.value(0));
}

EditResult setZoomEdit(const EditState& state, const Arguments& arguments) {
  return setInSelected(state, KeyValue::kZoom, arguments.value(0));
}

EditResult setFocalLengthEdit(const EditState& state, const Arguments& arguments) {
  return setInSelected(state, KeyValue::kFocalLength, arguments.value(0));
}

EditResult setFieldOfViewEdit(const EditState& state, const Arguments& arguments) {
  return setInSelected(state, KeyValue::kFieldOfView, arguments.value(0));
}

EditResult setSpeedEdit(const EditState& state, const Arguments& arguments) {
  if (!ownsSection(state)) return noSection();
  return changed(state, "step.set-speed", [&](Orientation& o) {
    for (std::size_t j = 0; j < o.speed.size(); ++j) o.speed[j] = arguments.number(j);
  });
}

EditResult setSpeedValueEdit(const EditState& state, const Arguments& arguments) {
  if (!ownsSection(state)) return noSection();
  const std::size_t j = arguments.index(0);
  if (j >= kSpeedValues) return tl::unexpected(Text("refusal.speed-index", {j}));
  return changed(state, "step.set-speed",
                 [&](Orientation& o) { o.speed[j] = arguments.number(1); });
}

EditResult easeEdit(const EditState& state, const Arguments& arguments) {
  if (!ownsSection(state)) return noSection();
  return changed(state, "step.set-speed",
                 [&](Orientation& o) { o.speed = *easeValues(arguments.text(0)); });
}

EditResult matchSpeedEdit(const EditState& state, const Arguments& arguments) {
  if (!ownsSection(state)) return noSection();
  const bool before = arguments.text(0) == "before";
  const SectionEnd end = before ? SectionEnd::kStart : SectionEnd::kEnd;
  const Joint joint = jointAt(state.evaluation, state.current(), end);
  switch (joint.meeting) {
    case Joint::Meeting::kNothing:
      return tl::unexpected(
          Text(joint.value ? "refusal.match-nothing-moves" : "refusal.no-neighbour"));
    case Joint::Meeting::kRests:
      return tl::unexpected(Text("refusal.match-rest"));
    case Joint::Meeting::kOtherKind:
      return tl::unexpected(Text("refusal.match-kind"));
    case Joint::Meeting::kGoesOn:
      break;
  }
  const auto speed = matchingSpeed(state.evaluation, state.current(), end);
  if (!speed) return tl::unexpected(Text("refusal.match-reach", {joint.asFast}));
  return changed(state, "step.set-speed",
                 [&](Orientation& o) { (before ? o.speed.front() : o.speed.back()) = *speed; });
}

EditResult setDurationEdit(const EditState& state, const Arguments& arguments) {
  if (!ownsSection(state)) return noSection();
  return changed(state, "step.set-duration",
                 [&](Orientation& o) { o.duration = arguments.number(0); });
}

EditResult setDurationFramesEdit(const EditState& state, const Arguments& arguments) {
  if (!ownsSection(state)) return noSection();
  return changed(state, "step.set-duration", [&](Orientation& o) {
    o.duration = arguments.number(0) / state.flight.frameRate;
  });
}

EditResult clearDurationEdit(const EditState& state, const Arguments&) {
  return changed(state, "step.clear-duration", [&](Orientation& o) { o.duration.reset(); });
}

EditResult setHoldEdit(const EditState& state, const Arguments& arguments) {
  return changed(state, "step.set-hold", [&](Orientation& o) { o.hold = arguments.number(0); });
}

}  // namespace vides
