// SPDX-License-Identifier: MIT
// Pictures as PNG files, through stb.
#include <fcntl.h>
#include <fmt/format.h>
#include <stb_image.h>
#include <stb_image_write.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <string_view>

#include "render/picture.hpp"

namespace vides {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;

void append(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                             static_cast<std::size_t>(size));
}

std::string failure(const std::filesystem::path& file, int error) {
  const char* reason = strerrordesc_np(error);  // never translated, and safe in threads
  return fmt::format("{}: {}", file.string(), reason != nullptr ? reason : "unknown error");
}

// 0, or the error's number.
int writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return fsync(descriptor) == 0 ? 0 : errno;
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
  const auto size = static_cast<int>(std::min<std::size_t>(bytes.size(), 0x7fffffff));
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  if (!text.starts_with(kPngSignature) ||
      stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0) {
    return Failure("not a PNG file");
  }
  // Asked before the pixels are decoded: a few bytes can claim any size.
  if (std::int64_t{width} * height > kMaxPixels) {
    return Failure(fmt::format("{} × {} pixels are too many", width, height));
  }
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
  // Written beside the file, then renamed over it: whole or not at all.
  const std::string temporary = fmt::format("{}.{}.tmp", file.string(), getpid());
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return Failure(failure(file, errno));
  int error = writeAll(descriptor, *bytes);
  if (close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), file.c_str()) != 0) error = errno;
  if (error == 0) return {};
  unlink(temporary.c_str());
  return Failure(failure(file, error));
}

tl::expected<Picture, std::string> readPng(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return Failure(failure(file, errno));
  const std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(stream)), {});
  auto picture = decodePng(bytes);
  if (!picture) return Failure(fmt::format("{}: {}", file.string(), picture.error()));
  return picture;
}

}  // namespace vides
