// SPDX-License-Identifier: MIT
// `vides drive`: the whole editor without a display, fed with events.
#include <fmt/format.h>
#include <unistd.h>

#include "app/commands.hpp"
#include "app/drive/runner.hpp"
#include "app/drive/widget_list.hpp"
#include "app/flight_scenes.hpp"
#include "app/messages.hpp"
#include "app/offscreen_editor.hpp"
#include "app/output.hpp"
#include "flight/limits.hpp"
#include "flight/printable.hpp"
#include "io/read_file.hpp"

namespace vides {
namespace {

// Everything that is wrong with a setup is told.
bool useSetup(Session& session, const std::string& path) {
  const auto text = readFile(path, kSetupBytes);
  const ReadSetup setup =
      text ? readSetup(*text) : ReadSetup(tl::unexpected(std::vector<Problem>{text.error()}));
  if (setup) {
    session.setSetup(*setup);
    return true;
  }
  for (const Problem& problem : setup.error()) tell(problemLine(path, problem));
  return false;
}

int listWidgets(Player& player) {
  Output output;
  for (const auto& [id, widget] : allWidgets(player)) {
    const std::string& label = widget.label;
    output.write(label.empty() ? id + "\n" : fmt::format("{:<32} {}\n", id, label));
  }
  return output.finish() ? kExitDone : kFailed;
}

bool writeOperated(const Player& player, const std::string& path) {
  Output output(path);
  for (const std::string& line : player.operated()) output.write(line + "\n");
  return output.finish();
}

}  // namespace

int runDrive(const DriveCommand& command) {
  auto offscreen =
      openOffscreenEditor(command.offscreen, {command.width, command.height}, command.scale);
  if (!offscreen) return kFailed;
  Player& player = *offscreen->player;
  if (command.setup && !useSetup(player.editor().session(), *command.setup)) return kFailed;
  if (command.language) player.editor().run(Command("language", *command.language));
  if (command.flight) {
    if (!openFlightArgument(player.editor(), *command.flight)) return kFailed;
    const bool all = tellScenes(player.editor(), *command.flight);
    if (!all && !command.allowMissingScenes) return kFailed;
  }
  if (command.listWidgets) return listWidgets(player);
  const auto script = command.script == "-" ? readDescriptor(STDIN_FILENO, limits::kFileSize)
                                            : readFile(command.script, limits::kFileSize);
  if (!script) {
    tell(fmt::format("{}: can't be read", command.script));
    return kFailed;
  }
  Output output;
  // What was said before a line failed is said all the same.
  ScriptRunner runner(
      player, [&](const std::string& line) { output.write(line + "\n"); },
      [](const std::string& line) { tellLine(line); });
  const auto done = runner.run(command.script, *script);
  bool written = output.finish();
  if (command.operated) written = writeOperated(player, *command.operated) && written;
  if (!done) {
    tellLine(done.error());
    return kFailed;
  }
  return written ? kExitDone : kFailed;
}

}  // namespace vides
