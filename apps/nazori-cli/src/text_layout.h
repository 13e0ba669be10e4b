// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace nazori::cli {

/// The width of a text on a terminal in columns: 2 for kanji and kana, 1 for letters, 0 for combining marks.
/// @source wcwidth of the C library in its C.UTF-8 locale.
[[nodiscard]] int display_width(std::string_view text);

/// `text` with spaces after it up to `width` columns.
[[nodiscard]] std::string pad(std::string_view text, int width);

/// The beginning of `text` that fits into `width` columns.
[[nodiscard]] std::string cut(std::string_view text, int width);

/// `text` in at most `width` columns: where it is longer, its beginning and its end with "…" between them.
[[nodiscard]] std::string shortened(std::string_view text, int width);

/// Items joined by `separator`, in lines of at most `width` columns; lines after the first start with
/// `indent` spaces. Items are not split; the first line is assumed to start at column `indent`.
[[nodiscard]] std::string flow(std::span<const std::string> items, std::string_view separator, int indent,
                               int width);

/// `text` in printable form: bytes that are not UTF-8 and control characters become \xHH.
[[nodiscard]] std::string printable(std::string_view text);

/// A reading with its okurigana separated by a middle dot: "やす・む" for "やす.む".
[[nodiscard]] std::string with_middle_dot(std::string_view reading);

}  // namespace nazori::cli
