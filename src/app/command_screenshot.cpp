// SPDX-License-Identifier: MIT
// `vides screenshot`: a picture of the viewport, of the camera's view, or of the whole window.
#include <fmt/format.h>
#include <unistd.h>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/offscreen_editor.hpp"
#include "app/output.hpp"
#include "app/progress.hpp"

namespace vides {
namespace {

tl::expected<Picture, std::string> takePicture(const ScreenshotCommand& command,
                                               OffscreenEditor& offscreen) {
  Player& player = *offscreen.player;
  Editor& editor = player.editor();
  if (!command.wholeWindow) {
    Layout layout;
    layout.bare = true;
    editor.setLayout(layout);
  }
  editor.run(Command("view", command.view));
  if (command.frame) {
    const std::int64_t frames = editor.session().evaluation().frameCount();
    if (*command.frame < 0 || *command.frame >= frames) {
      return Failure(
          fmt::format("--frame {}: the flight has the frames 0 to {}", *command.frame, frames - 1));
    }
    editor.run(Command("go-to-frame", *command.frame));
  }
  player.frame();
  {
    Progress progress("Measuring", command.output == "-" && isatty(STDOUT_FILENO) != 0);
    editor.finishMeasures([&](std::int64_t done, std::int64_t all) { progress.report(done, all); });
  }
  // Until nothing moves any more.
  do {
    player.frame();
  } while (player.unfinished());
  return player.picture();
}

}  // namespace

int runScreenshot(const ScreenshotCommand& command) {
  auto offscreen =
      openOffscreenEditor(command.offscreen, {command.width, command.height}, command.scale);
  if (!offscreen) return kFailed;
  if (!openFlightArgument(offscreen->player->editor(), command.flight)) return kFailed;
  const auto picture = takePicture(command, *offscreen);
  if (!picture) {
    tell(picture.error());
    return kFailed;
  }
  const auto bytes = encodePng(*picture);
  if (!bytes) {
    tell(fmt::format("{}: {}", command.output, bytes.error()));
    return kFailed;
  }
  Output output(command.output);
  output.write(*bytes);
  return output.finish() ? kExitDone : kFailed;
}

}  // namespace vides
