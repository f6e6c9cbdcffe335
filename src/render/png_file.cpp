// SPDX-License-Identifier: MIT
// Pictures as PNG files, through stb.
#include <fmt/format.h>
#include <stb_image.h>
#include <stb_image_write.h>

#include <cstring>
#include <memory>
#include <string_view>

#include "io/atomic_file.hpp"
#include "io/problem_text.hpp"
#include "io/read_file.hpp"
#include "render/picture.hpp"

namespace vides {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

void append(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                             static_cast<std::size_t>(size));
}

std::int64_t bigEndian(std::span<const std::uint8_t, 4> bytes) {
  return std::int64_t{bytes[0]} << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
}

}  // namespace

tl::expected<std::string, std::string> encodePng(const Picture& picture) {
  if (picture.width < 1 || picture.height < 1) {
    return Failure("a PNG file needs at least one pixel");
  }
  std::string bytes;
  const int written = stbi_write_png_to_func(&append, &bytes, picture.width, picture.height, 4,
                                             picture.rgba.data(), picture.width * 4);
  if (written == 0) return Failure("the picture could not be encoded: not enough memory");
  return bytes;
}

tl::expected<Picture, std::string> decodePng(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (!text.starts_with(kPngSignature)) return Failure("not a PNG file");
  // The header chunk stands first. Asked before stb decodes: a few bytes can claim any size.
  constexpr std::size_t kHeaderEnd = 24;
  if (bytes.size() < kHeaderEnd || text.substr(12, 4) != "IHDR") {
    return Failure("a damaged PNG file");
  }
  const std::int64_t claimedWidth = bigEndian(bytes.subspan<16, 4>());
  const std::int64_t claimedHeight = bigEndian(bytes.subspan<20, 4>());
  if (claimedHeight != 0 && claimedWidth > kMaxPixels / claimedHeight) {
    return Failure(fmt::format("{} × {} pixels are too many", claimedWidth, claimedHeight));
  }
  if (bytes.size() > kMaxFileBytes) return Failure("too large a PNG file");
  const auto size = static_cast<int>(bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), &stbi_image_free);
  if (!pixels) return Failure(fmt::format("a damaged PNG file: {}", stbi_failure_reason()));
  Picture picture(width, height);
  std::memcpy(picture.rgba.data(), pixels.get(), picture.rgba.size());
  return picture;
}

tl::expected<void, std::string> writePng(const Picture& picture,
                                         const std::filesystem::path& file) {
  const auto bytes = encodePng(picture);
  if (!bytes) return Failure(fmt::format("{}: {}", file.string(), bytes.error()));
  AtomicFile output(file.string());
  output.write(*bytes);
  if (const auto done = output.commit(); !done) {
    return Failure(fmt::format("{}: {}", file.string(), done.error().reason()));
  }
  return {};
}

tl::expected<Picture, std::string> readPng(const std::filesystem::path& file) {
  const auto bytes = readFile(file.string(), kMaxFileBytes);
  if (!bytes) return Failure(problemLine(file.string(), bytes.error()));
  auto picture = decodePng({reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()});
  if (!picture) return Failure(fmt::format("{}: {}", file.string(), picture.error()));
  return picture;
}

}  // namespace vides
