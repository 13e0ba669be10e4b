// SPDX-License-Identifier: Apache-2.0
#include "area.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "nazori/functions/area.h"
#include "nazori/functions/points.h"
#include "spoken_value.h"

namespace nazori::functions {
namespace {

Expression other_border(const Area& area) { return area.second ? area.second : number(0); }

Expression difference(const Area& area) {
  return area.second ? binary(NodeKind::subtract, area.first, area.second) : area.first;
}

}  // namespace

Statement area_statement(Area area, int column) {
  Statement s;
  s.kind = StatementKind::inequality;
  s.column = column;
  const bool mirrored = constant_value(area.from) > constant_value(area.to);
  const Expression other = other_border(area);
  const Expression x = variable(Variable::x);
  s.terms = {call(Function::min, {area.first, other}),
             variable(Variable::y),
             call(Function::max, {area.first, other}),
             mirrored ? area.to : area.from,
             x,
             mirrored ? area.from : area.to};
  s.comparisons = {Comparison::less_equal, Comparison::less_equal, Comparison::both, Comparison::less_equal,
                   Comparison::less_equal};
  s.area = std::move(area);
  return s;
}

Expression area_integral(const Area& area) {
  return integral(call(Function::abs, {difference(area)}), Variable::x, area.from, area.to);
}

std::string area_text(const Area& area) {
  std::string text = "area(" + to_text(area.first) + ", ";
  if (area.second) text += to_text(area.second) + ", ";
  return text + to_text(area.from) + ", " + to_text(area.to) + ")";
}

std::string area_in_words(const Area& area, Language language, SpeechStyle style) {
  const bool english = language == Language::english;
  const auto curve = [&](const Expression& e) {
    return (english ? "y equals " : "y イコール ") + in_words(e, language, style);
  };
  const std::string other = area.second ? curve(area.second) : english ? "the x axis" : "x 軸";
  const std::string from = in_words(area.from, language, style);
  const std::string to = in_words(area.to, language, style);
  const std::string first = curve(area.first);
  if (!english) return fmt::format("{} と {} の間の面積、x は {} から {} まで", first, other, from, to);
  return fmt::format("the area between {} and {}, for x from {} to {}", first, other, from, to);
}

std::optional<AreaValue> area_value(const Statement& s) {
  if (!s.area) return std::nullopt;
  const Area& area = *s.area;
  AreaValue v;
  v.integral = constant_value(integral(difference(area), Variable::x, area.from, area.to));
  v.area = std::abs(constant_value(area_integral(area)));
  if (!std::isfinite(v.integral) || !std::isfinite(v.area)) return std::nullopt;
  v.integral_name = exact_name(v.integral);
  v.area_name = exact_name(v.area);
  return v;
}

std::string areas_in_words(const Plot& plot, Language language, SpeechStyle style) {
  const bool english = language == Language::english;
  std::string text;
  for (const Statement& s : plot.statements) {
    if (!s.area) continue;
    const auto v = area_value(s);
    if (!v) {
      text += english ? ", area not defined" : "、面積は定義されません";
      continue;
    }
    text += (english ? ", area " : "、面積 ") + spoken(v->area, v->area_name.value_or(""), language, style);
    if (std::abs(v->area - v->integral) <= 1e-12 * v->area) continue;
    text += (english ? ", integral " : "、積分 ") +
            spoken(v->integral, v->integral_name.value_or(""), language, style);
  }
  return text;
}

}  // namespace nazori::functions
