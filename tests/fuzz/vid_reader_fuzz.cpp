// SPDX-License-Identifier: MIT
// Any bytes as a `.vid` file: refused with problems that can be told, or read, and then what was
// read is valid and is written and read back as it is.
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "flight/utf8.hpp"
#include "flight/validation.hpp"
#include "fuzz/require.hpp"
#include "io/problem_text.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"

namespace {

using vides::test::require;

// What another parser says; nothing where it stops at what is no question of syntax: it takes a NUL
// for the end of the text, and goes no further at a number beyond double.
std::optional<bool> isJson(std::string_view text) {
  if (text.find('\0') != text.npos) return std::nullopt;
  if (nlohmann::json::accept(text)) return true;
  try {
    const nlohmann::json parsed = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error&) {
    return false;
  } catch (const nlohmann::json::out_of_range&) {
    return std::nullopt;
  }
  return true;
}

void checkProblems(std::string_view text, const std::vector<vides::Problem>& problems) {
  require(!problems.empty() && problems.size() <= vides::kMostProblems, "1 to 20 problems");
  for (const vides::Problem& problem : problems) {
    const std::string line = vides::problemLine("f", problem);
    require(line.size() > 4 && line.size() < 10'000, "a problem in words");
    require(line.find('\n') == line.npos && vides::codePoints(line).has_value(),
            "a problem on one line of UTF-8");
    if (problem.code == vides::ProblemCode::kSyntax) {
      require(isJson(text) != true, "what isn't JSON isn't JSON for another parser");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = vides::test::asText(data, size);
  const vides::ReadFlight flight = vides::readVid(text);
  if (!flight) {
    checkProblems(text, flight.error());
    return 0;
  }
  require(isJson(text) != false, "what is read is JSON for another parser");
  require(vides::validate(*flight).empty(), "what is read is valid");
  const std::string written = vides::writeVid(*flight);
  const vides::ReadFlight again = vides::readVid(written);
  require(again.has_value(), "what is written can be read");
  require(*again == *flight, "what is written is what was read");
  require(vides::writeVid(*again) == written, "and is written the same again");
  return 0;
}
