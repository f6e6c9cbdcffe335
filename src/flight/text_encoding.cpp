// SPDX-License-Identifier: MIT
// Tells encodings apart and reads UTF-16.
#include "flight/text_encoding.hpp"

#include <cstddef>

namespace vides {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view kLittleMark = "\xFF\xFE", kBigMark = "\xFE\xFF";
constexpr std::string_view kUtf32LittleMark("\xFF\xFE\0\0", 4), kUtf32BigMark("\0\0\xFE\xFF", 4);

void appendUtf8(std::string& out, unsigned code) {
  const auto add = [&](unsigned byte) { out.push_back(static_cast<char>(byte)); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xC0 | code >> 6);
  } else {
    if (code < 0x10000) {
      add(0xE0 | code >> 12);
    } else {
      add(0xF0 | code >> 18);
      add(0x80 | (code >> 12 & 0x3F));
    }
    add(0x80 | (code >> 6 & 0x3F));
  }
  add(0x80 | (code & 0x3F));
}

}  // namespace

TextEncoding encodingOf(std::string_view text) {
  if (text.starts_with(kUtf32LittleMark) || text.starts_with(kUtf32BigMark)) {
    return TextEncoding::kUtf32;
  }
  if (text.starts_with(kLittleMark)) return TextEncoding::kUtf16Little;
  if (text.starts_with(kBigMark)) return TextEncoding::kUtf16Big;
  if (text.size() >= 4) {
    const bool nul[4] = {text[0] == '\0', text[1] == '\0', text[2] == '\0', text[3] == '\0'};
    if (!nul[0] && nul[1] && !nul[2] && nul[3]) return TextEncoding::kUtf16Little;
    if (nul[0] && !nul[1] && nul[2] && !nul[3]) return TextEncoding::kUtf16Big;
  }
  return TextEncoding::kUtf8;
}

const char* name(TextEncoding encoding) {
  switch (encoding) {
    case TextEncoding::kUtf8:
      return "UTF-8";
    case TextEncoding::kUtf16Little:
    case TextEncoding::kUtf16Big:
      return "UTF-16";
    case TextEncoding::kUtf32:
      break;
  }
  return "UTF-32";
}

std::string_view withoutByteOrderMark(std::string_view text) {
  if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
  return text;
}

std::optional<std::string> utf8FromUtf16(std::string_view text, TextEncoding order) {
  if (text.size() % 2 != 0) return std::nullopt;
  const bool little = order == TextEncoding::kUtf16Little;
  if (text.starts_with(little ? kLittleMark : kBigMark)) text.remove_prefix(2);
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(text[at]);
    const auto second = static_cast<unsigned char>(text[at + 1]);
    return little ? first | static_cast<unsigned>(second) << 8
                  : second | static_cast<unsigned>(first) << 8;
  };
  std::string out;
  out.reserve(text.size() / 2);
  for (std::size_t at = 0; at < text.size(); at += 2) {
    unsigned code = unit(at);
    if (code >= 0xD800 && code < 0xE000) {
      if (code >= 0xDC00 || at + 2 >= text.size()) return std::nullopt;
      const unsigned low = unit(at += 2);
      if (low < 0xDC00 || low >= 0xE000) return std::nullopt;
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    }
    appendUtf8(out, code);
  }
  return out;
}

std::int64_t lineEnds(std::string_view text) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool pair = text[i] == '\n' && i > 0 && text[i - 1] == '\r';
    if ((text[i] == '\n' || text[i] == '\r') && !pair) ++count;
  }
  return count;
}

}  // namespace vides
