// SPDX-License-Identifier: MIT
// What an edit is computed from and what it yields: edits are pure functions.
#pragma once

#include <optional>
#include <tl/expected.hpp>

#include "edit/command.hpp"
#include "edit/marks.hpp"
#include "edit/text.hpp"
#include "evaluate/evaluation.hpp"
#include "evaluate/section.hpp"
#include "flight/flight.hpp"

namespace vides {

struct EditState {
  Flight flight;
  Evaluation evaluation;  // of the flight
  Marks marks;            // within the flight

  const OrientationPlace& current() const { return marks.current; }
  const Key& key() const { return flight.keys[marks.current.key]; }
  const Orientation& orientation() const { return key().orientations[marks.current.orientation]; }
};

struct Edit {
  Flight flight;
  Text step;  // its name in "Undo …"
  Marks marks;
  Text note = {};  // told in the output line when it is done; empty: the current numbers
  // Undone and done again it leaves the playhead where it is.
  bool keepsPlayhead = false;
};

// The edit, or why it is refused. What an edit yields is checked again by the session.
using EditResult = tl::expected<Edit, Text>;

// The arguments of a command whose number and types were checked.
class Arguments {
 public:
  explicit Arguments(const Command& command) : arguments_(command.arguments) {}
  std::size_t size() const { return arguments_.size(); }
  bool has(std::size_t i) const { return i < arguments_.size(); }
  double number(std::size_t i) const { return std::get<double>(arguments_[i]); }
  // A whole number, 0 or more.
  std::size_t index(std::size_t i) const { return static_cast<std::size_t>(number(i)); }
  const std::string& text(std::size_t i) const { return std::get<std::string>(arguments_[i]); }
  Vec3 point(std::size_t first) const {
    return {number(first), number(first + 1), number(first + 2)};
  }

 private:
  const std::vector<Argument>& arguments_;
};

// `flight` with another version of one key.
Flight withKey(const Flight& flight, std::size_t index, Key key);

}  // namespace vides
