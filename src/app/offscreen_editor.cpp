// SPDX-License-Identifier: MIT
// The editor without a screen for the commands of the command line.
#include "app/offscreen_editor.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include "app/flight_input.hpp"
#include "app/messages.hpp"
#include "edit/session_actions.hpp"
#include "io/problem_text.hpp"

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
  // What comes through a pipe comes once, and belongs to no file.
  std::error_code unknown;
  const auto status = std::filesystem::status(flight, unknown);
  if (flight == "-" || std::filesystem::is_fifo(status)) {
    auto read = readFlightOrTell(flight);
    if (read) editor.session().recover(std::move(*read), "");
    return read.has_value();
  }
  // The editor's command would tell only the first thing that is wrong.
  const std::vector<Problem> problems = SessionActions::readFlight(editor.session(), flight);
  for (const Problem& problem : problems) tell(problemLine(flight, problem));
  return problems.empty();
}

}  // namespace vides
