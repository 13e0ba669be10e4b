// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace nazori::base {

/// Settings as they are stored: text by key, UTF-8. A key may have folders: "known/61/tilt". Numbers are
/// written as C++ writes them, values of an enumeration by their names, so that the order of the enumeration
/// may change. Where and how the text is stored (a file, the storage of a browser) is decided by the program.
using Settings = std::map<std::string, std::string, std::less<>>;

/// The text of a setting, empty where there is none. Valid until `settings` changes.
[[nodiscard]] std::string_view text_setting(const Settings& settings, std::string_view key);

/// A number, limited to `low` .. `high`; `fallback` where there is none or the text is not a finite number.
[[nodiscard]] double number_setting(const Settings& settings, std::string_view key, double fallback,
                                    double low, double high);

/// A switch: "true" or "false"; `fallback` where there is neither.
[[nodiscard]] bool flag_setting(const Settings& settings, std::string_view key, bool fallback);

/// Stores a number so that reading it gives exactly the same number.
void set_number(Settings& settings, std::string key, double value);

/// Stores a switch.
void set_flag(Settings& settings, std::string key, bool value);

/// A value of an enumeration, counted from 0, by its name; `fallback` where there is none, or the name is
/// unknown.
template <class Enum, std::size_t N>
[[nodiscard]] Enum named_setting(const Settings& settings, std::string_view key,
                                 const std::array<std::string_view, N>& names, Enum fallback) {
  const std::string_view text = text_setting(settings, key);
  for (std::size_t i = 0; i < N; ++i)
    if (text == names[i]) return static_cast<Enum>(i);
  return fallback;
}

}  // namespace nazori::base
