// SPDX-License-Identifier: MIT
// Pictures: PNG files there and back, refusals, and a comparison that sees what it must.
#include "render/picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace vides {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

Picture grey(int width, int height, std::uint8_t value = 100) {
  Picture picture(width, height);
  std::fill(picture.rgba.begin(), picture.rgba.end(), value);
  return picture;
}

// A folder of its own that goes when the test ends.
class Folder {
 public:
  Folder() {
    std::string name = testing::TempDir() + "vides-XXXXXX";
    path_ = mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    fs::permissions(path_, fs::perms::owner_all);
    fs::remove_all(path_);
  }
  fs::path operator/(const char* name) const { return path_ / name; }
  const fs::path& path() const { return path_; }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(path_)) {
      result.push_back(entry.path().filename().string());
    }
    return result;
  }

 private:
  fs::path path_;
};

RC_GTEST_PROP(Png, ThereAndBack, ()) {
  const int width = *rc::gen::inRange(1, 40);
  const int height = *rc::gen::inRange(1, 40);
  Picture picture(width, height);
  picture.rgba = *rc::gen::container<std::vector<std::uint8_t>>(picture.rgba.size(),
                                                                rc::gen::arbitrary<std::uint8_t>());
  const auto bytes = encodePng(picture);
  RC_ASSERT(bytes.has_value());
  const auto back = decodePng(bytesOf(*bytes));
  RC_ASSERT(back.has_value());
  RC_ASSERT(*back == picture);
}

// Written by a few lines of Python, with a palette: red, green / blue half seen, white.
TEST(Png, ReadsAnothersFile) {
  const auto picture = readPng(fs::path(VIDES_TEST_DATA) / "four_pixels.png");
  ASSERT_TRUE(picture) << picture.error();
  ASSERT_EQ(picture->width, 2);
  ASSERT_EQ(picture->height, 2);
  EXPECT_THAT(picture->pixel(0, 0), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(picture->pixel(1, 0), ElementsAre(0, 255, 0, 255));
  EXPECT_THAT(picture->pixel(0, 1), ElementsAre(0, 0, 255, 128));
  EXPECT_THAT(picture->pixel(1, 1), ElementsAre(255, 255, 255, 255));
}

TEST(Png, RefusesWhatIsNone) {
  EXPECT_EQ(decodePng({}).error(), "not a PNG file");
  EXPECT_EQ(decodePng(bytesOf("GIF89a")).error(), "not a PNG file");
  EXPECT_THAT(readPng("/nowhere/a.png").error(),
              AllOf(HasSubstr("/nowhere/a.png"), HasSubstr("No such file")));
  EXPECT_FALSE(encodePng(Picture()));
}

TEST(Png, SurvivesDamage) {
  const std::string whole = encodePng(grey(20, 10)).value();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    decodePng(bytesOf(whole.substr(0, length)));  // may fail, must not crash
  }
  int refused = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const int flip : {1, 0x80, 0xFF}) {
      std::string damaged = whole;
      damaged[i] = static_cast<char>(damaged[i] ^ flip);
      if (!decodePng(bytesOf(damaged))) ++refused;
    }
  }
  EXPECT_GT(refused, 40);
}

// Bytes 16 to 23 are the size: 60,000 × 60,000 pixels claimed by 80 bytes.
TEST(Png, RefusesMoreThanItCanHold) {
  std::string bytes = encodePng(grey(2, 2)).value();
  for (const std::size_t place : {std::size_t{18}, std::size_t{22}}) {
    bytes[place] = static_cast<char>(0xEA);
    bytes[place + 1] = static_cast<char>(0x60);
  }
  EXPECT_THAT(decodePng(bytesOf(bytes)).error(), HasSubstr("60000 × 60000 pixels are too many"));
}

TEST(Png, WritesWholeOrNotAtAll) {
  const Folder folder;
  const fs::path file = folder / "a.png";
  ASSERT_TRUE(writePng(grey(3, 2), file));
  EXPECT_EQ(readPng(file).value(), grey(3, 2));
  ASSERT_TRUE(writePng(grey(5, 5), file));  // over the old one
  EXPECT_EQ(readPng(file).value(), grey(5, 5));
  EXPECT_FALSE(writePng(Picture(), file));
  EXPECT_EQ(readPng(file).value(), grey(5, 5));
  EXPECT_THAT(folder.names(), ElementsAre("a.png"));

  fs::create_directory(folder / "taken.png");
  EXPECT_THAT(writePng(grey(3, 2), folder / "taken.png").error(), HasSubstr("taken.png"));
  EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("a.png", "taken.png"));
  EXPECT_THAT(writePng(grey(3, 2), folder / "none/a.png").error(), HasSubstr("No such file"));
}

