// SPDX-License-Identifier: MIT
// Any lines as commands of a session, those for files included, which get files of a folder whose
// disk fails now and then: after each the flight is valid, what is refused changes nothing (in
// drags and windows, too), undoing all gives the start and redoing all the end, byte for byte.
//
// Besides commands a line may be a drag ("~begin", "~preview COMMAND", "~commit", "~cancel") or
// trouble with the disk ("~disk" and a letter).
#include <algorithm>
#include <array>

#include "edit/command_table.hpp"
#include "edit/frame_job.hpp"
#include "edit/session.hpp"
#include "edit/texts.hpp"
#include "flight/validation.hpp"
#include "fuzz/require.hpp"
#include "io/vid_writer.hpp"
#include "support/session_snapshot.hpp"
#include "support/troubled_folder.hpp"

namespace vides::test {
namespace {

// Many keys make everything slow, and nothing else: a few thousand are enough.
constexpr std::size_t kEnoughKeys = 2000;
constexpr int kMostLines = 40;

bool leftOut(const Command& command) {
  if (command.name != "insert-keys") return false;
  return std::get<double>(command.arguments.front()) > static_cast<double>(kEnoughKeys);
}

// A file of the folder for whatever text: nothing else on this machine is opened or written.
std::size_t numberOf(std::string_view text) {
  std::size_t sum = text.size();
  for (const char c : text) sum = sum * 31 + static_cast<unsigned char>(c);
  return sum;
}
void useFolder(Command& command, const TroubledFolder& folder) {
  const std::vector<ArgumentSpecification>& specified = findCommand(command.name)->arguments;
  for (std::size_t i = 0; i < std::min(command.arguments.size(), specified.size()); ++i) {
    auto* const text = std::get_if<std::string>(&command.arguments[i]);
    if (text != nullptr && specified[i].name == "FILE") *text = folder.name(numberOf(*text));
  }
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

void drag(Session& session, std::string_view line) {
  if (line.starts_with("begin") && !session.question()) session.begin("step.move-keys");
  if (line.starts_with("commit")) session.commit();
  if (line.starts_with("cancel")) session.cancel();
  if (!line.starts_with("preview ") || session.flight().keys.size() > kEnoughKeys) return;
  const auto command = parseCommand(line.substr(8));
  if (!command || leftOut(*command)) return;
  const SessionSnapshot before(session);
  const bool previewed = session.preview(*command);
  require(previewed || before == SessionSnapshot(session), "a refused preview changes nothing");
}

// Whether it was refused by asking: that is all that has happened then.
bool asks(const Session& session) {
  const std::string& key = session.output().text.key;
  return key == "refusal.changed-on-disk" || key == "refusal.outside-cube";
}

void run(Session& session, std::string_view line, TroubledFolder& folder) {
  if (line.starts_with("~disk")) return folder.trouble(numberOf(line));
  if (line.starts_with('~')) return drag(session, line.substr(1));
  auto command = parseCommand(line);
  if (!command || leftOut(*command)) return;
  useFolder(*command, folder);
  if (session.flight().keys.size() > kEnoughKeys && command->name != "delete-keys") return;
  SessionSnapshot before(session);
  const bool done = session.execute(*command);
  session.finishFrames();
  const SessionSnapshot after(session);
  if (!done) {
    // An answer ends its question, whatever comes of it.
    if (asks(session) || (command->name == "answer" && !after.asks)) before.asks = after.asks;
    require(before == after, "what is refused changes nothing");
  }
  check(session);
}

void backAndForth(Session& session) {
  if (session.inDrag()) session.cancel();
  if (session.question()) session.execute(Command("escape"));
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
  static TroubledFolder folder;
  folder.mend();
  vides::Session session;
  for (int line = 0; !text.empty() && line < kMostLines; ++line) {
    run(session, takeLine(text), folder);
  }
  backAndForth(session);
  return 0;
}
