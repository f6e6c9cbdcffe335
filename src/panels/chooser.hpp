// SPDX-License-Identifier: MIT
// The file chooser: for flights and setups, opened and saved, and for importing scenes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edit/folder.hpp"
#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"

namespace vides {

// What stays between display frames, and the folder from one choice to the next.
struct ChooserMemory {
  enum class Mode { kChoose, kNameFolder, kOverwrite };
  std::string window;  // of the session; empty where none is open
  std::filesystem::path folder;
  std::string filter;  // patterns that the files in the list fit
  FolderOrder order;   // kept from one choice to the next, as the folder
  std::vector<FolderEntry> entries;
  std::string name;         // in the name field
  std::string nameBefore;   // while a new folder is being named
  int selected = -1;        // entry; -1 since the name was typed
  bool reveal = false;      // scrolls to the selected one
  bool rewritten = false;   // the name is another one than was typed
  bool questionWas = true;  // in the last pass: its keys aren't ours
  Mode mode = Mode::kChoose;
  std::string trouble;                    // what the system said
  std::string overwrites;                 // the file that the question is about
  OutputLine before;                      // the output line at the opening
  std::optional<std::size_t> scene = {};  // the flight's, whose file is sought
};

bool isChooser(std::string_view window);

// Draws the top one of the session's choosers; forgets its own where there is none.
void chooser(Ui& ui, const Session& session, ChooserMemory& memory, Actions& actions);

}  // namespace vides
