// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "nazori/json/json.h"

namespace nazori::exchange {

using json::Value;

/// The version of every document of this room. A member that is added keeps it; one that is renamed, removed
/// or given another meaning makes it the next.
inline constexpr int kVersion = 1;

/// The document with "version" as its first member. Of an array each object has it, for an array cannot;
/// other values, and objects that say their version already, stay as they are.
[[nodiscard]] Value versioned(Value document);

/// The text of a document with its version: two spaces a level, with a line feed at the end.
[[nodiscard]] std::string to_text(Value document);
/// The same in one line, with a line feed at the end.
[[nodiscard]] std::string to_line(Value document);

/// The value, or null where there is none.
template <class T>
[[nodiscard]] Value or_null(const std::optional<T>& value) {
  return value ? Value(*value) : Value(nullptr);
}

}  // namespace nazori::exchange
