// SPDX-License-Identifier: MIT
// Any lines as commands of a session: after each the flight is valid, undoing all gives the start
// and redoing all the end, byte for byte. Commands that reach for files are left out.
#include <array>

#include "edit/command_table.hpp"
#include "edit/session.hpp"
#include "edit/texts.hpp"
#include "flight/validation.hpp"
#include "fuzz/require.hpp"
#include "io/vid_writer.hpp"

namespace vides::test {
namespace {

constexpr std::array<std::string_view, 11> kOfFiles = {
    "open",   "open-recent",  "save",       "save-as",    "revert",      "import-scene",
    "answer", "write-frames", "load-setup", "save-setup", "frames-file",
};

// Many keys make everything slow, and nothing else: a few thousand are enough.
constexpr std::size_t kEnoughKeys = 2000;
constexpr int kMostLines = 40;

bool leftOut(const Command& command) {
  if (std::find(kOfFiles.begin(), kOfFiles.end(), command.name) != kOfFiles.end()) return true;
  if (command.name != "insert-keys") return false;
  return std::get<double>(command.arguments.front()) > static_cast<double>(kEnoughKeys);
}

void check(const Session& session) {
  static const Texts words(Language::kGerman);
  const Flight& flight = session.flight();
  require(validate(flight).empty(), "the flight is valid");
  const OrientationPlace& current = session.current();
  require(current.key < flight.keys.size() &&
              current.orientation < flight.keys[current.key].orientations.size(),
          "the current orientation is the flight's");
  require(session.selected().contains(current.key), "the current key is selected");
  require(session.selected().keys().back() < flight.keys.size(), "selected keys are the flight's");
  const std::int64_t frames = session.evaluation().frameCount();
  require(session.frame() >= 0 && session.frame() < frames, "the playhead is in the flight");
  static_cast<void>(session.camera());
  require(!words.tell(session.output().text).empty(), "the output line says something");
}

void run(Session& session, std::string_view line) {
  const auto command = parseCommand(line);
  if (!command || leftOut(*command)) return;
  if (session.flight().keys.size() > kEnoughKeys && command->name != "delete-keys") return;
  const bool steady = !session.inGesture();
  const Flight before = session.flight();
  const std::size_t steps = session.history().steps();
  const bool done = session.execute(*command);
  if (!done && steady) require(session.flight() == before, "what is refused changes nothing");
  if (!done && steady) require(session.history().steps() == steps, "and is no step");
  if (session.question()) session.execute(Command("answer", "cancel"));
  check(session);
}

void backAndForth(Session& session) {
  while (!session.windows().empty()) session.execute(Command("close-window"));
  const std::string end = writeVid(session.flight());
  std::size_t steps = 0;
  while (session.execute(Command("undo"))) require(++steps < 1000, "undo comes to an end");
  check(session);
  const std::string start = writeVid(session.flight());
  // What the lines have undone could be redone beyond this.
  for (std::size_t i = 0; i < steps; ++i) require(session.execute(Command("redo")), "redo all");
  require(writeVid(session.flight()) == end, "redoing gives the end");
  check(session);
  for (std::size_t i = 0; i < steps; ++i) require(session.execute(Command("undo")), "undo all");
  require(writeVid(session.flight()) == start, "undoing gives the start");
}

}  // namespace
}  // namespace vides::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vides::test;
  std::string_view text = asText(data, size);
  vides::Session session;
  for (int line = 0; !text.empty() && line < kMostLines; ++line) {
    run(session, takeLine(text));
  }
  backAndForth(session);
  return 0;
}