TEST(ComparePictures, EqualOnes) {
  const PictureDifference same = comparePictures(grey(10, 10), grey(10, 10));
  EXPECT_TRUE(same.equal);
  EXPECT_EQ(same.pixels, 0u);
  EXPECT_EQ(same.greatest, 0);
  EXPECT_TRUE(comparePictures(Picture(), Picture()).equal);
}

// 2 % of 255 is 5.1: a difference of 5 is none, one of 6 is.
TEST(ComparePictures, ChannelLimit) {
  for (std::size_t channel = 0; channel < 4; ++channel) {
    Picture other = grey(10, 10);
    other.pixel(3, 7)[channel] = 105;
    EXPECT_EQ(comparePictures(other, grey(10, 10)).pixels, 0u);
    other.pixel(3, 7)[channel] = 94;
    const PictureDifference one = comparePictures(other, grey(10, 10));
    EXPECT_EQ(one.pixels, 1u);
    EXPECT_EQ(one.greatest, 6);
    EXPECT_THAT((std::vector{one.left, one.top, one.right, one.bottom}), ElementsAre(3, 7, 4, 8));
  }
}

// 0.2 % of 1,000 pixels are 2.
TEST(ComparePictures, ShareLimit) {
  Picture other = grey(100, 10);
  other.pixel(0, 0)[0] = 0;
  other.pixel(99, 9)[0] = 0;
  EXPECT_TRUE(comparePictures(other, grey(100, 10)).equal);
  other.pixel(50, 5)[0] = 0;
  const PictureDifference three = comparePictures(other, grey(100, 10));
  EXPECT_FALSE(three.equal);
  EXPECT_DOUBLE_EQ(three.share, 0.003);
  EXPECT_THAT(three.sentence,
              AllOf(HasSubstr("3 of 1000 pixels"), HasSubstr("x 0 to 99, y 0 to 9")));
  EXPECT_TRUE(comparePictures(other, grey(100, 10), {.share = kEglShare}).equal);
}

// In a square of 16 x 16, wherever it lies, 32 pixels may differ: as many apart are nothing.
TEST(ComparePictures, SquareLimit) {
  const PictureTolerance tolerance{.share = 1.0};
  for (const int left : {0, 5, 9, 84}) {
    Picture other = grey(100, 40);
    for (int i = 0; i < 32; ++i) other.pixel(left + i % 16, 7 + 15 * (i / 16))[0] = 0;
    const PictureDifference enough = comparePictures(other, grey(100, 40), tolerance);
    EXPECT_TRUE(enough.equal) << enough.sentence;
    EXPECT_EQ(enough.square, 32u);
    other.pixel(left, 12)[0] = 0;
    const PictureDifference more = comparePictures(other, grey(100, 40), tolerance);
    EXPECT_FALSE(more.equal) << left;
    EXPECT_THAT(more.sentence, HasSubstr("33 of them (allowed 32) in one square of 16 x 16"));
  }
  Picture apart = grey(200, 200);
  for (int i = 0; i < 144; ++i) apart.pixel(16 * (i % 12), 16 * (i / 12))[0] = 0;
  EXPECT_EQ(comparePictures(apart, grey(200, 200), tolerance).square, 1u);
  // Pictures smaller than a square.
  EXPECT_EQ(comparePictures(grey(3, 2, 0), grey(3, 2), tolerance).square, 6u);
}

TEST(ComparePictures, OtherSize) {
  const PictureDifference difference = comparePictures(grey(10, 10), grey(10, 11));
  EXPECT_FALSE(difference.equal);
  EXPECT_THAT(difference.sentence, AllOf(HasSubstr("10 × 10"), HasSubstr("10 × 11")));
  EXPECT_FALSE(comparePictures(grey(1, 1), Picture(), {.share = 1.0}).equal);
}

TEST(DifferencePicture, IsRedWhereItDiffers) {
  Picture other = grey(4, 3);
  other.pixel(2, 1)[1] = 0;
  const Picture difference = differencePicture(other, grey(4, 3));
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      const auto pixel = difference.pixel(x, y);
      const bool red = pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 0;
      EXPECT_EQ(red, x == 2 && y == 1);
      EXPECT_EQ(pixel[3], 255);
    }
  }
  const Picture sizes = differencePicture(grey(2, 5), grey(4, 3));
  EXPECT_EQ(sizes.width, 4);
  EXPECT_EQ(sizes.height, 5);
  EXPECT_THAT(sizes.pixel(3, 0), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(sizes.pixel(0, 4), ElementsAre(255, 0, 0, 255));
  EXPECT_NE(sizes.pixel(0, 0)[0], 255);
}

}  // namespace
}  // namespace vides
