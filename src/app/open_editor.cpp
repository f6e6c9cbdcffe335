// SPDX-License-Identifier: MIT
// The editor in a window, from its start to its end.
#include "app/open_editor.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <future>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/assets.hpp"
#include "app/commands.hpp"
#include "app/editor.hpp"
#include "app/end_signals.hpp"
#include "app/messages.hpp"
#include "app/offscreen_editor.hpp"
#include "app/recovery_keeper.hpp"
#include "app/sample_frames.hpp"
#include "app/user_files.hpp"
#include "app/window_loop.hpp"
#include "edit/folder.hpp"
#include "host/open_host.hpp"

namespace vides {
namespace {

// `./dev run` without arguments asks for something to see even where there is no display.
int noWindow(const std::string& why, bool flightGiven) {
  const char* const instead = std::getenv("VIDES_WITHOUT_DISPLAY");
  if (!flightGiven && instead != nullptr && std::string_view(instead) == "sample") {
    return writeSampleFrames();
  }
  tell(why);
  tell(
      "these commands need no display: vides frames, vides info, vides check, vides screenshot, "
      "vides drive (see vides --help)");
  return kFailed;
}

// Opening a window takes a while in which its fonts can be made, for the commonest screens. Where
// the system has no thread left, the editor makes them itself.
std::future<FontSet> beginFonts() {
  try {
    return std::async(std::launch::async, [] { return buildFonts(1.0); });
  } catch (const std::system_error&) {
    return {};
  }
}

// What is to be done when the display is lost; not after what it uses has gone.
class LastWords {
 public:
  LastWords(Host& host, std::function<void()> words) : host_(host) {
    host_.onLost(std::move(words));
  }
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;
  ~LastWords() { host_.onLost({}); }

 private:
  Host& host_;
};

}  // namespace

int openEditor(const std::optional<std::string>& flight) {
  EndSignals signals;
  std::future<FontSet> fonts = beginFonts();
  auto host = openWindow({});
  if (!host) return noWindow(host.error(), flight.has_value());
  Host& window = **host;
  EditorOptions options;
  options.makeCurrent = [&window] { window.makeCurrent(); };
  if (fonts.valid()) options.fonts = fonts.get();
  options.clipboard = [&window] { return window.clipboard(); };
  options.setClipboard = [&window](const std::string& text) { window.setClipboard(text); };
  auto editor = Editor::create(window.gl(), std::move(options));
  if (!editor) {
    tell(editor.error());
    return kFailed;
  }
  Session& session = (*editor)->session();
  BackgroundWriter writer;
  UserFiles userFiles(writer, configFolder(), stateFolder());
  const std::optional<Text> trouble = userFiles.load(session);
  if (flight) {
    if (!openFlightArgument(**editor, *flight)) return kFailed;
  } else if (const auto sample = findAsset("flights/pyramid.vid")) {
    session.beginWithSample(sample->string());
  }
  if (trouble) session.say(MessageKind::kError, *trouble);
  RecoveryKeeper recovery(writer, stateFolder().empty() ? "" : stateFolder() / "recovery");
  recovery.offer(session);
  // An end that nobody can be asked about.
  const auto endAtOnce = [&](const std::string& why) {
    bool kept = false;
    try {
      kept = recovery.keepNow(session);
      userFiles.close(session);
    } catch (const std::exception& error) {
      tell(error.what());
    }
    tell(kept ? why + "; what was unsaved is offered at the next start" : why);
  };
  WindowLoop loop(window, **editor, userFiles, recovery);
  WindowLoop::State state = WindowLoop::State::kGoesOn;
  {
    const LastWords lastWords(window, [&] { endAtOnce("the display is gone"); });
    signals.leaveTo([&] { window.wake(); });
    while (signals.came() == 0 && state == WindowLoop::State::kGoesOn) state = loop.step();
    signals.leaveTo({});  // the window goes
  }
  if (const int signal = signals.came()) {
    endAtOnce(fmt::format("ended by SIG{}", sigabbrev_np(signal)));
    signals.finish();
  }
  // What is unsaved stays on the disk where the editor couldn't go on.
  if (state == WindowLoop::State::kQuit) recovery.close();
  userFiles.close(session);
  return state == WindowLoop::State::kQuit ? kExitDone : kFailed;
}

}  // namespace vides
