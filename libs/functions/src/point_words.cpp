// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "algebra.h"
#include "far_out.h"
#include "nazori/functions/area.h"
#include "nazori/functions/curve_kinds.h"
#include "nazori/functions/points.h"
#include "spoken_value.h"

namespace nazori::functions {
namespace {

struct KindWords {
  std::string_view one;
  std::string_view many;
  std::string_view japanese;
};
// In the order of PointKind.
constexpr std::array<KindWords, 17> kKinds{{{"zero", "zeros", "零点"},
                                            {"y intercept", "y intercepts", "y切片"},
                                            {"maximum", "maxima", "極大"},
                                            {"minimum", "minima", "極小"},
                                            {"inflection point", "inflections", "変曲点"},
                                            {"crossing", "crossings", "交点"},
                                            {"point of contact", "touching points", "接点"},
                                            {"vertical asymptote", "vertical asymptotes", "垂直漸近線"},
                                            {"horizontal asymptote", "horizontal asymptotes", "水平漸近線"},
                                            {"hole", "holes", "穴（除去可能な不連続点）"},
                                            {"jump", "jumps", "跳び（不連続点）"},
                                            {"end", "ends", "端"},
                                            {"self-crossing", "self-crossings", "自己交差"},
                                            {"singular point", "singular points", "特異点"},
                                            {"isolated point", "isolated points", "孤立点"},
                                            {"cusp", "cusps", "尖点"},
                                            {"slanted asymptote", "slanted asymptotes", "斜めの漸近線"}}};

/// A line y = m x + b.
std::string line_in_words(const PointOfInterest& p, Language language, SpeechStyle style) {
  const bool english = language == Language::english;
  const auto value = [&](double v) { return spoken(v, exact_name(v).value_or(""), language, style); };
  std::string text = "y = ";
  if (p.slope == -1) text += english ? "minus " : "マイナス ";
  if (std::abs(p.slope) != 1) text += value(p.slope) + (english ? " times " : " かける ");
  text += "x";
  if (std::abs(p.intercept) < 1e-12) return text;
  if (p.intercept > 0) return text + (english ? " plus " : " 足す ") + value(p.intercept);
  return text + (english ? " minus " : " 引く ") + value(-p.intercept);
}

/// Where the curve is beside an asymptote, if it is on one side only.
std::string side_in_words(const PointOfInterest& p, Language language) {
  if (p.side == 0) return {};
  const bool english = language == Language::english;
  // Beside an upright asymptote of y = f(x), or a level one of x = g(y), else far out.
  const bool is_beside =
      p.kind == (p.along_y ? PointKind::horizontal_asymptote : PointKind::vertical_asymptote);
  struct SideWords {
    const char* english;
    const char* japanese;
  };
  // By along_y, is_beside and the sign of the side.
  constexpr SideWords kWords[2][2][2] = {
      {{{", far to the left only", "（左の遠くだけ）"}, {", far to the right only", "（右の遠くだけ）"}},
       {{", on its left side only", "（左側だけ）"}, {", on its right side only", "（右側だけ）"}}},
      {{{", far below only", "（下の遠くだけ）"}, {", far above only", "（上の遠くだけ）"}},
       {{", below it only", "（下側だけ）"}, {", above it only", "（上側だけ）"}}}};
  const SideWords& words = kWords[p.along_y ? 1 : 0][is_beside ? 1 : 0][p.side > 0 ? 1 : 0];
  return english ? words.english : words.japanese;
}

/// What is on both sides of a jump, and what is taken.
std::string jump_in_words(const PointOfInterest& p, Language language, SpeechStyle style) {
  const bool english = language == Language::english;
  const auto value = [&](double v) { return spoken(v, exact_name(v).value_or(""), language, style); };
  const Jump& j = *p.jump;
  const bool upright = j.x_before == j.x_after;
  const auto place = [&](double x, double y) {
    return upright ? "y = " + value(y) : "x = " + value(x) + (english ? "; " : "、") + "y = " + value(y);
  };
  std::string text =
      english ? fmt::format(" from {} to {}", place(j.x_before, j.y_before), place(j.x_after, j.y_after))
              : fmt::format("{} から {} へ", place(j.x_before, j.y_before), place(j.x_after, j.y_after));
  if (!upright) return text;
  if (std::isnan(j.y_at)) return text + (english ? ", no value there" : "、そこに値はありません");
  return text + (english ? ", the value is " : "、値は ") + value(j.y_at);
}

/// What y = f(x) does far out: ", far to the left y falls without bound, far to the right y approaches 1".
std::string far_in_words(const Plot& plot, Language language, SpeechStyle style) {
  if (plot.statements.size() != 1 || !curve_kind(plot.statements[0].kind).is_graph_of_x()) return {};
  const Expression& f = plot.statements[0].terms[0];
  if (!depends_on(f, Variable::x) || node_count(f) > kMostNodesOfAlgebra) return {};
  const bool english = language == Language::english;
  std::string text;
  for (const int direction : {-1, 1}) {
    const FarBehaviour far = far_behaviour(f, Variable::x, direction);
    const bool left = direction < 0;
    const std::string where = english ? (left ? ", far to the left y " : ", far to the right y ")
                                      : (left ? "、左の遠くでは y は " : "、右の遠くでは y は ");
    const bool up = far.kind == FarOut::rises || (far.kind == FarOut::slanted && far.slope * direction > 0);
    switch (far.kind) {
      case FarOut::unknown:
      case FarOut::undefined:
        break;
      case FarOut::level: {
        const std::string value =
            spoken(far.intercept, exact_name(far.intercept).value_or(""), language, style);
        text += where;
        if (far.coincides)
          text += english ? "is " + value : value + " です";
        else
          text += english ? "approaches " + value : value + " に近づきます";
        break;
      }
      case FarOut::rises:
      case FarOut::falls:
      case FarOut::slanted:
        text += where + (english ? (up ? "rises without bound" : "falls without bound")
                                 : (up ? "限りなく大きくなります" : "限りなく小さくなります"));
        break;
    }
  }
  return text;
}

}  // namespace

std::string in_words(PointKind kind, Language language) {
  const KindWords& words = kKinds[static_cast<std::size_t>(kind)];
  return std::string(language == Language::english ? words.one : words.japanese);
}

std::string in_words(const PointOfInterest& p, Language language, SpeechStyle style) {
  const bool english = language == Language::english;
  std::string text = in_words(p.kind, language) + (english ? " at " : ": ");
  const char* joint = english ? "; " : "、";
  if (p.kind == PointKind::slanted_asymptote)
    return in_words(p.kind, language) + (english ? " " : ": ") + line_in_words(p, language, style) +
           side_in_words(p, language);
  if (!std::isnan(p.x)) text += "x = " + spoken(p.x, p.x_name, language, style);
  if (p.jump) return text + (english ? "," : "、") + jump_in_words(p, language, style);
  if (!std::isnan(p.y))
    text += (std::isnan(p.x) ? "" : joint) + std::string("y = ") + spoken(p.y, p.y_name, language, style);
  return text + side_in_words(p, language);
}

std::string place_in_words(double x, double y, Language language) {
  const auto name = [](double v) {
    // Whole numbers need no "about".
    return std::round(v) == v && std::abs(v) < 1e4 ? fmt::format("{:.0f}", v + 0.0) : std::string();
  };
  return "x = " + spoken(x, name(x), language) + (language == Language::english ? "; " : "、") +
         "y = " + spoken(y, name(y), language);
}

std::string summary(const Plot& plot, const Tracing& tracing, const std::vector<PointOfInterest>& points,
                    Language language, SpeechStyle style) {
  const bool english = language == Language::english;
  std::string text = in_words(plot, language, style);
  const bool empty =
      tracing.branches.empty() && tracing.bars.empty() && tracing.dots.empty() && tracing.fills.empty();
  if (!plot.is_surface()) {
    if (empty) {
      text += english ? ": no points in this range" : "。この範囲に点はありません";
    } else if (!tracing.branches.empty()) {
      const int n = pieces(plot, tracing);
      text +=
          english ? fmt::format(": {} {}", n, n == 1 ? "piece" : "pieces") : fmt::format("。{}つの部分", n);
    }
    std::map<PointKind, int> counts;
    for (const PointOfInterest& p : points) ++counts[p.kind];
    for (const auto& [kind, count] : counts) {
      const KindWords& words = kKinds[static_cast<std::size_t>(kind)];
      text += english ? fmt::format(", {} {}", count, count == 1 ? words.one : words.many)
                      : fmt::format("、{} {}個", words.japanese, count);
    }
    text += areas_in_words(plot, language, style);
    if (!empty) text += far_in_words(plot, language, style);
    if (tracing.dense) text += english ? ", a dense band" : "、密な帯";
    if (!tracing.complete) text += english ? ", not finished yet" : "、まだ途中です";
    if (tracing.undecided_share() > 0.001) {
      text += english ? ", part of the plot could not be determined" : "、一部は判定できませんでした";
      if (!tracing.undecided_places.empty()) {
        const PlatePoint at = tracing.undecided_places.front();
        const std::string place = place_in_words(tracing.window.x(at.u), tracing.window.y(at.v), language);
        text += english ? ", first near " + place : "（" + place + " の近くなど）";
      }
    }
  }
  return text + (english ? "." : "。");
}

}  // namespace nazori::functions
