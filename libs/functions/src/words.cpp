// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "nazori/functions/curve_kinds.h"
#include "nazori/functions/plot.h"
#include "strength.h"

namespace nazori::functions {
namespace {

struct FunctionWords {
  std::string_view english;
  std::string_view japanese;
};

// In the order of Function.
constexpr std::array<FunctionWords, 42> kFunctionWords{
    {{"sine", "サイン"},
     {"cosine", "コサイン"},
     {"tangent", "タンジェント"},
     {"cotangent", "コタンジェント"},
     {"secant", "セカント"},
     {"cosecant", "コセカント"},
     {"arc sine", "アークサイン"},
     {"arc cosine", "アークコサイン"},
     {"arc tangent", "アークタンジェント"},
     {"arc cotangent", "アークコタンジェント"},
     {"hyperbolic sine", "ハイパボリックサイン"},
     {"hyperbolic cosine", "ハイパボリックコサイン"},
     {"hyperbolic tangent", "ハイパボリックタンジェント"},
     {"hyperbolic cotangent", "ハイパボリックコタンジェント"},
     {"hyperbolic secant", "ハイパボリックセカント"},
     {"hyperbolic cosecant", "ハイパボリックコセカント"},
     {"inverse hyperbolic sine", "逆ハイパボリックサイン"},
     {"inverse hyperbolic cosine", "逆ハイパボリックコサイン"},
     {"inverse hyperbolic tangent", "逆ハイパボリックタンジェント"},
     {"exponential", "指数関数"},
     {"natural logarithm", "自然対数"},
     {"logarithm to base 10", "常用対数"},
     {"logarithm to base 2", "2を底とする対数"},
     {"logarithm", "対数"},
     {"square root", "平方根"},
     {"cube root", "立方根"},
     {"root", "累乗根"},
     {"absolute value", "絶対値"},
     {"sign", "符号"},
     {"floor", "床関数"},
     {"ceiling", "天井関数"},
     {"rounding", "四捨五入"},
     {"truncation", "切り捨て"},
     {"fractional part", "小数部分"},
     {"gamma", "ガンマ関数"},
     {"factorial", "階乗"},
     {"error function", "誤差関数"},
     {"minimum", "最小値"},
     {"maximum", "最大値"},
     {"remainder", "余り"},
     {"angle", "偏角"},
     {"hypotenuse", "斜辺"}}};

std::string number_text(double v, Language language) {
  if (v < 0) return (language == Language::english ? "minus " : "マイナス") + fmt::format("{}", -v);
  return fmt::format("{}", v);
}

class Speaker {
 public:
  explicit Speaker(Language language) : english_(language == Language::english), language_(language) {}

  std::string spoken(const Expression& e) const {
    const Node& n = *e;
    const auto& a = n.arguments;
    switch (n.kind) {
      case NodeKind::number:
        return number_text(n.value, language_);
      case NodeKind::constant:
        return n.constant == Constant::pi ? (english_ ? "pi" : "パイ") : std::string(name_of(n.constant));
      case NodeKind::variable:
        return n.variable == Variable::theta && !english_ ? "シータ" : std::string(name_of(n.variable));
      case NodeKind::negate:
        return (english_ ? "minus " : "マイナス ") + fenced(a[0], 3);
      case NodeKind::add:
        return fenced(a[0], 1) + (english_ ? " plus " : " 足す ") + fenced(a[1], 2);
      case NodeKind::subtract:
        return fenced(a[0], 1) + (english_ ? " minus " : " 引く ") + fenced(a[1], 2);
      case NodeKind::multiply: {
        const bool quotient = a[0]->kind == NodeKind::divide;
        return (quotient ? spoken(a[0]) + (english_ ? "," : "、") : fenced(a[0], 2)) +
               (english_ ? " times " : " かける ") + fenced(a[1], 3);
      }
      case NodeKind::divide:
        if (english_) return fenced(a[0], 3) + " over " + fenced(a[1], 3);
        return fenced(a[1], 3) + " 分の " + fenced(a[0], 3);
      case NodeKind::power:
        return power(a);
      case NodeKind::function:
        return function(n);
    }
    return {};
  }

 private:
  std::string fenced(const Expression& e, int least) const {
    if (strength(*e) >= least) return spoken(e);
    return english_ ? "the quantity " + spoken(e) + " end" : "括弧 " + spoken(e) + " 括弧閉じ";
  }

