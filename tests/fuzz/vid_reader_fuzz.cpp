// SPDX-License-Identifier: MIT
// Any bytes as a `.vid` file: refused with problems that can be told, or read, and then what was
// read is valid and is written and read back as it is.
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "flight/utf8.hpp"
#include "flight/validation.hpp"
#include "io/problem_text.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"

namespace {

void require(bool condition, std::string_view what) {
  if (condition) return;
  fmt::print(stderr, "{}\n", what);
  std::abort();
}

void checkProblems(std::string_view text, const std::vector<vides::Problem>& problems) {
  require(!problems.empty() && problems.size() <= vides::kMostProblems, "1 to 20 problems");
  for (const vides::Problem& problem : problems) {
    const std::string line = vides::problemLine("f", problem);
    require(line.size() > 4 && line.size() < 10'000, "a problem in words");
    require(line.find('\n') == line.npos && vides::codePoints(line).has_value(),
            "a problem on one line of UTF-8");
    // nlohmann-json takes a NUL for the end of the text.
    if (problem.code == vides::ProblemCode::kSyntax && text.find('\0') == text.npos) {
      require(!nlohmann::json::accept(text), "what isn't JSON isn't JSON for another parser");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const vides::ReadFlight flight = vides::readVid(text);
  if (!flight) {
    checkProblems(text, flight.error());
    return 0;
  }
  // Another parser must not find it wrong.
  require(nlohmann::json::accept(text), "what is read is JSON");
  require(vides::validate(*flight).empty(), "what is read is valid");
  const std::string written = vides::writeVid(*flight);
  const vides::ReadFlight again = vides::readVid(written);
  require(again.has_value(), "what is written can be read");
  require(*again == *flight, "what is written is what was read");
  require(vides::writeVid(*again) == written, "and is written the same again");
  return 0;
}
