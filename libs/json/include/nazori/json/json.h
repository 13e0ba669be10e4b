// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::json {

/// A JSON value. The members of an object keep the order in which they were added, so the same value is
/// always the same text.
using Value = nlohmann::ordered_json;

/// How much of a text is accepted. Each limit is enforced while the text is parsed, so a hostile text costs
/// no more time, memory or stack than these allow.
struct Limits {
  std::size_t bytes = std::size_t{16} << 20;  ///< length of the text
  int depth = 64;                             ///< objects and arrays within each other
  std::size_t members = 1'000;                ///< of one object; an array has no limit of its own
};

/// Parses a whole JSON text (RFC 8259). Of two members of one name in an object the last counts.
/// @return Errc::parse with the place in Error::where ("line 3, column 7") for what is not JSON, or the limit
/// that is exceeded.
[[nodiscard]] base::Result<Value> parse(std::string_view text, const Limits& limits = {});

/// The value in one line, without spaces and without a line feed at the end. Bytes that are not UTF-8 become
/// U+FFFD; numbers that are not finite become null.
[[nodiscard]] std::string to_line(const Value& value);
/// The same in lines, two spaces a level, with a line feed at the end.
[[nodiscard]] std::string to_text(const Value& value);

/// The line, from 1, on which the value at `pointer` ("/cases/0/steps/2/at") ends; nullopt where there is no
/// such value. Reads the text again: for the message of an error only.
[[nodiscard]] std::optional<int> line_of(std::string_view text, std::string_view pointer);

/// What the parser says is wrong, without the place that it adds. For those who parse piece by piece.
[[nodiscard]] std::string reason_of(const nlohmann::detail::exception& error);

}  // namespace nazori::json
