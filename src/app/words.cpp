// SPDX-License-Identifier: MIT
// The panels' words in the user's language.
#include "app/words.hpp"

#include <fmt/format.h>

#include <map>

namespace vides {
namespace {

const std::map<std::string_view, std::string_view>& table() {
  static const std::map<std::string_view, std::string_view> words = {
      {"menu/file", "File"},
      {"menu/edit", "Edit"},
      {"menu/view", "View"},
      {"menu/output", "Output"},
      {"menu/settings", "Settings"},
      {"menu/help", "Help"},
      {"menu/file/new", "New"},
      {"menu/file/open", "Open\u2026"},
      {"menu/file/recent", "Open recent"},
      {"menu/file/save", "Save"},
      {"menu/file/save_as", "Save as\u2026"},
      {"menu/file/revert", "Revert"},
      {"menu/file/import", "Import scene\u2026"},
      {"menu/file/flight", "Flight\u2026"},
      {"menu/file/quit", "Quit"},
      {"menu/edit/undo", "Undo"},
      {"menu/edit/redo", "Redo"},
      {"menu/edit/cut", "Cut"},
      {"menu/edit/copy", "Copy"},
      {"menu/edit/paste", "Paste"},
      {"menu/edit/duplicate", "Duplicate"},
      {"menu/edit/delete", "Delete"},
      {"menu/edit/select_all", "Select all keys"},
      {"menu/view/front", "Front"},
      {"menu/view/side", "Side"},
      {"menu/view/top", "Top"},
      {"menu/view/iso", "Iso"},
      {"menu/view/opposite", "Opposite"},
      {"menu/view/camera", "Through the camera"},
      {"menu/view/perspective", "Perspective"},
      {"menu/view/frame_selection", "Frame selection"},
      {"menu/view/frame_all", "Frame everything"},
      {"menu/view/swap", "Swap camera view and viewport"},
      {"menu/view/left_column", "Left column"},
      {"menu/view/right_column", "Right column"},
      {"menu/view/timeline", "Timeline"},
      {"menu/view/sliders", "Sliders"},
      {"menu/view/full_screen", "Full screen"},
      {"menu/output/frames", "Frames\u2026"},
      {"menu/output/host", "Hand over to host"},
      {"menu/settings/display", "Display\u2026"},
      {"menu/settings/english", "English"},
      {"menu/settings/german", "Deutsch"},
      {"menu/settings/load", "Load setup\u2026"},
      {"menu/settings/save", "Save setup"},
      {"menu/help/shortcuts", "Shortcuts"},
      {"panel/position", "Position & curve"},
      {"panel/orientation", "Orientation"},
      {"panel/speed", "Speed"},
      {"panel/zoom", "Zoom"},
      {"panel/camera", "Camera"},
      {"panel/viewport", "Viewport"},
      {"panel/sphere", "Orientation sphere"},
      {"panel/measures", "Measures"},
      {"position/insert", "Pos +"},
      {"position/insert_many", "Pos ++"},
      {"position/append", "Append"},
      {"position/delete", "Pos \u2212"},
      {"position/previous", "\u00ab Pos"},
      {"position/next", "Pos \u00bb"},
      {"position/place", "Position"},
      {"position/own", "own"},
      {"position/key", "key"},
      {"position/change", "Change\u2026"},
      {"orientation/insert", "Ori +"},
      {"orientation/delete", "Ori \u2212"},
      {"orientation/previous", "\u00ab Ori"},
      {"orientation/next", "Ori \u00bb"},
      {"orientation/aim", "Aim"},
      {"orientation/short", "Ori"},
      {"of", "of"},
      {"orientation/roll", "Roll"},
      {"orientation/absolute", "Absolute"},
      {"orientation/relative", "Relative"},
      {"speed/duration", "Duration"},
      {"speed/hold", "Hold before"},
      {"speed/rate", "By rate"},
      {"speed/edit", "Edit\u2026"},
      {"frames_short", "fr."},
      {"camera/use", "Use this view"},
      {"camera/new_key", "New key"},
      {"camera/free", "free view"},
      {"frame", "frame"},
      {"frame_title", "Frame"},
      {"frames_per_second", "fps"},
      {"measures/length", "Length"},
      {"measures/duration", "Duration"},
      {"measures/speed", "Top speed"},
      {"measures/turn_rate", "Top turn rate"},
      {"timeline/loop", "Loop"},
      {"timeline/fit", "Show all"},
      {"timeline/speed", "speed"},
      {"timeline/turn_rate", "turn"},
      {"view/perspective", "Perspective"},
      {"view/parallel", "Parallel"},
      {"view/turn_short", "turn"},
      {"view/tilt_short", "tilt"},
      {"kind/move", "move"},
      {"kind/pan", "pan"},
      {"kind/roll", "roll"},
      {"kind/zoom", "zoom"},
      {"kind/hold", "hold"},
  };
  return words;
}

}  // namespace

std::string panelWords(std::string_view key, Language) {
  const auto found = table().find(key);
  return found == table().end() ? std::string() : std::string(found->second);
}

std::string tellText(const Text& text, Language) {
  std::string result = text.key;
  for (const TextPart& part : text.parts) {
    if (const auto* words = std::get_if<std::string>(&part.value())) result += " " + *words;
    if (const auto* number = std::get_if<std::int64_t>(&part.value()))
      result += fmt::format(" {}", *number);
    if (const auto* real = std::get_if<double>(&part.value()))
      result += fmt::format(" {:.3f}", *real);
  }
  return result;
}

}  // namespace vides
