// SPDX-License-Identifier: MIT
// The JSON reader against another parser, and against texts made to hurt.
#include "io/json_reader.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"
#include "support/property.hpp"
#include "support/random_document.hpp"

namespace vides {
namespace {

using test::Random;

// "" if all of it is one JSON value, else where and what was expected.
std::string syntaxOf(std::string_view text) {
  JsonReader json(text);
  try {
    json.skip(nullptr);
    json.finish();
  } catch (const SyntaxError& error) {
    return std::to_string(error.offset) + ":" + std::to_string(static_cast<int>(error.expected));
  } catch (const TooDeep&) {
    return "deep";
  }
  return "";
}

// Changes, removes, doubles or swaps some bytes.
std::string damaged(Random& random, std::string text) {
  static constexpr std::string_view kBytes = "{}[]\",:\\/-+.eE0123456789tfnu \n\t\x01\x7f\xc3\xff";
  for (int n = static_cast<int>(random.bits() % 3); n >= 0 && !text.empty(); --n) {
    const std::size_t at = random.bits() % text.size();
    switch (random.bits() % 4) {
      case 0:
        text[at] = kBytes[random.bits() % kBytes.size()];
        break;
      case 1:
        text.erase(at, 1 + random.bits() % 3);
        break;
      case 2:
        text.insert(at, 1, kBytes[random.bits() % kBytes.size()]);
        break;
      default:
        text.resize(at);
    }
  }
  return text;
}

TEST(JsonReader, AcceptsWhatAnotherParserAccepts) {
  int right = 0;
  int wrong = 0;
  test::holdsFor(20'000, [&] {
    Random random(*test::seeds());
    std::string text = test::randomJson(random, 4);
    if (random.coin()) text = damaged(random, text);
    bool accepted = true;
    try {
      const nlohmann::json parsed = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error&) {
      accepted = false;
    } catch (const nlohmann::json::out_of_range&) {
      return;  // a number beyond double: that parser goes no further
    }
    RC_LOG() << text << "\n" << syntaxOf(text) << "\n";
    ++(accepted ? right : wrong);
    RC_ASSERT((syntaxOf(text) == "") == accepted);
  });
  EXPECT_GT(right, 2000);
  EXPECT_GT(wrong, 2000);
}

TEST(JsonReader, StringsAreDecodedAsAnotherParserDoes) {
  test::holdsFor(5000, [] {
    Random random(*test::seeds());
    std::string text;
    appendJsonString(text, test::randomText(random, 20));
    if (random.coin()) text = nlohmann::json::parse(text).dump(-1, ' ', true);  // all escaped
    JsonReader json(text);
    RC_ASSERT(json.kind() == JsonReader::Kind::kString);
    RC_ASSERT(json.string() == nlohmann::json::parse(text).get<std::string>());
  });
}

TEST(JsonReader, NumbersAreTheNearestDoubles) {
  test::holdsFor(20'000, [] {
    Random random(*test::seeds());
    std::string text = random.coin() ? "-" : "";
    text += std::to_string(random.bits() >> random.bits() % 64);
    if (random.coin()) text += "." + std::to_string(random.bits() >> random.bits() % 64);
    if (random.coin()) text += "e" + std::to_string(static_cast<int>(random.bits() % 700) - 350);
    JsonReader json(text);
    RC_ASSERT(json.kind() == JsonReader::Kind::kNumber);
    const JsonNumber number = json.number();
    RC_ASSERT(number.text == text);
    RC_ASSERT(number.value == std::strtod(text.c_str(), nullptr));
    RC_ASSERT(number.tooLarge == std::isinf(number.value));
    RC_ASSERT(number.value != 0.0 || !std::signbit(number.value));
  });
}

