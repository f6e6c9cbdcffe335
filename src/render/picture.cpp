// SPDX-License-Identifier: MIT
// Pictures: comparison with a baseline.
#include "render/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <vector>

namespace vides {
namespace {

std::size_t offsetOf(const Picture& picture, int x, int y) {
  assert(x >= 0 && y >= 0 && x < picture.width && y < picture.height);
  return (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
          static_cast<std::size_t>(x)) *
         4;
}

bool covers(const Picture& picture, int x, int y) {
  return x < picture.width && y < picture.height;
}

// Largest difference over the four channels, 0 … 255.
int channelDifference(std::span<const std::uint8_t, 4> a, std::span<const std::uint8_t, 4> b) {
  int greatest = 0;
  for (std::size_t i = 0; i < 4; ++i) greatest = std::max(greatest, std::abs(a[i] - b[i]));
  return greatest;
}

// How many pixels differ in rectangles, told in constant time: sums over all that lies above and to
// the left.
class DifferenceSums {
 public:
  DifferenceSums(int width, int height)
      : width_(width),
        height_(height),
        sums_(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1)) {}

  // Row by row, each from the left.
  void add(int x, int y, bool differs) {
    sums_[at(x + 1, y + 1)] = sums_[at(x, y + 1)] + sums_[at(x + 1, y)] - sums_[at(x, y)] +
                              static_cast<std::uint32_t>(differs);
  }

  // The most in a square of the picture.
  std::size_t densest() const {
    const int across = std::min(kSquareSide, width_), down = std::min(kSquareSide, height_);
    std::uint32_t most = 0;
    for (int y = down; y <= height_; ++y) {
      for (int x = across; x <= width_; ++x) {
        most = std::max(most, sums_[at(x, y)] - sums_[at(x - across, y)] - sums_[at(x, y - down)] +
                                  sums_[at(x - across, y - down)]);
      }
    }
    return most;
  }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1) +
           static_cast<std::size_t>(x);
  }

  int width_, height_;
  std::vector<std::uint32_t> sums_;
};

}  // namespace

Picture::Picture(int pictureWidth, int pictureHeight)
    : width(pictureWidth),
      height(pictureHeight),
      rgba(static_cast<std::size_t>(pictureWidth) * static_cast<std::size_t>(pictureHeight) * 4) {
  assert(pictureWidth >= 0 && pictureHeight >= 0);
}

std::span<std::uint8_t, 4> Picture::pixel(int x, int y) {
  return std::span<std::uint8_t, 4>(rgba.data() + offsetOf(*this, x, y), 4);
}

std::span<const std::uint8_t, 4> Picture::pixel(int x, int y) const {
  return std::span<const std::uint8_t, 4>(rgba.data() + offsetOf(*this, x, y), 4);
}

PictureDifference comparePictures(const Picture& actual, const Picture& baseline,
                                  const PictureTolerance& tolerance) {
  PictureDifference result;
  result.sameSize = actual.width == baseline.width && actual.height == baseline.height;
  if (!result.sameSize) {
    result.share = 1.0;
    result.greatest = 255;
    result.right = std::max(actual.width, baseline.width);
    result.bottom = std::max(actual.height, baseline.height);
    result.sentence = fmt::format("the picture is {} × {} pixels, the baseline {} × {}",
                                  actual.width, actual.height, baseline.width, baseline.height);
    return result;
  }
  const double limit = tolerance.channel * 255.0;
  DifferenceSums sums(actual.width, actual.height);
  result.left = actual.width;
  result.top = actual.height;
  for (int y = 0; y < actual.height; ++y) {
    for (int x = 0; x < actual.width; ++x) {
      const int difference = channelDifference(actual.pixel(x, y), baseline.pixel(x, y));
      result.greatest = std::max(result.greatest, difference);
      const bool differs = difference > limit;
      sums.add(x, y, differs);
      if (!differs) continue;
      ++result.pixels;
      result.left = std::min(result.left, x);
      result.top = std::min(result.top, y);
      result.right = std::max(result.right, x + 1);
      result.bottom = std::max(result.bottom, y + 1);
    }
  }
  const std::size_t all = actual.rgba.size() / 4;
  result.share = all == 0 ? 0.0 : static_cast<double>(result.pixels) / static_cast<double>(all);
  result.square = result.pixels == 0 ? 0 : sums.densest();
  result.equal = result.share <= tolerance.share && result.square <= tolerance.square;
  if (result.pixels == 0) {
    result.left = result.top = 0;
    result.sentence = fmt::format("no pixel differs by more than {} %", tolerance.channel * 100);
  } else {
    result.sentence = fmt::format(
        "{} of {} pixels ({:.3f} %, allowed {} %) differ by more than {} %, by up to {:.1f} %, "
        "{} of them (allowed {}) in one square of {} x {}, within x {} to {}, y {} to {}",
        result.pixels, all, result.share * 100, tolerance.share * 100, tolerance.channel * 100,
        result.greatest / 2.55, result.square, tolerance.square, kSquareSide, kSquareSide,
        result.left, result.right - 1, result.top, result.bottom - 1);
  }
  return result;
}

Picture differencePicture(const Picture& actual, const Picture& baseline,
                          const PictureTolerance& tolerance) {
  const double limit = tolerance.channel * 255.0;
  Picture result(std::max(actual.width, baseline.width), std::max(actual.height, baseline.height));
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const auto out = result.pixel(x, y);
      out[3] = 255;
      if (!covers(actual, x, y) || !covers(baseline, x, y) ||
          channelDifference(actual.pixel(x, y), baseline.pixel(x, y)) > limit) {
        out[0] = 255;
        continue;
      }
      const auto in = actual.pixel(x, y);
      const auto grey = static_cast<std::uint8_t>((in[0] * 2 + in[1] * 5 + in[2]) / 24);
      out[0] = out[1] = out[2] = grey;
    }
  }
  return result;
}

}  // namespace vides
