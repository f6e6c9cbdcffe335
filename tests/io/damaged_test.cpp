// SPDX-License-Identifier: MIT
// Damaged `.vid` files: tests/data/damaged/expected.txt has, in the order in which they are told,
// the problems of every file in that folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "io/problem_text.hpp"
#include "io/vid_reader.hpp"
#include "support/files.hpp"

namespace vides {
namespace {

const std::filesystem::path kFolder = VIDES_TEST_DATA "/damaged";

std::vector<std::string> damagedFiles() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".vid") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The lines of expected.txt that begin with the file's name.
std::string expectedLines(const std::string& file) {
  std::istringstream lines(test::readAll(kFolder / "expected.txt"));
  std::string expected;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(file + ":")) expected += line + "\n";
  }
  return expected;
}

class DamagedFile : public testing::TestWithParam<std::string> {};

TEST_P(DamagedFile, IsRefusedWithPlaceAndReason) {
  const std::string name = GetParam() + ".vid";
  const ReadFlight flight = readVidFile((kFolder / name).string());
  ASSERT_FALSE(flight.has_value());
  std::string told;
  for (const Problem& problem : flight.error()) told += problemLine(name, problem) + "\n";
  EXPECT_EQ(told, expectedLines(name));
}

std::string testName(const testing::TestParamInfo<std::string>& file) {
  std::string name = file.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, DamagedFile, testing::ValuesIn(damagedFiles()), testName);

TEST(DamagedFiles, AreManyAndEachIsExpected) {
  EXPECT_GE(damagedFiles().size(), 60U);
  std::map<std::string, int> lines;
  std::istringstream expected(test::readAll(kFolder / "expected.txt"));
  for (std::string line; std::getline(expected, line);) ++lines[line.substr(0, line.find(".vid"))];
  for (const std::string& name : damagedFiles()) EXPECT_GE(lines[name], 1) << name;
  EXPECT_EQ(lines.size(), damagedFiles().size());
}

}  // namespace
}  // namespace vides
