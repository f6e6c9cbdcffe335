// SPDX-License-Identifier: MIT
// The frames of whole flights: against an independent evaluator's, and format against format.
#include "io/frame_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "io/vid_reader.hpp"
#include "support/files.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string framesOf(const Evaluation& evaluation, const FrameOptions& options) {
  std::string text;
  EXPECT_TRUE(writeFrames(evaluation, options, [&](std::string_view piece) {
    text += piece;
    return true;
  }));
  return text;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

Flight flightNamed(const std::string& name) {
  auto flight = readVidFile(std::string(VIDES_TEST_DATA) + "/flights/" + name + ".vid");
  if (!flight) throw std::runtime_error(name);
  return *flight;
}

std::string referenceOf(const std::string& name, const std::string& kind) {
  return test::readAll(fs::path(VIDES_TEST_DATA) / "flights" / (name + kind));
}

std::vector<std::string> flightNames() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(VIDES_TEST_DATA) / "flights")) {
    fs::path name = entry.path().filename();
    if (name.extension() != ".txt") continue;
    names.push_back(name.stem().stem().string());  // NAME.frames.txt
  }
  std::sort(names.begin(), names.end());
  return names;
}

FrameOptions as(const FrameFormat* format) {
  FrameOptions options;
  options.format = format;
  return options;
}

class ReferenceFlight : public testing::TestWithParam<std::string> {};

TEST_P(ReferenceFlight, TextIsTheReferencesExactly) {
  const Evaluation evaluation(flightNamed(GetParam()));
  EXPECT_EQ(framesOf(evaluation, {}), referenceOf(GetParam(), ".frames.txt"));
}

TEST_P(ReferenceFlight, CsvIsTheReferencesTo1e9) {
  const Evaluation evaluation(flightNamed(GetParam()));
  const auto ours = linesOf(framesOf(evaluation, as(frameFormat("csv"))));
  const auto theirs = linesOf(referenceOf(GetParam(), ".frames.csv"));
  ASSERT_EQ(ours.size(), theirs.size());
  ASSERT_EQ(ours[0], theirs[0]);
  for (std::size_t i = 1; i < ours.size(); ++i) {
    const auto mine = split(ours[i], ','), wanted = split(theirs[i], ',');
    ASSERT_EQ(mine.size(), 14u);
    ASSERT_EQ(wanted.size(), 14u);
    EXPECT_EQ(mine[3], wanted[3]) << ours[i];
    for (std::size_t k = 0; k < 14; ++k) {
      if (k == 3) continue;
      ASSERT_NEAR(std::stod(mine[k]), std::stod(wanted[k]), 1e-9) << ours[i];
    }
  }
}

TEST_P(ReferenceFlight, JsonHasTheNumbersOfTheCsv) {
  const Flight flight = flightNamed(GetParam());
  const Evaluation evaluation(flight);
  const auto rows = linesOf(framesOf(evaluation, as(frameFormat("csv"))));
  const std::string text = framesOf(evaluation, as(frameFormat("json")));
  const Json json = Json::parse(text);
  const Lens& lens = flight.lens;
  const double aspect = static_cast<double>(flight.picture.height) / flight.picture.width;
  ASSERT_EQ(json["frames"].size() + 1, rows.size());
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const auto row = split(rows[i + 1], ',');
    const Json& frame = json["frames"][i];
    ASSERT_EQ(frame["frame"].get<std::int64_t>(), std::stoll(row[0]));
    ASSERT_EQ(frame["time"].get<double>(), std::stod(row[1]));
    ASSERT_EQ(frame["section"].get<std::int64_t>(), std::stoll(row[2]));
    ASSERT_EQ(frame["kind"].get<std::string>(), row[3]);
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(frame["vrp"][k].get<double>(), std::stod(row[4 + k]));
      ASSERT_EQ(frame["vpn"][k].get<double>(), std::stod(row[7 + k]));
      ASSERT_EQ(frame["vup"][k].get<double>(), std::stod(row[10 + k]));
    }
    const double zoom = frame["zoom"].get<double>();
    ASSERT_EQ(zoom, std::stod(row[13]));
    const double focal =
        lens.focalLengthAtZoom1 +
        (zoom - 1.0) / 99.0 * (lens.focalLengthAtZoom100 - lens.focalLengthAtZoom1);
    const double fov = 2.0 * std::atan(lens.sensorWidth / 2.0 / focal * aspect);
    ASSERT_NEAR(frame["vertical_fov_deg"].get<double>(), fov * 180.0 / std::numbers::pi, 1e-10);
  }
}

