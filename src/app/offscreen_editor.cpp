// SPDX-License-Identifier: MIT
// The editor without a screen for the commands of the command line.
#include "app/offscreen_editor.hpp"

#include <utility>

#include "app/flight_input.hpp"
#include "app/messages.hpp"

namespace vides {

std::optional<OffscreenEditor> openOffscreenEditor(const std::string& kind, PixelSize size,
                                                   double contentScale) {
  OffscreenOptions options;
  options.size = size;
  options.contentScale = contentScale;
  auto host = openOffscreen(kind == "egl" ? OffscreenKind::kEgl : OffscreenKind::kOsmesa, options);
  if (!host) {
    tell(host.error());
    return std::nullopt;
  }
  auto player = Player::create(**host);
  if (!player) {
    tell(player.error());
    return std::nullopt;
  }
  return OffscreenEditor{std::move(*host), std::move(*player)};
}

bool openFlightArgument(Editor& editor, const std::string& flight) {
  // Read here first: the editor would tell only the first thing that is wrong.
  auto read = readFlightOrTell(flight);
  if (!read) return false;
  if (flight == "-") {
    editor.session().recover(std::move(*read), "");
    return true;
  }
  if (editor.run(Command("open", flight))) return true;
  tell(editor.words(editor.session().output().text));
  return false;
}

}  // namespace vides
