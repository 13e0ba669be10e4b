// SPDX-License-Identifier: Apache-2.0
// Statements and whole plots read aloud; words.cpp reads their expressions.
#include <fmt/format.h>

#include <algorithm>

#include "lists.h"
#include "nazori/functions/curve_kinds.h"
#include "nazori/functions/plot.h"
#include "restricted_statement.h"
#include "words.h"

namespace nazori::functions {
namespace {

/// ", 3 curves" behind a statement with lists.
std::string curve_count(const Statement& s, Language language) {
  const bool is_region = s.kind == StatementKind::inequality;
  if (language == Language::japanese)
    return is_region ? fmt::format("、領域 {} つ", s.elements) : fmt::format("、曲線 {} 本", s.elements);
  return fmt::format(", {} {}{}", s.elements, is_region ? "region" : "curve", s.elements == 1 ? "" : "s");
}

}  // namespace

std::string in_words(const Statement& typed, Language language, SpeechStyle style) {
  const RestrictedStatement restricted = without_conditions(typed);
  const Statement& s = restricted.plain;
  const bool english = language == Language::english;
  const std::string equals = comparison_words(Comparison::equal, language);
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
      text += (i == 0 ? "" : english ? " and " : "、") + in_words(variable(*kind.left[i]), language) + equals;
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
    text += in_words(s.typed ? *s.typed : s, language, style);
    if (s.typed) text += curve_count(s, language);
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