// From the file's six decimals back to the camera: right, up and back by matrices made here.
TEST_P(ReferenceFlight, ChanGivesTheCamerasOfTheCsv) {
  Flight flight = flightNamed(GetParam());
  flight.space = {{1.0, -2.0, 3.0}, 5.0};
  const Evaluation evaluation(flight);
  const auto rows = linesOf(framesOf(evaluation, as(frameFormat("csv"))));
  const auto lines = linesOf(framesOf(evaluation, as(frameFormat("chan"))));
  ASSERT_EQ(lines.size() + 1, rows.size());
  std::vector<double> before;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<double> c, r;
    for (const std::string& part : split(lines[i], ' ')) {
      if (!c.empty()) {
        ASSERT_EQ(part.size() - part.find('.'), 7u) << lines[i];
      }
      c.push_back(std::stod(part));
    }
    for (const std::string& part : split(rows[i + 1], ',')) {
      r.push_back(r.size() == 3 ? 0.0 : std::stod(part));
    }
    ASSERT_EQ(c.size(), 8u);
    ASSERT_EQ(c[0], r[0] + 1.0);
    ASSERT_NEAR(c[1], 1.0 + 5.0 * r[4], 6e-7);
    ASSERT_NEAR(c[2], -2.0 + 5.0 * r[5], 6e-7);
    ASSERT_NEAR(c[3], 3.0 + 5.0 * r[6], 6e-7);
    const double x = c[4] * std::numbers::pi / 180.0, y = c[5] * std::numbers::pi / 180.0,
                 z = c[6] * std::numbers::pi / 180.0;
    // Columns of R_y R_x R_z, multiplied out.
    const double back[] = {std::sin(y) * std::cos(x), -std::sin(x), std::cos(y) * std::cos(x)};
    const double up[] = {-std::cos(y) * std::sin(z) + std::sin(y) * std::sin(x) * std::cos(z),
                         std::cos(x) * std::cos(z),
                         std::sin(y) * std::sin(z) + std::cos(y) * std::sin(x) * std::cos(z)};
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_NEAR(-back[k], r[7 + k], 2e-7) << rows[i + 1] << "\n" << lines[i];
      ASSERT_NEAR(up[k], r[10 + k], 2e-7) << rows[i + 1] << "\n" << lines[i];
    }
    for (std::size_t k = 4; k < 7 && i > 0; ++k) {
      ASSERT_LE(std::abs(c[k] - before[k]), 180.0) << lines[i];
    }
    before = c;
  }
}