  std::string power(const std::vector<Expression>& a) const {
    const Node& n = *a[1];
    const bool plain = n.kind == NodeKind::number;
    // "x to the power of minus 2" is unambiguous when heard.
    const bool whole = plain || (n.kind == NodeKind::negate && n.arguments[0]->kind == NodeKind::number);
    if (!english_) return fenced(a[0], 5) + " の " + fenced(a[1], whole ? 0 : 5) + " 乗";
    if (plain && n.value == 2) return fenced(a[0], 5) + " squared";
    if (plain && n.value == 3) return fenced(a[0], 5) + " cubed";
    return fenced(a[0], 5) + " to the power of " + fenced(a[1], whole ? 0 : 4);
  }

  std::string function(const Node& n) const {
    const auto& words = kFunctionWords[static_cast<std::size_t>(n.function)];
    const auto& a = n.arguments;
    switch (n.function) {
      case Function::factorial:
        return fenced(a[0], 5) + (english_ ? " factorial" : " の階乗");
      case Function::log_base:
        return english_ ? "the logarithm to base " + fenced(a[0], 5) + " of " + fenced(a[1], 4)
                        : spoken(a[0]) + " を底とする " + spoken(a[1]) + " の対数";
      case Function::root:
        return english_ ? "the " + spoken(a[0]) + "th root of " + fenced(a[1], 4)
                        : spoken(a[1]) + " の " + spoken(a[0]) + " 乗根";
      case Function::sin:
      case Function::cos:
      case Function::tan:
      case Function::cot:
      case Function::sec:
      case Function::csc:
      case Function::asin:
      case Function::acos:
      case Function::atan:
      case Function::acot:
      case Function::sinh:
      case Function::cosh:
      case Function::tanh:
      case Function::coth:
      case Function::sech:
      case Function::csch:
        // As mathematicians say it: sine of 2 x.
        return english_ ? std::string(words.english) + " of " + fenced(a[0], 2)
                        : std::string(words.japanese) + " " + fenced(a[0], 2);
      default:
        break;
    }
    std::string list = fenced(a[0], a.size() > 1 ? 1 : 2);
    for (std::size_t i = 1; i < a.size(); ++i) list += (english_ ? " and " : " と ") + spoken(a[i]);
    return english_ ? "the " + std::string(words.english) + " of " + list
                    : list + " の" + std::string(words.japanese);
  }

  bool english_;
  Language language_;
};

std::string comparison(Comparison c, Language language) {
  constexpr std::array<std::string_view, 5> kEnglish{" equals ", " is less than ", " is at most ",
                                                     " is greater than ", " is at least "};
  constexpr std::array<std::string_view, 5> kJapanese{" イコール ", " 小なり ", " 小なりイコール ",
                                                      " 大なり ", " 大なりイコール "};
  return std::string((language == Language::english ? kEnglish : kJapanese)[static_cast<std::size_t>(c)]);
}

}  // namespace

std::string in_words(const Expression& expression, Language language) {
  return Speaker(language).spoken(expression);
}

std::string in_words(const Statement& s, Language language) {
  const bool english = language == Language::english;
  const std::string equals = comparison(Comparison::equal, language);
  const auto range = [&](std::string_view parameter) {
    const std::string from = in_words(s.from, language);
    const std::string to = in_words(s.to, language);
    std::string text = english ? fmt::format(", for {} from {} to {}", parameter, from, to)
                               : fmt::format("、{} は {} から {} まで", parameter, from, to);
    if (s.from_is_open && s.to_is_open) return text + (english ? ", both excluded" : "、両端を除く");
    if (!s.from_is_open && !s.to_is_open) return text;
    const std::string& out = s.from_is_open ? from : to;
    return text + (english ? fmt::format(", {} excluded", out) : fmt::format("、{} を除く", out));
  };
  const CurveKind& kind = curve_kind(s.kind);
  std::string text;
  for (std::size_t i = 0; i < s.terms.size(); ++i) {
    if (kind.left[0])
      text += (i == 0 ? "" : english ? " and " : "、") + in_words(variable(*kind.left[i]), language) + equals;
    else if (i > 0)
      text += comparison(s.comparisons[i - 1], language);
    text += in_words(s.terms[i], language);
  }
  return kind.says_range(s) ? text + range(in_words(variable(kind.parameter), language)) : text;
}

std::string in_words(const Plot& plot, Language language) {
  std::string text;
  for (const Statement& s : plot.statements)
    text += (text.empty() ? "" : language == Language::english ? "; " : "。") + in_words(s, language);
  return text;
}

}  // namespace nazori::functions
