// SPDX-License-Identifier: Apache-2.0
// Statements and whole plots read aloud; words.cpp reads their expressions.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "area.h"
#include "lists.h"
#include "nazori/functions/curve_kinds.h"
#include "nazori/functions/plot.h"
#include "restricted_statement.h"
#include "words.h"

namespace nazori::functions {
namespace {

// Significant digits of what was fitted.
constexpr int kDigits = 4;
// Larger numbers are said with a power of ten.
constexpr int kMostPlaces = 9;

/// ", 3 curves" behind a statement with lists.
std::string curve_count(const Statement& s, Language language) {
  const bool is_region = s.kind == StatementKind::inequality;
  if (language == Language::japanese)
    return is_region ? fmt::format("、領域 {} つ", s.elements) : fmt::format("、曲線 {} 本", s.elements);
  return fmt::format(", {} {}{}", s.elements, is_region ? "region" : "curve", s.elements == 1 ? "" : "s");
}

/// The number with at least this many digits. What is very small or large is said with a power of ten,
/// because nobody counts spoken zeros.
std::string rounded_words(double v, int digits, Language language) {
  const bool english = language == Language::english;
  const int places = v != 0 ? static_cast<int>(std::floor(std::log10(std::abs(v)))) : 0;
  const int shown = std::max(digits, places < kMostPlaces ? places + 1 : 0);
  const double rounded = std::stod(fmt::format("{:.{}g}", v, shown)) + 0.0;
  std::string text = std::abs(v - rounded) <= 1e-12 * std::abs(v) ? "" : english ? "about " : "約";
  if (rounded < 0) text += english ? "minus " : "マイナス";
  if (places >= -4 && places < kMostPlaces) return text + to_text(number(std::abs(rounded)));
  const std::string power = number_words(places, language);
  const std::string size = fmt::format("{:.{}g}", std::abs(rounded) / std::pow(10.0, places), digits);
  return text + size + (english ? " times 10 to the power of " + power : " かける 10 の " + power + " 乗");
}

/// R squared with so many digits that what is not 1 does not sound like 1.
std::string r_squared_words(double v, Language language) {
  int digits = kDigits;
  while (v < 1 && digits < 12 && std::stod(fmt::format("{:.{}g}", v, digits)) >= 1) ++digits;
  return rounded_words(v, digits, language);
}

/// ", a is 2, b is about 0.3333, R squared is 1, ..." behind a model.
std::string fit_words(const Fit& fit, Language language) {
  const bool english = language == Language::english;
  std::string text;
  for (const FittedLetter& l : fit.letters)
    text += (english ? ", " + l.name + " is " : "、" + l.name + " は ") +
            rounded_words(l.value, kDigits, language);
  if (std::isfinite(fit.r_squared))
    text += (english ? ", R squared is " : "、決定係数は ") + r_squared_words(fit.r_squared, language);
  text += (english ? ", the sum of squared residuals is " : "、残差平方和は ") +
          rounded_words(fit.residual_sum, kDigits, language);
  return text + (english ? fmt::format(", from {} point{}", fit.points, fit.points == 1 ? "" : "s")
                         : fmt::format("、点 {} 個", fit.points));
}

/// Measured points are not read one by one.
std::string data_words(const Statement& s, Language language) {
  std::array<double, 2> low{};
  std::array<double, 2> high{};
  const std::vector<TypedPoint> points = typed_points(s);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<double, 2> at{constant_value(points[i].x), constant_value(points[i].y)};
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = i == 0 ? at[k] : std::min(low[k], at[k]);
      high[k] = i == 0 ? at[k] : std::max(high[k], at[k]);
    }
  }
  const auto say = [language](double v) { return number_words(v, language); };
  if (language == Language::japanese)
    return fmt::format("データの点 {} 個、x は {} から {} まで、y は {} から {} まで", points.size(),
                       say(low[0]), say(high[0]), say(low[1]), say(high[1]));
  return fmt::format("{} data point{}, x from {} to {}, y from {} to {}", points.size(),
                     points.size() == 1 ? "" : "s", say(low[0]), say(high[0]), say(low[1]), say(high[1]));
}

}  // namespace

