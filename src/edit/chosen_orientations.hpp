// SPDX-License-Identifier: MIT
// Which orientation was last current at each key: what "their current orientation" of several keys
// means. Where none was chosen it is the first.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "evaluate/section.hpp"
#include "flight/flight.hpp"

namespace vides {

// Copies share what they hold.
class ChosenOrientations {
 public:
  // One that the key has, whatever was chosen of more than there are now.
  std::size_t at(const Flight& flight, std::size_t key) const;
  void choose(const OrientationPlace& place);
  // Keys came and went: each keeps what was chosen at it.
  void follow(const Flight& before, const Flight& after);
  bool sameAs(const ChosenOrientations& other) const { return places_ == other.places_; }

 private:
  using Places = std::vector<OrientationPlace>;  // by key, none of a first orientation
  const Places& places() const;

  std::shared_ptr<const Places> places_;
};

}  // namespace vides
