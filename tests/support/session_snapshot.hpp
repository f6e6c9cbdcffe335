// SPDX-License-Identifier: MIT
// What of a session its user could tell apart, but for the output line: to see that what is
// refused changes nothing, also during a drag, with a window open or a question asked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit/session.hpp"

namespace vides::test {

struct SessionSnapshot {
  explicit SessionSnapshot(const Session& session)
      : flight(session.flight()),
        marks(session.state().marks),
        steps(session.history().steps()),
        undo(session.undoName()),
        redo(session.redoName()),
        windows(session.windows()),
        path(session.path()),
        recent(session.recentFiles()),
        setup(session.setup()),
        chosenPreset(session.chosenPreset()),
        frame(session.frame()),
        modified(session.modified()),
        drag(session.inDrag()),
        window(session.inWindow()),
        asks(session.question().has_value()),
        quits(session.quitRequested()) {
    if (session.inGesture()) start = session.start().flight;
  }
  bool operator==(const SessionSnapshot&) const = default;

  Flight flight;
  Marks marks;
  std::size_t steps;
  std::optional<Text> undo, redo;
  std::vector<std::string> windows;
  std::string path;
  std::vector<std::string> recent;
  Setup setup;
  int chosenPreset;
  std::int64_t frame;
  bool modified, drag, window, asks, quits;
  std::optional<Flight> start;  // of the drag or the window
};

}  // namespace vides::test
