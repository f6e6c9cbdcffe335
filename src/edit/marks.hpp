// SPDX-License-Identifier: MIT
// What is current and what is selected: restored by undo, never a step of their own.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "evaluate/section.hpp"
#include "flight/flight.hpp"

namespace vides {

// A set of keys, in order. Copies share it.
class KeySelection {
 public:
  KeySelection() = default;
  // Sorted, each key once.
  explicit KeySelection(std::vector<std::size_t> keys);
  // The keys [first, last).
  static KeySelection range(std::size_t first, std::size_t last);

  bool contains(std::size_t key) const;
  std::size_t size() const { return keys_ ? keys_->size() : 0; }
  const std::vector<std::size_t>& keys() const;
  KeySelection with(std::size_t key) const;
  KeySelection without(std::size_t key) const;
  bool operator==(const KeySelection& other) const;

 private:
  std::shared_ptr<const std::vector<std::size_t>> keys_;
};

struct Marks {
  OrientationPlace current;  // one key and one of its orientations; begins the current section
  KeySelection selected{std::vector<std::size_t>{0}};  // the current key among them
  bool operator==(const Marks&) const = default;
};

// Current and selection brought into the flight: indices beyond its end go to its last key and the
// key's last orientation.
Marks clamped(Marks marks, const Flight& flight);

// Only this one.
Marks marksAt(const OrientationPlace& place);

}  // namespace vides
