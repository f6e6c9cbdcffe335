// SPDX-License-Identifier: MIT
// Sets of keys, and marks kept within a flight.
#include "edit/marks.hpp"

#include <algorithm>
#include <numeric>

namespace vides {

KeySelection::KeySelection(std::vector<std::size_t> keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  keys_ = std::make_shared<const std::vector<std::size_t>>(std::move(keys));
}

KeySelection KeySelection::range(std::size_t first, std::size_t last) {
  std::vector<std::size_t> keys(last - first);
  std::iota(keys.begin(), keys.end(), first);
  return KeySelection(std::move(keys));
}

bool KeySelection::contains(std::size_t key) const {
  return keys_ && std::binary_search(keys_->begin(), keys_->end(), key);
}

const std::vector<std::size_t>& KeySelection::keys() const {
  static const std::vector<std::size_t> kNone;
  return keys_ ? *keys_ : kNone;
}

KeySelection KeySelection::with(std::size_t key) const {
  if (contains(key)) return *this;
  std::vector<std::size_t> all = keys();
  all.push_back(key);
  return KeySelection(std::move(all));
}

KeySelection KeySelection::without(std::size_t key) const {
  std::vector<std::size_t> rest = keys();
  std::erase(rest, key);
  return KeySelection(std::move(rest));
}

bool KeySelection::operator==(const KeySelection& other) const {
  return keys_ == other.keys_ || keys() == other.keys();
}

Marks clamped(Marks marks, const Flight& flight) {
  const std::size_t last = flight.keys.size() - 1;
  if (marks.current.key > last) marks.current = {last, kMostOrientations};
  const std::size_t orientations = flight.keys[marks.current.key].orientations.size();
  marks.current.orientation = std::min(marks.current.orientation, orientations - 1);
  const std::vector<std::size_t>& keys = marks.selected.keys();
  if (!keys.empty() && keys.back() > last) {
    const auto beyond = std::upper_bound(keys.begin(), keys.end(), last);
    marks.selected = KeySelection(std::vector<std::size_t>(keys.begin(), beyond));
  }
  marks.selected = marks.selected.with(marks.current.key);
  return marks;
}

Marks marksAt(const OrientationPlace& place) {
  return {place, KeySelection(std::vector<std::size_t>{place.key})};
}

}  // namespace vides
