// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace nazori::base {

/// The code points of UTF-8 text, or nothing where the text is not valid UTF-8 (overlong forms, surrogates
/// and numbers over U+10FFFF are not).
/// @source The Unicode Standard, table 3-7.
[[nodiscard]] std::optional<std::u32string> decode_utf8(std::string_view text);

/// UTF-8 of one code point. A surrogate or a number over U+10FFFF gives U+FFFD.
[[nodiscard]] std::string encode_utf8(char32_t code_point);

/// UTF-8 of several code points.
[[nodiscard]] std::string encode_utf8(std::u32string_view code_points);

}  // namespace nazori::base
