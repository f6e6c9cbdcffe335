// SPDX-License-Identifier: MIT
// A short sorted list: only keys at which another than the first orientation was chosen.
#include "edit/chosen_orientations.hpp"

#include <algorithm>

namespace vides {
namespace {

bool before(const OrientationPlace& place, std::size_t key) { return place.key < key; }

}  // namespace

const ChosenOrientations::Places& ChosenOrientations::places() const {
  static const Places kNone;
  return places_ ? *places_ : kNone;
}

std::size_t ChosenOrientations::at(const Flight& flight, std::size_t key) const {
  const auto found = std::lower_bound(places().begin(), places().end(), key, before);
  if (found == places().end() || found->key != key) return 0;
  return std::min(found->orientation, flight.keys[key].orientations.size() - 1);
}

void ChosenOrientations::choose(const OrientationPlace& place) {
  const auto found = std::lower_bound(places().begin(), places().end(), place.key, before);
  const bool known = found != places().end() && found->key == place.key;
  if (known ? found->orientation == place.orientation : place.orientation == 0) return;
  Places changed = places();
  const auto at = changed.begin() + (found - places().begin());
  if (!known) {
    changed.insert(at, place);
  } else if (place.orientation == 0) {
    changed.erase(at);
  } else {
    at->orientation = place.orientation;
  }
  places_ = std::make_shared<const Places>(std::move(changed));
}

void ChosenOrientations::follow(const Flight& from, const Flight& to) {
  if (places().empty() || from.keys.size() == to.keys.size()) return;
  // Of different sizes: one range of keys became another.
  const auto change = KeyList::Sequence::changes(from.keys.sequence(), to.keys.sequence()).front();
  Places moved;
  for (const OrientationPlace& place : places()) {
    if (place.key < change.first) moved.push_back(place);
    if (place.key < change.oldLast) continue;
    moved.push_back({place.key - change.oldLast + change.newLast, place.orientation});
  }
  places_ = std::make_shared<const Places>(std::move(moved));
}

}  // namespace vides
