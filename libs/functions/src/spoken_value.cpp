// SPDX-License-Identifier: Apache-2.0
#include "spoken_value.h"

#include <fmt/format.h>

#include <cmath>

namespace nazori::functions {
namespace {

/// Four significant digits, never with a power of ten: "1000000", "0.00000125".
std::string four_digits(double v) {
  constexpr double kLargest = 1e15;
  constexpr double kSmallest = 1e-4;
  if (v >= kLargest || !std::isfinite(v)) return fmt::format("{:.4g}", v);
  if (v >= 1000) {
    const double unit = std::pow(10.0, std::floor(std::log10(v)) - 3);
    return fmt::format("{:.0f}", std::round(v / unit) * unit);
  }
  if (v >= kSmallest || v == 0) return fmt::format("{:.4g}", v);
  std::string digits = fmt::format("{:.{}f}", v, static_cast<int>(3 - std::floor(std::log10(v))));
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits;
}

}  // namespace

std::string spoken(double v, const std::string& name, Language language, SpeechStyle style) {
  const bool english = language == Language::english;
  const double shown = std::abs(v) < 1e-12 ? 0 : v;
  const std::string sign = shown < 0 ? (english ? "minus " : "マイナス") : "";
  const std::string digits = sign + four_digits(std::abs(shown));
  if (name.empty()) return (english ? "about " : "約") + digits;
  const bool plain = name.find_first_not_of("-0123456789") == std::string::npos;
  if (plain) return sign + (name[0] == '-' ? name.substr(1) : name);
  const auto parsed = parse(name);
  const std::string words = parsed ? in_words(parsed->statements[0].terms[0], language, style) : name;
  return english ? words + ", about " + digits : words + "、約" + digits;
}

}  // namespace nazori::functions
