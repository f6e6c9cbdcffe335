// SPDX-License-Identifier: MIT
// Any bytes as a recovery file and as a clipboard with keys: what is a `.vid` gives its flight and
// its keys, valid and whole; all else gives nothing.
#include "edit/clipboard_text.hpp"
#include "edit/recovery.hpp"
#include "flight/validation.hpp"
#include "fuzz/require.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"

namespace vides::test {
namespace {

void checkRecovery(std::string_view text, const ReadFlight& flight) {
  const auto work = readUnsavedWork(text);
  require(work.has_value() == flight.has_value(), "every flight is recovered, and nothing else");
  if (!work) return;
  require(work->path.find('\0') == std::string::npos, "a path has no NUL");
  require(validate(work->flight).empty(), "what is recovered is valid");
  require(work->flight.keys == flight->keys, "no key is lost");
  const auto again = readUnsavedWork(writeVid(withUnsavedPath(work->flight, work->path)));
  require(again && again->flight == work->flight && again->path == work->path,
          "what is kept is recovered as it was");
  // An editor that has opened such a file keeps its own.
  const auto other = readUnsavedWork(writeVid(withUnsavedPath(*flight, "/%\xff \"\\")));
  require(other && other->flight == work->flight && other->path == "/%\xff \"\\",
          "and so is what was opened from there");
}

void checkClipboard(std::string_view text, const ReadFlight& flight) {
  static const Flight target = [] {
    Flight other = newFlight();
    other.space = {{1.0, -2.0, 0.5}, 3.0};
    other.presets[3] = {0.25, -0.5, 0.75};
    return other;
  }();
  const auto keys = keysFromClipboard(text, target);
  require(!keys || flight.has_value(), "keys come from flights only");
  if (!keys) return;
  require(!keys->empty() && keys->size() <= flight->keys.size(), "some keys or all");
  // Pasted, they make a flight that can be kept.
  Flight pasted = target;
  for (const Key& key : *keys) pasted.keys.push_back(key);
  require(pasted.keys.size() > limits::kKeys.max || validate(pasted).empty(),
          "what is pasted is valid");
  // Copied from there and pasted again, they are the same.
  const auto selection = KeySelection::range(target.keys.size(), pasted.keys.size());
  const auto again = keysFromClipboard(clipboardText(pasted, selection), target);
  require(again && *again == *keys, "what is copied is pasted as it was");
}

}  // namespace
}  // namespace vides::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = vides::test::asText(data, size);
  const vides::ReadFlight flight = vides::readVid(text);
  vides::test::checkRecovery(text, flight);
  vides::test::checkClipboard(text, flight);
  return 0;
}
