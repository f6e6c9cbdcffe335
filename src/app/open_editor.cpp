// SPDX-License-Identifier: MIT
// Without an editor: what can be done instead.
#include "app/open_editor.hpp"

#include <cstdlib>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/sample_frames.hpp"

namespace vides {
namespace {

bool hasDisplay() {
  for (const char* const name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* const value = std::getenv(name);
    if (value != nullptr && *value != '\0') return true;
  }
  return false;
}

}  // namespace

int openEditor(const std::optional<std::string>& flight) {
  if (!flight) return writeSampleFrames();
  tell(hasDisplay() ? "this version has no editor yet" : "no display to open the editor on");
  tell("these commands need none: vides frames, vides info, vides check (see vides --help)");
  return kFailed;
}

}  // namespace vides