TEST(JsonReader, NumbersWithManyDigits) {
  const std::string nines(100'000, '9');
  for (const auto& [text, value] :
       {std::pair{"0." + nines, 1.0}, std::pair{"0." + std::string(100'000, '0') + "1", 0.0},
        std::pair{nines + "e-100000", 1.0}, std::pair{"1e-" + nines, 0.0},
        std::pair{"0e" + nines, 0.0}, std::pair{"0." + std::string(400, '0') + "1e401", 1.0},
        std::pair{nines, std::numeric_limits<double>::infinity()},
        std::pair{"-1e" + nines, -std::numeric_limits<double>::infinity()}}) {
    JsonReader json(text);
    EXPECT_EQ(json.number().value, value) << text.substr(0, 20);
  }
}

TEST(JsonReader, PlacesCountLinesAndCharacters) {
  const std::string text = "\xEF\xBB\xBF{\r\n\tä🛩x\n";
  const auto place = [&](std::size_t offset) {
    const TextPlace p = placeInText(text, offset);
    return std::to_string(p.line) + ":" + std::to_string(p.column);
  };
  EXPECT_EQ(place(3), "1:1");
  EXPECT_EQ(place(4), "1:2");
  EXPECT_EQ(place(6), "2:1");
  EXPECT_EQ(place(7), "2:2");
  EXPECT_EQ(place(9), "2:3");
  EXPECT_EQ(place(13), "2:4");
  EXPECT_EQ(place(text.size()), "3:1");
}

// How much more memory this process has ever needed, after `body`.
template <class Body>
std::size_t peakGrowth(Body body) {
  const auto peak = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  };
  const std::size_t before = peak();
  body();
  return peak() - before;
}

std::string repeated(std::string_view piece, std::size_t bytes) {
  std::string text;
  text.reserve(bytes + piece.size());
  while (text.size() < bytes) text += piece;
  return text;
}

// Files made to need much more than they are large. Peaks only grow: the text itself is made first.
class HostileText : public testing::TestWithParam<std::pair<const char*, std::string (*)()>> {};

constexpr std::size_t kBytes = 8'000'000;
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kQuarantine = 512'000'000;  // freed memory is kept back for a while
#else
constexpr std::size_t kQuarantine = 0;
#endif
const std::string kHead = R"({"format":"vides","version":1,)";

std::string names(const std::string& prefix) {
  std::string text = kHead;
  for (std::size_t i = 0; text.size() < kBytes; ++i) {
    text += "\"" + prefix + std::to_string(i) + "\":0,";
  }
  return text + "\"keys\":[]}";
}

const std::pair<const char*, std::string (*)()> kHostile[] = {
    {"open_brackets", [] { return repeated("[", kBytes); }},
    {"wrong_keys", [] { return kHead + "\"keys\":[" + repeated("7,", kBytes) + "7]}"; }},
    {"empty_keys", [] { return kHead + "\"keys\":[" + repeated("{},", kBytes) + "{}]}"; }},
    {"many_speeds",
     [] {
       return kHead + R"("keys":[{"position":[0,0,0],"orientations":[{"aim":[0,0,1],"speed":[)" +
              repeated("50,", kBytes) + "50]}]}]}";
     }},
    {"many_orientations",
     [] {
       return kHead + R"("keys":[{"position":[0,0,0],"orientations":[)" +
              repeated(R"({"aim":[0,0,1]},)", kBytes) + R"({"aim":[0,0,1]}]}]})";
     }},
    {"unknown_members", [] { return names("u"); }},
    {"kept_members", [] { return names("x_"); }},
    {"kept_members_inside",
     [] {
       std::string text = names("n");
       text.insert(kHead.size(), "\"x_\":{");
       return text.substr(0, text.size() - 11) + "\"z\":0},\"keys\":[]}";
     }},
    {"the_same_member", [] { return kHead + repeated("\"closed\":0,", kBytes) + "\"keys\":[]}"; }},
    {"one_long_name", [] { return kHead + "\"" + repeated("n", kBytes) + "\":0}"; }},
    {"one_long_string", [] { return kHead + "\"name\":\"" + repeated("\\u00fc", kBytes) + "\"}"; }},
    {"one_long_number", [] { return kHead + "\"frame_rate\":" + repeated("9", kBytes) + "}"; }},
    {"escaped_names",
     [] {
       return kHead + "\"x_\":[" + repeated("{\"\\u0061\":0,\"\\u0062\":0},", kBytes) +
              "0],\"keys\":[]}";
     }},
};

TEST_P(HostileText, NeedsMemoryAndTimeInProportion) {
  const std::string text = GetParam().second();
  timespec start{};
  timespec end{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &start);
  const std::size_t memory = peakGrowth([&] {
    const ReadFlight flight = readVid(text);
    EXPECT_FALSE(flight.has_value());
    EXPECT_LE(flight.error().size(), kMostProblems);
  });
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &end);
  EXPECT_LT(memory, 16 * text.size() + kQuarantine);
  // No figure of speed, but quadratic time would be hours.
  EXPECT_LT(end.tv_sec - start.tv_sec, 60);
}

std::string hostileName(const testing::TestParamInfo<HostileText::ParamType>& text) {
  return text.param.first;
}
INSTANTIATE_TEST_SUITE_P(Texts, HostileText, testing::ValuesIn(kHostile), hostileName);

}  // namespace
}  // namespace vides
