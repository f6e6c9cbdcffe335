// SPDX-License-Identifier: MIT
// The editor without a screen for the commands of the command line: host, player, a flight in it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "app/drive/player.hpp"
#include "host/open_host.hpp"

namespace vides {

struct OffscreenEditor {
  std::unique_ptr<OffscreenHost> host;
  std::unique_ptr<Player> player;  // goes before its host
};

// `kind` is "osmesa" or "egl". Nothing where it can't be opened: why went to standard error.
std::optional<OffscreenEditor> openOffscreenEditor(const std::string& kind, PixelSize size,
                                                   double contentScale);

// Opens a flight in the editor; "-" is standard input. False where it can't be read: what is wrong
// went to standard error.
bool openFlightArgument(Editor& editor, const std::string& flight);

}  // namespace vides
