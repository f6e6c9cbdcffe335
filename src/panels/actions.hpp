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
    bool fromStart = false;  // of a gesture: on top of how all was at its start
  };
  std::vector<Step> steps;
  std::optional<std::string> noNumber;  // what was typed where a number belongs
  std::optional<Text> refusal;          // of something else that was typed
  std::optional<Layout> layout;
  std::optional<EditorView> view;  // at once; no step of the history

  void run(Command command) { steps.push_back({std::move(command), Phase::kCommit, false}); }
  // One of a gesture's; the step's name is the command's.
  void during(Command command, Phase phase) { steps.push_back({std::move(command), phase, true}); }
  // The same for a command that says by how much: each counts from the press.
  void sincePress(Command command, Phase phase) {
    steps.push_back({std::move(command), phase, true, false, true});
  }
  void inWindow(Command command) {
    steps.push_back({std::move(command), Phase::kPreview, false, true});
  }
  // A typed value: a command, or the refusal.
  template <class Make>
  void typed(const Ui::Typed& typed, Make make) {
    if (typed.refused) noNumber = typed.refused;
    if (typed.value) run(make(*typed.value));
  }
};

}  // namespace vides