TEST_P(ReferenceFlight, APartHasTheLinesOfTheWhole) {
  const Evaluation evaluation(flightNamed(GetParam()));
  const std::int64_t count = evaluation.frameCount();
  for (const FrameFormat* format :
       {frameFormat("vides"), frameFormat("csv"), frameFormat("chan")}) {
    const auto whole = linesOf(framesOf(evaluation, as(format)));
    const std::size_t head = format == frameFormat("csv") ? 1 : 0;
    FrameOptions options = as(format);
    options.first = count / 3;
    options.last = 2 * count / 3 + 1;
    const auto part = linesOf(framesOf(evaluation, options));
    ASSERT_EQ(part.size() - head, static_cast<std::size_t>(options.last - options.first));
    for (std::size_t i = head; i < part.size(); ++i) {
      ASSERT_EQ(part[i], whole[i + static_cast<std::size_t>(options.first)]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FrameWriter, ReferenceFlight, testing::ValuesIn(flightNames()),
                         [](const auto& flight) {
                           std::string name = flight.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(FrameWriter, AllReferenceFlightsAreTried) { EXPECT_GE(flightNames().size(), 24u); }

TEST(FrameWriter, JsonsHeadDescribesTheFlight) {
  Flight flight = flightNamed("two-keys");
  flight.frameRate = 23.976;
  flight.picture.width = 2048;
  flight.space = {{1.5, 0.0, -2.0}, 0.25};
  FrameOptions options = as(frameFormat("json"));
  options.last = 1;
  const std::string text = framesOf(Evaluation(flight), options);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "{\"format\":\"vides-frames\",\"version\":1,\"frame_rate\":23.976,"
            "\"picture\":{\"width\":2048,\"height\":1080},"
            "\"lens\":{\"sensor_width_mm\":36,\"focal_length_mm\":[12,210]},"
            "\"space\":{\"center\":[1.5,0,-2],\"half_size\":0.25},\"frames\":[");
  EXPECT_EQ(text.substr(text.size() - 4), "\n]}\n");
  EXPECT_EQ(Json::parse(text)["frames"].size(), 1u);
}

TEST(FrameWriter, RangesClip) {
  const Evaluation evaluation(flightNamed("two-keys"));
  const auto size = [&](std::int64_t first, std::int64_t last) {
    FrameOptions options;
    options.first = first;
    options.last = last;
    return linesOf(framesOf(evaluation, options)).size();
  };
  const auto all = static_cast<std::size_t>(evaluation.frameCount());
  EXPECT_EQ(size(0, 1), 1u);
  EXPECT_EQ(size(-5, 2), 2u);
  EXPECT_EQ(size(50, 1'000'000'000'000), all - 50);
  EXPECT_EQ(size(evaluation.frameCount(), evaluation.frameCount() + 1), 0u);
  FrameOptions nothing = as(frameFormat("json"));
  nothing.first = 1'000'000;
  EXPECT_TRUE(Json::parse(framesOf(evaluation, nothing))["frames"].empty());
}

TEST(FrameWriter, WorldMovesPositionsOnly) {
  Flight flight = flightNamed("tracking");
  flight.space = {{10.0, 20.0, 30.0}, 2.0};
  const Evaluation evaluation(flight);
  FrameOptions world = as(frameFormat("csv"));
  world.space = FrameSpace::kWorld;
  const auto cube = linesOf(framesOf(evaluation, as(frameFormat("csv"))));
  const auto moved = linesOf(framesOf(evaluation, world));
  ASSERT_EQ(cube.size(), moved.size());
  for (std::size_t i = 1; i < cube.size(); ++i) {
    const auto a = split(cube[i], ','), b = split(moved[i], ',');
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (k < 4 || k > 6) {
        ASSERT_EQ(a[k], b[k]);
      } else {
        ASSERT_NEAR(std::stod(b[k]), 10.0 * static_cast<double>(k - 3) + 2.0 * std::stod(a[k]),
                    1e-12);
      }
    }
  }
}

TEST(FrameWriter, ChanCountsFromTheGivenNumber) {
  const Evaluation evaluation(flightNamed("two-keys"));
  FrameOptions options = as(frameFormat("chan"));
  options.firstNumber = 1001;
  options.first = 10;
  options.last = 12;
  const auto lines = linesOf(framesOf(evaluation, options));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].substr(0, 5), "1011 ");
  EXPECT_EQ(lines[1].substr(0, 5), "1012 ");
}

TEST(FrameWriter, NoFormatWritesMinusZero) {
  Flight flight = newFlight();
  // Along the x axis at y = z = 0, looking along it: zeros of both signs appear on the way.
  Key a = flight.keys.front(), b = flight.keys.back();
  a.position = {-0.5, 0.0, 0.0};
  b.position = {0.5, -0.0, -0.0};
  a.orientations.front().aim = {-1.0, -1e-7, -1e-7};
  b.orientations.front().aim = {1.0, -1e-7, 1e-7};
  flight.keys.set(0, a);
  flight.keys.set(1, b);
  const Evaluation evaluation(flight);
  for (const FrameFormat* format : frameFormats()) {
    for (std::string text = framesOf(evaluation, as(format)); const char c : {' ', ',', '['}) {
      for (const char* zero : {"-0\n", "-0 ", "-0,", "-0]", "-0.0000 ", "-0.0000\n", "-0.000000"}) {
        EXPECT_EQ(text.find(c + std::string(zero)), std::string::npos);
      }
    }
  }
}

TEST(FrameWriter, StopsWhereTheSinkDoes) {
  Flight flight = flightNamed("pyramid-smooth");
  flight.rates.move = 10000;
  const Evaluation evaluation(flight);
  int pieces = 0;
  EXPECT_FALSE(writeFrames(evaluation, as(frameFormat("csv")),
                           [&](std::string_view) { return ++pieces < 3; }));
  EXPECT_EQ(pieces, 3);
}

TEST(FrameWriter, HandsOnPiecesAndReportsProgress) {
  Flight flight = flightNamed("pyramid-smooth");
  flight.rates.move = 10000;
  const Evaluation evaluation(flight);
  std::size_t largest = 0, pieces = 0;
  std::int64_t reported = -1;
  EXPECT_TRUE(writeFrames(
      evaluation, as(frameFormat("json")),
      [&](std::string_view piece) {
        largest = std::max(largest, piece.size());
        return ++pieces > 0;
      },
      [&](std::int64_t done, std::int64_t all) {
        EXPECT_GT(done, reported);
        EXPECT_EQ(all, evaluation.frameCount());
        reported = done;
        return true;
      }));
  EXPECT_GT(pieces, 100u);
  EXPECT_LT(largest, 100'000u);  // streamed, never all held
  EXPECT_GT(reported, evaluation.frameCount() / 2);
}

// Also before the first piece: a .chan is followed from frame 0 on.
TEST(FrameWriter, TheProgressCanStopIt) {
  const Evaluation evaluation(flightNamed("random-103"));
  FrameOptions options = as(frameFormat("chan"));
  options.first = evaluation.frameCount() - 1;
  int asked = 0;
  EXPECT_FALSE(writeFrames(
      evaluation, options, [](std::string_view) { return true; },
      [&](std::int64_t, std::int64_t) { return ++asked < 2; }));
  EXPECT_EQ(asked, 2);
}

TEST(FrameWriter, IsTheSameInGerman) {
  const Evaluation evaluation(flightNamed("random-103"));
  const auto all = [&] {
    std::string text;
    for (const FrameFormat* format : frameFormats()) {
      text += framesOf(evaluation, as(format));
    }
    return text;
  };
  const std::string before = all();
  setenv("LOCPATH", VIDES_TEST_LOCPATH, 1);
  ASSERT_NE(std::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr);
  EXPECT_STREQ(std::localeconv()->decimal_point, ",");
  const std::string german = all();
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(before, german);
}

}  // namespace
}  // namespace vides
