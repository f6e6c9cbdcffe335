// SPDX-License-Identifier: MIT
// A picture's size as it is typed.
#include "app/picture_size.hpp"

#include <charconv>

namespace vides {
namespace {

std::optional<int> side(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || value < 1 || value > kMostPixels) return std::nullopt;
  return value;
}

}  // namespace

std::optional<TypedSize> parsePictureSize(std::string_view text) {
  const std::size_t cross = text.find_first_of("xX");
  const auto width = side(text.substr(0, cross));
  if (!width) return std::nullopt;
  if (cross == std::string_view::npos) return TypedSize{*width, std::nullopt};
  const auto height = side(text.substr(cross + 1));
  return height ? std::optional(TypedSize{*width, height}) : std::nullopt;
}

}  // namespace vides
