// SPDX-License-Identifier: MIT
// Edits of keys.
#include "edit/key_edits.hpp"

#include <algorithm>

#include "evaluate/insertion.hpp"
#include "flight/limits.hpp"

namespace vides {
namespace {

Text textOf(InsertRefusal refusal) {
  switch (refusal) {
    case InsertRefusal::kAfterLastKey:
      return "refusal.after-last-key";
    case InsertRefusal::kTooMany:
      return "refusal.too-many-keys";
    case InsertRefusal::kAimAtKey:
      return "refusal.aim-at-new-key";
    case InsertRefusal::kNoRoom:
      return "refusal.no-room";
  }
  return {};
}

tl::unexpected<Text> noSuchKey(std::size_t key, const Flight& flight) {
  return tl::unexpected(Text("refusal.no-such-key", {key + 1, flight.keys.size()}));
}

// The last of the inserted keys becomes current, on its first orientation.
EditResult inserted(const tl::expected<Flight, InsertRefusal>& flight, std::size_t last,
                    const Text& step) {
  if (!flight) return tl::unexpected(textOf(flight.error()));
  return Edit{*flight, step, marksAt({last, 0})};
}

std::vector<Key> keysOf(const Flight& flight, const KeySelection& selection) {
  std::vector<Key> keys;
  keys.reserve(selection.size());
  for (const std::size_t k : selection.keys()) keys.push_back(flight.keys[k]);
  return keys;
}

}  // namespace

Flight withKey(const Flight& flight, std::size_t index, Key key) {
  Flight result = flight;
  result.keys.set(index, std::move(key));
  return result;
}

EditResult insertKeyEdit(const EditState& state, const Arguments&) {
  const std::size_t after = state.current().key;
  return inserted(insertKeys(state.evaluation, after, 1), after + 1,
                  Text("step.insert-key", {after + 2}));
}

EditResult insertKeysEdit(const EditState& state, const Arguments& arguments) {
  const std::size_t after = state.current().key;
  const std::size_t count = arguments.index(0);
  if (count < 1 || count > 10) return tl::unexpected(Text("refusal.insert-count", {count}));
  return inserted(insertKeys(state.evaluation, after, static_cast<int>(count)), after + count,
                  Text("step.insert-keys", {count}));
}

EditResult appendKeyEdit(const EditState& state, const Arguments&) {
  const std::size_t count = state.flight.keys.size();
  return inserted(appendKey(state.evaluation), count, Text("step.append-key", {count + 1}));
}

EditResult deleteKeysEdit(const EditState& state, const Arguments&) {
  const KeySelection& selected = state.marks.selected;
  const std::size_t size = state.flight.keys.size();
  if (selected.size() + limits::kKeys.min > size) return tl::unexpected(Text("refusal.two-keys"));
  Edit edit{state.flight, {}, {}};
  const std::vector<std::size_t>& keys = selected.keys();
  for (auto k = keys.rbegin(); k != keys.rend(); ++k) edit.flight.keys.erase(*k);
  // The predecessor of the current key among those that stay, else the first one.
  std::size_t current = state.current().key;
  while (current > 0 && selected.contains(current)) --current;
  const auto before =
      static_cast<std::size_t>(std::lower_bound(keys.begin(), keys.end(), current) - keys.begin());
  if (!selected.contains(current)) current -= before;
  edit.marks = clamped(marksAt({current, 0}), edit.flight);
  edit.step = selected.size() == 1 ? Text("step.delete-key", {keys.front() + 1})
                                   : Text("step.delete-keys", {selected.size()});
  return edit;
}

EditResult pastedKeys(const EditState& state, const std::vector<Key>& keys, Text step) {
  if (state.flight.keys.size() + keys.size() > limits::kKeys.max) {
    return tl::unexpected(Text("refusal.too-many-keys"));
  }
  const std::size_t at = state.current().key + 1;
  Edit edit{state.flight, std::move(step), {}};
  for (std::size_t i = 0; i < keys.size(); ++i) edit.flight.keys.insert(at + i, keys[i]);
  edit.marks.current = {at + keys.size() - 1, 0};
  edit.marks.selected = KeySelection::range(at, at + keys.size());
  return edit;
}

EditResult duplicateKeysEdit(const EditState& state, const Arguments&) {
  const KeySelection& selected = state.marks.selected;
  return pastedKeys(state, keysOf(state.flight, selected),
                    selected.size() == 1 ? Text("step.duplicate-key", {selected.keys().front() + 1})
                                         : Text("step.duplicate-keys", {selected.size()}));
}

EditResult moveKeyEdit(const EditState& state, const Arguments& arguments) {
  const std::size_t index = arguments.index(0);
  if (index >= state.flight.keys.size()) return noSuchKey(index, state.flight);
  Key key = state.flight.keys[index];
  key.position = arguments.point(1);
  return Edit{withKey(state.flight, index, std::move(key)), Text("step.move-key", {index + 1}),
              state.marks};
}

Vec3 offsetWithinCube(const Flight& flight, const KeySelection& keys, const Vec3& offset) {
  Vec3 result = offset;
  for (const std::size_t k : keys.keys()) {
    const Vec3& position = flight.keys[k].position;
    result = glm::clamp(result, Vec3(-1.0) - position, Vec3(1.0) - position);
  }
  return result;
}

Flight withMovedKeys(const Flight& flight, const KeySelection& keys, const Vec3& offset) {
  Flight result = flight;
  for (const std::size_t k : keys.keys()) {
    Key key = flight.keys[k];
    // Rounding must not push a key that was brought to a face beyond it.
    key.position = glm::clamp(key.position + offset, Vec3(-1.0), Vec3(1.0));
    result.keys.set(k, std::move(key));
  }
  return result;
}

EditResult moveKeysEdit(const EditState& state, const Arguments& arguments) {
  const KeySelection& selected = state.marks.selected;
  const Vec3 offset = offsetWithinCube(state.flight, selected, arguments.point(0));
  return Edit{withMovedKeys(state.flight, selected, offset),
              selected.size() == 1 ? Text("step.move-key", {selected.keys().front() + 1})
                                   : Text("step.move-keys", {selected.size()}),
              state.marks};
}

}  // namespace vides
