// SPDX-License-Identifier: MIT
// What panels hand back: commands by name, with what a gesture does to them, and layout.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edit/command.hpp"
#include "edit/layout.hpp"
#include "math/view_projection.hpp"
#include "panels/ui.hpp"

namespace vides {

struct Actions {
  struct Step {
    Command command;
    Phase phase = Phase::kCommit;
    bool gesture = false;    // one of a row of previews that ends with a commit or cancel
    bool window = false;     // of the window that previews for as long as it is open
    bool continues = false;  // of the same step of the history as the one before
  };
  std::vector<Step> steps;
  std::optional<Text> refusal;  // of what was typed
  std::optional<Layout> layout;
  std::optional<EditorView> view;    // at once; no step of the history
  std::optional<std::string> menu;   // the one that is to be open; empty: none
  std::optional<std::string> raise;  // the window that is on top now

  void run(Command command) { steps.push_back({std::move(command), Phase::kCommit, false}); }
  // One of a gesture's; the step's name is the command's.
  void during(Command command, Phase phase) { steps.push_back({std::move(command), phase, true}); }
  void inWindow(Command command) {
    steps.push_back({std::move(command), Phase::kPreview, false, true});
  }
  // A number that was typed, dragged or turned: the command that sets it.
  void number(const Ui::Typed& typed, Command command) {
    steps.push_back({std::move(command), typed.phase, typed.gesture, false, typed.continues});
  }
  template <class Make>
  void typed(const Ui::Typed& typed, Make make) {
    if (typed.value) number(typed, make(*typed.value));
  }
};

}  // namespace vides