std::string in_words(const Statement& typed, Language language, SpeechStyle style) {
  if (typed.area) return area_in_words(*typed.area, language, style);
  if (typed.fit) return in_words(*typed.typed, language, style) + fit_words(*typed.fit, language);
  if (typed.is_data) return data_words(typed, language);
  const RestrictedStatement restricted = without_conditions(typed);
  const Statement& s = restricted.plain;
  const bool english = language == Language::english;
  const std::string equals = comparison_words(Comparison::equal, language);
  const std::string is_fitted_by = english ? " is fitted by " : " の近似式 ";
  const auto range = [&](std::string_view parameter) {
    const std::string from = in_words(s.from, language, style);
    const std::string to = in_words(s.to, language, style);
    std::string text = english ? fmt::format(", for {} from {} to {}", parameter, from, to)
                               : fmt::format("、{} は {} から {} まで", parameter, from, to);
    if (s.from_is_open && s.to_is_open) return text + (english ? ", both excluded" : "、両端を除く");
    if (!s.from_is_open && !s.to_is_open) return text;
    const std::string& out = s.from_is_open ? from : to;
    return text + (english ? fmt::format(", {} excluded", out) : fmt::format("、{} を除く", out));
  };
  if (s.is_point) {
    const std::string x = in_words(s.terms[0], language, style);
    const std::string y = in_words(s.terms[1], language, style);
    const bool are_several = std::any_of(s.terms.begin(), s.terms.end(), has_list);
    if (are_several) {
      const std::size_t count = typed_points(s).size();
      return english ? fmt::format("the {} points with x {} and y {}", count, x, y)
                     : fmt::format("点 {} 個、x {}、y {}", count, x, y);
    }
    return english ? fmt::format("the point with x {} and y {}", x, y) : fmt::format("点 x {}、y {}", x, y);
  }
  const CurveKind& kind = curve_kind(s.kind);
  std::string text;
  for (std::size_t i = 0; i < s.terms.size(); ++i) {
    if (!s.name.empty())
      text += (english ? s.name + " of x" : s.name + "、x の関数") + equals;
    else if (kind.left[0])
      text += (i == 0    ? ""
               : english ? " and "
                         : "、") +
              in_words(variable(*kind.left[i]), language) + (s.is_model ? is_fitted_by : equals);
    else if (i > 0)
      text += comparison_words(s.comparisons[i - 1], language);
    text += in_words(s.terms[i], language, style);
  }
  for (const Expression& c : restricted.conditions)
    text += (english ? ", only where " : "、ただし ") + in_words(c, language, style);
  return kind.says_range(s) ? text + range(in_words(variable(kind.parameter), language)) : text;
}

std::string in_words(const Plot& plot, Language language, SpeechStyle style) {
  std::string text;
  for (const Statement& s : plot.statements) {
    if (s.element > 0) continue;
    text += text.empty() ? "" : language == Language::english ? "; " : "。";
    const bool has_lists = s.typed && !s.fit;
    text += in_words(has_lists ? *s.typed : s, language, style);
    if (has_lists) text += curve_count(s, language);
  }
  const bool english = language == Language::english;
  for (const Parameter& p : plot.parameters) {
    const auto say = [language](double v) { return number_words(v, language); };
    text += (english ? "; " : "。") + p.name + comparison_words(Comparison::equal, language) + say(p.value);
    if (!p.range_given) continue;
    text += english ? fmt::format(", from {} to {}", say(p.from), say(p.to))
                    : fmt::format("、{} から {} まで", say(p.from), say(p.to));
  }
  for (const NamedList& l : plot.lists)
    text += (english ? "; " : "。") + l.name + comparison_words(Comparison::equal, language) +
            in_words(l.typed, language, style);
  return text;
}

}  // namespace nazori::functions
