// SPDX-License-Identifier: MIT
// The editor without a screen for the commands of the command line.
#include "app/offscreen_editor.hpp"

#include <utility>

#include "app/flight_input.hpp"
#include "app/messages.hpp"

namespace vides {

tl::expected<OffscreenEditor, std::string> openOffscreenEditor(OffscreenKind kind, PixelSize size,
                                                               double contentScale) {
  OffscreenOptions options;
  options.size = size;
  options.contentScale = contentScale;
  auto host = openOffscreen(kind, options);
  if (!host) return Failure(host.error());
  auto player = Player::create(**host);
  if (!player) return Failure(player.error());
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
