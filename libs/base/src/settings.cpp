// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace nazori::base {

std::string_view text_setting(const Settings& settings, std::string_view key) {
  const auto at = settings.find(key);
  return at != settings.end() ? std::string_view(at->second) : std::string_view();
}

double number_setting(const Settings& settings, std::string_view key, double fallback, double low,
                      double high) {
  const std::string_view text = text_setting(settings, key);
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = failed == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  return is_number ? std::clamp(value, low, high) : fallback;
}

bool flag_setting(const Settings& settings, std::string_view key, bool fallback) {
  const std::string_view text = text_setting(settings, key);
  return text == "true" || (text != "false" && fallback);
}

void set_number(Settings& settings, std::string key, double value) {
  settings.insert_or_assign(std::move(key), fmt::format("{}", value));
}

void set_flag(Settings& settings, std::string key, bool value) {
  settings.insert_or_assign(std::move(key), value ? "true" : "false");
}

}  // namespace nazori::base
