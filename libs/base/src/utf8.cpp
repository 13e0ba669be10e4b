// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/utf8.h"

#include <cstddef>
#include <cstdint>

namespace nazori::base {
namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr char32_t kLargest = 0x10FFFF;

bool is_surrogate(char32_t c) { return c >= 0xD800 && c <= 0xDFFF; }

}  // namespace

std::optional<std::u32string> decode_utf8(std::string_view text) {
  std::u32string out;
  out.reserve(text.size());
  std::size_t i = 0;
  while (i < text.size()) {
    const auto lead = static_cast<std::uint8_t>(text[i]);
    std::size_t following = 0;
    char32_t value = lead;
    char32_t smallest = 0;
    if (lead >= 0xF0 && lead <= 0xF4) {
      following = 3, value = lead & 0x07U, smallest = 0x10000;
    } else if (lead >= 0xE0 && lead <= 0xEF) {
      following = 2, value = lead & 0x0FU, smallest = 0x800;
    } else if (lead >= 0xC2 && lead <= 0xDF) {
      following = 1, value = lead & 0x1FU, smallest = 0x80;
    } else if (lead >= 0x80) {
      return std::nullopt;
    }
    if (text.size() - i <= following) return std::nullopt;
    for (std::size_t k = 1; k <= following; ++k) {
      const auto next = static_cast<std::uint8_t>(text[i + k]);
      if ((next & 0xC0U) != 0x80U) return std::nullopt;
      value = (value << 6U) | (next & 0x3FU);
    }
    if (value < smallest || value > kLargest || is_surrogate(value)) return std::nullopt;
    out.push_back(value);
    i += following + 1;
  }
  return out;
}

std::string encode_utf8(char32_t code_point) {
  const char32_t c = is_surrogate(code_point) || code_point > kLargest ? kReplacement : code_point;
  std::string out;
  if (c < 0x80) {
    out += static_cast<char>(c);
  } else if (c < 0x800) {
    out += static_cast<char>(0xC0U | (c >> 6U));
    out += static_cast<char>(0x80U | (c & 0x3FU));
  } else if (c < 0x10000) {
    out += static_cast<char>(0xE0U | (c >> 12U));
    out += static_cast<char>(0x80U | ((c >> 6U) & 0x3FU));
    out += static_cast<char>(0x80U | (c & 0x3FU));
  } else {
    out += static_cast<char>(0xF0U | (c >> 18U));
    out += static_cast<char>(0x80U | ((c >> 12U) & 0x3FU));
    out += static_cast<char>(0x80U | ((c >> 6U) & 0x3FU));
    out += static_cast<char>(0x80U | (c & 0x3FU));
  }
  return out;
}

std::string encode_utf8(std::u32string_view code_points) {
  std::string out;
  for (const char32_t c : code_points) out += encode_utf8(c);
  return out;
}

}  // namespace nazori::base
