// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

namespace nazori::study {

/// The enumerator with this number, if there is one. An enumerator is valid if name_of() has a name for it.
/// name_of() is a switch, and the compiler requires it to be complete, so no range has to be maintained by
/// hand.
template <class Enum>
[[nodiscard]] std::optional<Enum> value_of(std::int64_t number) {
  using Number = std::underlying_type_t<Enum>;
  if (number < std::numeric_limits<Number>::min() || number > std::numeric_limits<Number>::max())
    return std::nullopt;
  const auto value = static_cast<Enum>(number);
  return name_of(value).empty() ? std::nullopt : std::optional(value);
}

/// The enumerator with this name, where there is one.
template <class Enum>
[[nodiscard]] std::optional<Enum> value_named(std::string_view name) {
  using Number = std::underlying_type_t<Enum>;
  static_assert(sizeof(Number) == 1, "the numbers are tried one after another");
  if (name.empty()) return std::nullopt;
  for (int number = std::numeric_limits<Number>::min(); number <= std::numeric_limits<Number>::max();
       ++number) {
    const auto value = static_cast<Enum>(number);
    if (name_of(value) == name) return value;
  }
  return std::nullopt;
}

}  // namespace nazori::study
