// SPDX-License-Identifier: MIT
// `vides drive`: the whole editor without a display, fed with events.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>

#include "app/commands.hpp"
#include "app/drive/runner.hpp"
#include "app/drive/widget_list.hpp"
#include "app/messages.hpp"
#include "app/offscreen_editor.hpp"
#include "app/output.hpp"

namespace vides {
namespace {

std::optional<std::string> readText(const std::string& file) {
  if (file == "-") return std::string(std::istreambuf_iterator<char>(std::cin), {});
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

int listWidgets(Player& player) {
  Output output;
  for (const auto& [id, label] : allWidgets(player)) {
    output.write(label.empty() ? id + "\n" : fmt::format("{:<32} {}\n", id, label));
  }
  return output.finish() ? kExitDone : kFailed;
}

}  // namespace

int runDrive(const DriveCommand& command) {
  auto offscreen =
      openOffscreenEditor(command.offscreen == "egl" ? OffscreenKind::kEgl : OffscreenKind::kOsmesa,
                          {command.width, command.height}, command.scale);
  if (!offscreen) {
    tell(offscreen.error());
    return kFailed;
  }
  Player& player = *offscreen->player;
  player.editor().run(Command("language", command.language));
  if (command.flight && !openFlightArgument(player.editor(), *command.flight)) return kFailed;
  if (command.listWidgets) return listWidgets(player);
  const auto script = readText(command.script);
  if (!script) {
    tell(fmt::format("{}: can't be read", command.script));
    return kFailed;
  }
  Output output;
  // What was said before a line failed is said all the same.
  ScriptRunner runner(player, [&](const std::string& line) { output.write(line + "\n"); });
  const auto done = runner.run(command.script, *script);
  const bool written = output.finish();
  if (!done) {
    std::cerr << done.error() << '\n';
    return kFailed;
  }
  return written ? kExitDone : kFailed;
}

}  // namespace vides
