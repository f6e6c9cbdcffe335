// SPDX-License-Identifier: MIT
// A picture as a value: pixels, PNG files, and comparison with a baseline. Knows no OpenGL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "render/failure.hpp"

namespace vides {

// RGBA8, plain sRGB bytes, straight alpha; row 0 is the top row. 0 × 0 is a picture, too.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  // width · height · 4 bytes

  Picture() = default;
  // All bytes 0; both sides ≥ 0 (asserted).
  Picture(int pictureWidth, int pictureHeight);

  // The four bytes of a pixel inside the picture (asserted); x to the right, y down.
  std::span<std::uint8_t, 4> pixel(int x, int y);
  std::span<const std::uint8_t, 4> pixel(int x, int y) const;

  bool operator==(const Picture&) const = default;
};

// The bytes of a PNG file. Error: an empty picture, or memory.
tl::expected<std::string, std::string> encodePng(const Picture& picture);

// Error: not a PNG (other formats are refused), damaged, or more than 2^28 pixels.
tl::expected<Picture, std::string> decodePng(std::span<const std::uint8_t> bytes);

// The file appears whole or not at all. The error names the file.
tl::expected<void, std::string> writePng(const Picture& picture, const std::filesystem::path& file);
tl::expected<Picture, std::string> readPng(const std::filesystem::path& file);

// How much two pictures may differ and still count as equal (7-quality, "Tests").
//
// The share alone is blind to what is small: a word of three letters is 0.01 % of a window. But its
// pixels lie together. So few may differ in any one square, wherever it lies. On one machine the
// drivers (OSMesa, EGL, GLX) and all runs agree in every pixel; where another processor rounds the
// other way, an edge moves by a pixel for a part of its length: 16 pixels of a square that it
// crosses, 32 where it is thick and both its sides move. A word has more: see the tests that paint
// each over.
struct PictureTolerance {
  double channel = 0.02;    // a pixel differs where a channel differs by more than this, of 1
  double share = 0.002;     // so many of the pixels may differ, of 1; EGL: kEglShare
  std::size_t square = 32;  // … and so many of any kSquareSide × kSquareSide
};
inline constexpr double kEglShare = 0.01;
inline constexpr int kSquareSide = 16;

struct PictureDifference {
  bool equal = false;
  bool sameSize = false;
  std::size_t pixels = 0;     // that differ by more than the tolerance
  std::size_t square = 0;     // the most of them in one square
  double share = 0.0;         // of all pixels, 0 … 1; 1 where the sizes differ
  int greatest = 0;           // largest difference in a channel, 0 … 255
  int left = 0, top = 0;      // the smallest rectangle that holds all differing pixels
  int right = 0, bottom = 0;  // (right and bottom lie one beyond it)
  std::string sentence;       // how many pixels differ and where, for a message
};

PictureDifference comparePictures(const Picture& actual, const Picture& baseline,
                                  const PictureTolerance& tolerance = {});

// The actual picture dimmed to grey, with every pixel that differs by more than the tolerance in
// red; as large as both together, what only one of them covers being red.
Picture differencePicture(const Picture& actual, const Picture& baseline,
                          const PictureTolerance& tolerance = {});

}  // namespace vides
