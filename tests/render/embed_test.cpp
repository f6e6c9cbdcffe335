// SPDX-License-Identifier: MIT
// Embedded files are the files, byte by byte.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "embedded.hpp"

namespace vides {
namespace {

std::string bytesOf(const std::string& name) {
  std::ifstream stream(VIDES_TEST_DATA "/embed/" + name, std::ios::binary);
  EXPECT_TRUE(stream.is_open());
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Embed, IsTheFile) {
  EXPECT_EQ(embedded::kEveryByteBin.size(), 520u);
  EXPECT_TRUE(embedded::kEveryByteBin == bytesOf("every_byte.bin"));
  EXPECT_EQ(embedded::kTwoLinesTxt, bytesOf("two-lines.txt"));
  EXPECT_EQ(embedded::kEmpty, "");
}

}  // namespace
}  // namespace vides
