// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "nazori/functions/points.h"

namespace nazori::functions {
namespace {

struct KindWords {
  std::string_view one;
  std::string_view many;
  std::string_view japanese;
};
// In the order of PointKind.
constexpr std::array<KindWords, 15> kKinds{{{"zero", "zeros", "零点"},
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
                                            {"isolated point", "isolated points", "孤立点"}}};

/// Three significant digits, "minus" in words for listeners; an exact name comes first.
std::string spoken(double v, const std::string& name, Language language) {
  const bool english = language == Language::english;
  const double shown = std::abs(v) < 1e-12 ? 0 : v;
  std::string digits = fmt::format("{:.4g}", std::abs(shown));
  if (shown < 0) digits = (english ? "minus " : "マイナス") + digits;
  if (name.empty()) return (english ? "about " : "約") + digits;
  const bool plain = name.find_first_not_of("-0123456789") == std::string::npos;
  if (plain) return digits;
  const auto parsed = parse(name);
  const std::string words = parsed ? in_words(parsed->statements[0].terms[0], language) : name;
  return english ? words + ", about " + digits : words + "、約" + digits;
}

}  // namespace

std::string in_words(PointKind kind, Language language) {
  const KindWords& words = kKinds[static_cast<std::size_t>(kind)];
  return std::string(language == Language::english ? words.one : words.japanese);
}

std::string in_words(const PointOfInterest& p, Language language) {
  const bool english = language == Language::english;
  std::string text = in_words(p.kind, language) + (english ? " at " : ": ");
  const char* joint = english ? "; " : "、";
  if (!std::isnan(p.x)) text += (english ? "x = " : "x = ") + spoken(p.x, p.x_name, language);
  if (!std::isnan(p.y))
    text += (std::isnan(p.x) ? "" : joint) + std::string("y = ") + spoken(p.y, p.y_name, language);
  return text;
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
                    Language language) {
  const bool english = language == Language::english;
  std::string text = in_words(plot, language);
  const bool empty =
      tracing.branches.empty() && tracing.bars.empty() && tracing.dots.empty() && tracing.fills.empty();
  if (!plot.is_surface()) {
    if (empty) {
      text += english ? ": no points in this range" : "。この範囲に点はありません";
    } else if (!tracing.branches.empty()) {
      const std::size_t n = tracing.branches.size();
      text += english ? fmt::format(": {} {}", n, n == 1 ? "branch" : "branches") : fmt::format("。{}本", n);
    }
    std::map<PointKind, int> counts;
    for (const PointOfInterest& p : points) ++counts[p.kind];
    for (const auto& [kind, count] : counts) {
      const KindWords& words = kKinds[static_cast<std::size_t>(kind)];
      text += english ? fmt::format(", {} {}", count, count == 1 ? words.one : words.many)
                      : fmt::format("、{} {}個", words.japanese, count);
    }
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
