// SPDX-License-Identifier: MIT
// out/pyramid.txt, and a few lines about what comes next.
#include "app/sample_frames.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "app/assets.hpp"
#include "app/commands.hpp"
#include "app/flight_input.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSample = "flights/pyramid.vid";

// Shorter where the sample lies below the current folder.
std::string shown(const fs::path& path) {
  std::error_code unknown;
  const fs::path relative = fs::relative(path, unknown);
  return unknown || relative.empty() || *relative.begin() == ".." ? path.string()
                                                                  : relative.string();
}

// As a word that a shell takes for this text: in quotes where it needs them.
std::string shellWord(const std::string& text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+,:@%=";
  if (text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

}  // namespace

int writeSampleFrames() {
  const auto sample = findAsset(kSample);
  if (!sample) {
    tell(fmt::format("the sample {} is not where it should be; VIDES_ASSETS may name the folder",
                     kSample));
    return kFailed;
  }
  const auto flight = readFlightOrTell(sample->string());
  if (!flight) return kFailed;
  std::error_code refused;
  fs::create_directories("out", refused);
  if (refused) {
    tell("out: " + refused.message());
    return kFailed;
  }
  const Evaluation evaluation(*flight);
  Output file("out/pyramid.txt");
  writeFrames(evaluation, {}, [&](std::string_view piece) { return file.write(piece); });
  if (!file.finish()) return kFailed;

  const std::string name = shellWord(shown(*sample));
  Output text;
  text.write(fmt::format(R"(Wrote out/pyramid.txt: {0} frames of the sample flight "{1}",
a line a frame: VRP, VPN, VUP, zoom.

Try also
  vides info {2}
  vides frames {2} --format csv
  vides frames {2} --format chan -o out/pyramid.chan
  vides check FLIGHT.vid
  vides --help
)",
                         evaluation.frameCount(), flight->name, name));
  return text.finish() ? kExitDone : kFailed;
}

}  // namespace vides
