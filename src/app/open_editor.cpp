// SPDX-License-Identifier: MIT
// The editor in a window: sleeps until something happens, and then draws a display frame.
#include "app/open_editor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <future>
#include <limits>
#include <string_view>
#include <thread>

#include "app/assets.hpp"
#include "app/commands.hpp"
#include "app/editor.hpp"
#include "app/end_signals.hpp"
#include "app/messages.hpp"
#include "app/offscreen_editor.hpp"
#include "app/recovery_keeper.hpp"
#include "app/sample_frames.hpp"
#include "app/user_files.hpp"
#include "edit/folder.hpp"
#include "host/open_host.hpp"

namespace vides {
namespace {

// Screens faster than this gain nothing; without vertical synchronisation we limit ourselves.
constexpr double kLeastFrameSeconds = 1.0 / 120.0;
constexpr std::chrono::duration<double> kLongest = std::chrono::hours(1);

CursorShape cursorOf(PointerShape shape) {
  switch (shape) {
    case PointerShape::kText:
      return CursorShape::kText;
    case PointerShape::kHand:
    case PointerShape::kMove:
      return CursorShape::kHand;
    case PointerShape::kHorizontal:
      return CursorShape::kHorizontal;
    case PointerShape::kVertical:
      return CursorShape::kVertical;
    case PointerShape::kArrow:
      break;
  }
  return CursorShape::kArrow;
}

// What the window shows besides the picture, told to it only where it changes.
class WindowDress {
 public:
  explicit WindowDress(Host& host) : host_(host) {}
  void put(const FrameOutcome& outcome) {
    if (outcome.title != title_) host_.setTitle(title_ = outcome.title);
    const CursorShape cursor = cursorOf(outcome.pointer);
    if (cursor != cursor_) host_.setCursor(cursor_ = cursor);
    if (outcome.fullScreen != host_.fullScreen()) host_.setFullScreen(outcome.fullScreen);
  }

 private:
  Host& host_;
  std::string title_;
  CursorShape cursor_ = CursorShape::kArrow;
};

// Until the editor is quit or a signal ends it.
void runWindow(Host& host, Editor& editor, UserFiles& userFiles, RecoveryKeeper& recovery,
               const EndSignals& signals) {
  using Seconds = std::chrono::duration<double>;
  WindowDress dress(host);
  double due = 0.0;  // when the next display frame is wanted; the first at once
  double last = -1.0;
  while (signals.came() == 0) {
    FrameInput input;
    input.events = host.takeEvents();
    if (input.events.empty() && host.time() < due) {
      host.waitForEvents(std::min(Seconds(due - host.time()), kLongest));
      continue;
    }
    if (const double early = last + kLeastFrameSeconds - host.time(); early > 0.0) {
      std::this_thread::sleep_for(Seconds(early));
      for (InputEvent& event : host.takeEvents()) input.events.push_back(std::move(event));
    }
    last = input.time = host.time();
    input.size = host.size();
    input.contentScale = host.contentScale();
    const bool visible = host.beginDrawing();
    const FrameOutcome outcome = editor.frame(input);
    if (visible) host.swap();
    if (outcome.quit) return;
    dress.put(outcome);
    due = std::numeric_limits<double>::infinity();
    for (const std::optional<double>& wanted :
         {outcome.nextFrameIn, userFiles.follow(editor.session(), input.time),
          recovery.follow(editor.session(), input.time)}) {
      due = std::min(due, input.time + wanted.value_or(due));
    }
  }
}

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

}  // namespace

int openEditor(const std::optional<std::string>& flight) {
  EndSignals signals;
  // Opening a window takes a while in which its fonts can be made, for the commonest screens.
  std::future<FontSet> fonts = std::async(std::launch::async, &buildFonts, 1.0);
  auto host = openWindow({});
  if (!host) return noWindow(host.error(), flight.has_value());
  Host& window = **host;
  window.makeCurrent();
  EditorOptions options;
  options.fonts = fonts.get();
  options.clipboard = [&window] { return window.clipboard(); };
  options.setClipboard = [&window](const std::string& text) { window.setClipboard(text); };
  auto editor = Editor::create(window.gl(), std::move(options));
  if (!editor) {
    tell(editor.error());
    return kFailed;
  }
  BackgroundWriter writer;
  UserFiles userFiles(writer, configFolder(), stateFolder());
  const std::optional<Text> trouble = userFiles.load((*editor)->session());
  if (flight) {
    if (!openFlightArgument(**editor, *flight)) return kFailed;
  } else if (const auto sample = findAsset("flights/pyramid.vid")) {
    (*editor)->session().beginWithSample(sample->string());
  }
  if (trouble) (*editor)->session().say(MessageKind::kError, *trouble);
  RecoveryKeeper recovery(writer, stateFolder().empty() ? "" : stateFolder() / "recovery");
  recovery.offer((*editor)->session());
  // An end that nobody can be asked about.
  const auto endAtOnce = [&](const std::string& why) {
    const bool kept = recovery.keepNow((*editor)->session());
    userFiles.close((*editor)->session());
    tell(kept ? why + "; what was unsaved is offered at the next start" : why);
  };
  window.onLost([&] { endAtOnce("the display is gone"); });
  signals.leaveTo([&] { window.wake(); });
  runWindow(window, **editor, userFiles, recovery, signals);
  signals.leaveTo({});  // the window goes
  if (const int signal = signals.came()) {
    endAtOnce(fmt::format("ended by SIG{}", sigabbrev_np(signal)));
    signals.finish();
  }
  recovery.close();
  userFiles.close((*editor)->session());
  window.makeCurrent();
  editor->reset();
  return kExitDone;
}

}  // namespace vides
