// SPDX-License-Identifier: Apache-2.0
// Members that several documents have, read back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "nazori/base/utf8.h"
#include "nazori/exchange/document.h"
#include "nazori/json/reader.h"
#include "nazori/study/time.h"

namespace nazori::exchange {

using JsonObject = json::Reader::Object;

/// A text of one character.
[[nodiscard]] inline char32_t read_character(JsonObject& from, const char* member) {
  const auto decoded = base::decode_utf8(from.text(member));
  if (decoded && decoded->size() == 1) return decoded->front();
  from.refuse(member, "is not one character");
  return 0;
}

/// A value by its name. @param named  std::string_view to std::optional of the value.
template <class Named>
[[nodiscard]] auto read_name(JsonObject& from, const char* member, const Named& named) {
  const auto value = named(from.text(member));
  if (!value) from.refuse(member, "is a name that is not known");
  return value.value_or(typename decltype(named(std::string_view()))::value_type{});
}

/// One of the enumerators from 0 to `last` by the name that name_of() gives it.
template <class Enum, class NameOf>
[[nodiscard]] std::optional<Enum> enumerator_named(std::string_view name, Enum last, const NameOf& name_of) {
  for (int i = 0; i <= static_cast<int>(last); ++i)
    if (name_of(static_cast<Enum>(i)) == name) return static_cast<Enum>(i);
  return std::nullopt;
}

[[nodiscard]] inline std::optional<study::Day> read_day(JsonObject& from, const char* member) {
  if (!from.is_there(member) || !from.has(member)) {
    if (!from.is_there(member)) from.refuse(member, "is missing");
    return std::nullopt;
  }
  const auto day = study::parse_day(from.text(member));
  if (!day) from.refuse(member, "is not a day", "give one like 2026-01-31");
  return day ? std::optional(*day) : std::nullopt;
}

}  // namespace nazori::exchange
