// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::kanji {

/// Code points of characters that people made themselves: Supplementary Private Use Area-A, to which Unicode
/// never gives characters. @source The Unicode Standard, chapter 23.5.
inline constexpr char32_t kFirstOwn = 0xF0000;
inline constexpr char32_t kLastOwn = 0xFFFFD;
[[nodiscard]] constexpr bool is_own(char32_t code_point) {
  return code_point >= kFirstOwn && code_point <= kLastOwn;
}

}  // namespace nazori::kanji
