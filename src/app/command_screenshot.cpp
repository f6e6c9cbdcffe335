// SPDX-License-Identifier: MIT
// `vides screenshot`: a picture of the viewport, of the camera's view, or of the whole window.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "app/commands.hpp"
#include "app/flight_scenes.hpp"
#include "app/messages.hpp"
#include "app/offscreen_editor.hpp"
#include "app/output.hpp"
#include "app/progress.hpp"

namespace vides {
namespace {

constexpr PixelSize kDefaultSize{1280, 800};

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

// A width alone: the height is as the flight's format has it. Error: a sentence.
tl::expected<PixelSize, std::string> sizeOf(const ScreenshotCommand& command,
                                            const PictureFormat& format) {
  const TypedSize given = command.size.value_or(
      command.cameraAlone() ? TypedSize{kDefaultSize.width, std::nullopt}
                            : TypedSize{kDefaultSize.width, kDefaultSize.height});
  if (given.height) return PixelSize{given.width, *given.height};
  const double height =
      std::max(1.0, std::round(static_cast<double>(given.width) * format.height / format.width));
  if (height <= kMostPixels) return PixelSize{given.width, static_cast<int>(height)};
  return Failure(
      fmt::format("{}: in the format {} x {} a picture {} wide would be {} high, but {} "
                  "are the most; --size sets it",
                  command.flight, format.width, format.height, given.width, height, kMostPixels));
}

int failed(std::string_view why) {
  tell(why);
  return kFailed;
}

}  // namespace

int runScreenshot(const ScreenshotCommand& command) {
  auto offscreen = openOffscreenEditor(command.offscreen, kDefaultSize, command.scale);
  if (!offscreen) return kFailed;
  Editor& editor = offscreen->player->editor();
  if (!openFlightArgument(editor, command.flight)) return kFailed;
  const bool all = tellScenes(editor, command.flight);
  if (!all && !command.allowMissingScenes) return kFailed;
  const auto size = sizeOf(command, editor.session().flight().picture);
  if (!size) return failed(size.error());
  const auto resized = offscreen->host->resize(*size, command.scale);
  if (!resized) return failed(resized.error());
  const auto picture = takePicture(command, *offscreen);
  if (!picture) return failed(picture.error());
  const auto bytes = encodePng(*picture);
  if (!bytes) return failed(fmt::format("{}: {}", command.output, bytes.error()));
  Output output(command.output);
  output.write(*bytes);
  return output.finish() ? kExitDone : kFailed;
}

}  // namespace vides
