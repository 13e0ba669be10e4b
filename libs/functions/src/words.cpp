// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "nazori/functions/plot.h"
#include "restricted_statement.h"
#include "strength.h"
#include "words.h"

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

/// "third", "21st", "12th".
std::string ordinal(int n) {
  constexpr std::array<std::string_view, 10> kSmall{"zeroth", "first", "second",  "third",  "fourth",
                                                    "fifth",  "sixth", "seventh", "eighth", "ninth"};
  if (n < 10) return std::string(kSmall[static_cast<std::size_t>(n)]);
  const int last = n % 100 / 10 == 1 ? 0 : n % 10;
  return fmt::format("{}{}", n, last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

/// The words around the parts of a tree, by language and style.
struct Brackets {
  std::string_view open, close;                   ///< around what binds less than its surroundings
  std::string_view fraction, over, end_fraction;  ///< English: numerator first; Japanese: denominator first
  std::string_view power, end_power;              ///< around an exponent of several parts
  std::string_view of;                            ///< between a function and its argument
  std::string_view part, part_where, end_part;    ///< around a value and its condition
  std::string_view cases, end_cases;
  std::string_view list, end_list;
  std::string_view integral, over_variable, from, to, end_integral;
};

constexpr std::array<Brackets, 3> kEnglishBrackets{
    {{"the quantity ",
      " end quantity",
      "the fraction with numerator ",
      " and denominator ",
      " end fraction",
      " to the power of ",
      " end power",
      " of ",
      "the part of ",
      " where ",
      " end part",
      "the cases ",
      " end cases",
      "the list ",
      " end list",
      "the integral of ",
      " with respect to ",
      " from ",
      " up to ",
      " end integral"},
     {"quantity ",  " end",         "fraction ", " over ",    " end fraction",     " to the ",
      " end power", " of ",         "part ",     " where ",   " end part",         "cases ",
      " end cases", "list ",        " end list", "integral ", " with respect to ", " from ",
      " up to ",    " end integral"},
     {"open ",     " close",    "frac ",   " over ",    " end frac", " to ",         " end",
      " ",         "part ",     " where ", " end part", "cases ",    " end cases",   "list ",
      " end list", "integral ", " by ",    " from ",    " up to ",   " end integral"}}};
constexpr std::array<Brackets, 3> kJapaneseBrackets{
    {{"括弧 ",           " 括弧閉じ", "分数 分母 ",    " 分子 ",
      " 分数終わり",     " の ",      " 乗",           " ",
      "部分 ",           " ただし ",  " 部分終わり",   "場合分け ",
      " 場合分け終わり", "リスト ",   " リスト終わり", "積分 ",
      " 変数 ",          " 下端 ",    " 上端 ",        " 積分終わり"},
     {"括弧 ",           " 閉じ",    "分数 ",         " 分の ",
      " 分数終わり",     " の ",     " 乗",           " ",
      "部分 ",           " ただし ", " 部分終わり",   "場合分け ",
      " 場合分け終わり", "リスト ",  " リスト終わり", "積分 ",
      " 変数 ",          " 下端 ",   " 上端 ",        " 積分終わり"},
     {"かっこ ", " とじ", "分数 ",    " 分の ",      " 終わり", " の ",        " 乗",
      " ",       "部分 ", " ただし ", " 部分終わり", "場合 ",   " 場合終わり", "リスト ",
      " 終わり", "積分 ", " 変数 ",   " 下端 ",      " 上端 ",  " 積分終わり"}}};

constexpr bool is_short_form(SpeechStyle style) { return style != SpeechStyle::verbose; }

/// Speaks a tree so that it can be built again from what is heard. An operand is said without brackets where
/// it is one of these: a number, a letter; a coefficient with its letter, "2 x", which is always one product;
/// a function of such an operand; a square or a cube of a number, letter or function.
class Speaker {
 public:
  Speaker(Language language, SpeechStyle style)
      : english_(language == Language::english),
        language_(language),
        style_(style),
        words_((english_ ? kEnglishBrackets : kJapaneseBrackets)[static_cast<std::size_t>(style)]) {}

  std::string spoken(const Expression& e) const {
    const Node& n = *e;
    const auto& a = n.arguments;
    switch (n.kind) {
      case NodeKind::number:
        return n.name.empty() ? number_words(n.value, language_) : n.name;
      case NodeKind::constant:
        if (n.constant == Constant::e) return "e";
        if (n.constant == Constant::pi) return english_ ? "pi" : "パイ";
        return english_ ? "tau" : "タウ";
      case NodeKind::variable:
        return n.variable == Variable::theta && !english_ ? "シータ" : std::string(name_of(n.variable));
      case NodeKind::negate:
        return (english_ ? "minus " : "マイナス ") + operand(a[0], 4, true);
      case NodeKind::add:
        return operand(a[0], 1) + (english_ ? " plus " : " 足す ") + operand(a[1], 2);
      case NodeKind::subtract:
        return operand(a[0], 1) + (english_ ? " minus " : " 引く ") + operand(a[1], 2);
      case NodeKind::multiply:
        if (is_degrees(n)) return raised(a[0]) + (english_ ? " degrees" : " 度");
        if (is_coefficient(n)) return spoken(a[0]) + " " + spoken(a[1]);
        return operand(a[0], 2, true) + (english_ ? " times " : " かける ") + operand(a[1], 3, true);
      case NodeKind::divide:
        return fraction(a[0], a[1]);
      case NodeKind::power:
        return power(a);
      case NodeKind::function:
        return function(n);
    }
    return {};
  }

 private:
  static bool is_plain_number(const Node& n) {
    if (is_named_list(n)) return true;
    return n.kind == NodeKind::number && (n.value >= 0 || !n.name.empty());
  }
  static bool is_named_list(const Node& n) { return is_list(n) && !n.name.empty(); }
  static bool is_atom(const Expression& e) {
    return is_plain_number(*e) || e->kind == NodeKind::constant || e->kind == NodeKind::variable ||
           is_list(*e);
  }
  /// 2 x, 3 pi: heard as one thing.
  static bool is_coefficient(const Node& n) {
    return n.kind == NodeKind::multiply && is_plain_number(*n.arguments[0]) &&
           (n.arguments[1]->kind == NodeKind::variable || n.arguments[1]->kind == NodeKind::constant);
  }
  static bool is_short(const Expression& e) {
    return is_atom(e) || is_coefficient(*e) || (is_degrees(*e) && is_atom(e->arguments[0]));
  }

  [[nodiscard]] std::string fenced(const Expression& e) const {
    return std::string(words_.open) + spoken(e) + std::string(words_.close);
  }

  /// 1: terms of a sum, 2: of a product or behind a minus between two, 3: the second factor, 4: behind a
  /// sign.
  [[nodiscard]] std::string operand(const Expression& e, int least, bool is_factor = false) const {
    // A simple fraction has no words at its ends.
    if (e->kind == NodeKind::divide) return is_factor && is_simple_fraction(*e) ? fenced(e) : spoken(e);
    const int strong = e->kind == NodeKind::negate ? 3 : strength(*e);
    if (least == 3 && is_coefficient(*e)) return fenced(e);
    return strong >= least ? spoken(e) : fenced(e);
  }

  static bool is_simple_fraction(const Node& n) {
    return is_short(n.arguments[0]) && is_atom(n.arguments[1]);
  }

  [[nodiscard]] std::string fraction(const Expression& top, const Expression& bottom) const {
    if (!in_fraction_ && is_short(top) && is_atom(bottom)) {
      return english_ ? spoken(top) + " over " + spoken(bottom) : spoken(bottom) + " 分の " + spoken(top);
    }
    const Speaker inside = within_fraction();
    const std::string first = inside.spoken(english_ ? top : bottom);
    const std::string second = inside.spoken(english_ ? bottom : top);
    return std::string(words_.fraction) + first + std::string(words_.over) + second +
           std::string(words_.end_fraction);
  }

  /// A simple fraction inside another one is said with both ends, too.
  [[nodiscard]] Speaker within_fraction() const {
    Speaker inside = *this;
    inside.in_fraction_ = true;
    return inside;
  }

  [[nodiscard]] std::string raised(const Expression& e) const { return is_atom(e) ? spoken(e) : fenced(e); }

  [[nodiscard]] std::string power(const std::vector<Expression>& a) const {
    const Node& n = *a[1];
    const bool square = n.kind == NodeKind::number && n.value == 2;
    const bool cube = n.kind == NodeKind::number && n.value == 3;
    if ((square || cube) && a[0]->kind == NodeKind::function && has_raised_name(a[0]->function))
      return function_name(a[0]->function) +
             (english_ ? (square ? " squared" : " cubed") : (square ? " 2 乗" : " 3 乗")) +
             argument(a[0]->arguments[0]);
    const std::string base = raised(a[0]);
    if (english_ && square) return base + " squared";
    if (english_ && cube) return base + " cubed";
    const bool whole = n.kind == NodeKind::number || is_atom(a[1]) ||
                       (n.kind == NodeKind::negate && is_atom(n.arguments[0]));
    if (!english_) return base + " の " + (whole ? spoken(a[1]) : fenced(a[1])) + " 乗";
    return base + std::string(words_.power) + spoken(a[1]) + (whole ? "" : std::string(words_.end_power));
  }

  static bool has_raised_name(Function f) {
    return (f >= Function::sin && f <= Function::log2) || f == Function::erf || f == Function::gamma;
  }

  [[nodiscard]] std::string function_name(Function f) const {
    const auto& words = kFunctionWords[static_cast<std::size_t>(f)];
    return std::string(english_ ? words.english : words.japanese);
  }

  /// "of x", "of the quantity x plus 1 end quantity".
  [[nodiscard]] std::string argument(const Expression& e) const {
    const bool chained = english_ && e->kind == NodeKind::function && is_prefix(e->function);
    return std::string(words_.of) + (is_short(e) || chained ? spoken(e) : fenced(e));
  }

  static bool is_prefix(Function f) {
    switch (f) {
      case Function::factorial:
      case Function::min:
      case Function::max:
      case Function::mod:
      case Function::atan2:
      case Function::hypot:
      case Function::root:
      case Function::log_base:
      case Function::where:
      case Function::choose:
      case Function::list:
      case Function::range:
      case Function::integral:
        return false;
      default:
        return true;
    }
  }

  [[nodiscard]] std::string condition(const Node& n) const {
    const auto& a = n.arguments;
    if (n.function == Function::either)
      return condition(*a[0]) + (english_ ? " or " : " または ") + condition(*a[1]);
    if (n.function != Function::both)
      return spoken(a[0]) + comparison_words(comparison_of(n.function), language_) + spoken(a[1]);
    const Node* last = a[0].get();
    while (last->function == Function::both) last = last->arguments[1].get();
    // 0 < x < 2
    if (to_text(last->arguments[1]) == to_text(a[1]->arguments[0]))
      return condition(*a[0]) + comparison_words(comparison_of(a[1]->function), language_) +
             spoken(a[1]->arguments[1]);
    return condition(*a[0]) + comparison_words(Comparison::both, language_) + condition(*a[1]);
  }

  /// "minus x if x is less than 0; otherwise x"
  [[nodiscard]] std::string cases(const Node& n) const {
    const std::string value = spoken(n.arguments[1]);
    const std::string when = condition(*n.arguments[0]);
    std::string one = english_ ? value + " if " + when : when + " のとき " + value;
    if (n.function == Function::where) return one;
    const Node& rest = *n.arguments[2];
    const bool more = rest.kind == NodeKind::function &&
                      (rest.function == Function::choose || rest.function == Function::where);
    if (more) return one + (english_ ? "; " : "、") + cases(rest);
    return one + (english_ ? "; otherwise " : "、その他 ") + spoken(n.arguments[2]);
  }

  /// "the list 1, 2, 3 end list", "the list 1, 3 and so on to 9 end list"
  [[nodiscard]] std::string list(const Node& n) const {
    if (!n.name.empty()) return n.name;
    const bool is_range = n.function == Function::range;
    std::string text(words_.list);
    for (std::size_t i = 0; i < n.arguments.size(); ++i) {
      const bool is_last = i + 1 == n.arguments.size();
      if (is_range && is_last)
        text += english_ ? " and so on to " : " から順に ";
      else if (i > 0)
        text += english_ ? ", " : "、";
      text += spoken(n.arguments[i]);
    }
    return text + (is_range && !english_ ? " まで" : "") + std::string(words_.end_list);
  }

  /// "the integral of t squared with respect to t from 0 up to x end integral"
  [[nodiscard]] std::string integral(const Node& n) const {
    return std::string(words_.integral) + spoken(n.arguments[0]) + std::string(words_.over_variable) +
           spoken(variable(n.variable)) + std::string(words_.from) + spoken(n.arguments[1]) +
           std::string(words_.to) + spoken(n.arguments[2]) + std::string(words_.end_integral);
  }

  [[nodiscard]] std::string function(const Node& n) const {
    const auto& a = n.arguments;
    if (is_list(n)) return list(n);
    if (is_condition(n.function)) return condition(n);
    if (n.function == Function::where)
      return std::string(words_.part) + spoken(a[1]) + std::string(words_.part_where) + condition(*a[0]) +
             std::string(words_.end_part);
    if (n.function == Function::integral) return integral(n);
    if (n.function == Function::choose)
      return std::string(words_.cases) + cases(n) + std::string(words_.end_cases);
    switch (n.function) {
      case Function::factorial:
        return raised(a[0]) + (english_ ? " factorial" : " の階乗");
      case Function::log_base:
        return english_ ? "logarithm to base " + raised(a[0]) + argument(a[1])
                        : "底 " + raised(a[0]) + " の対数" + argument(a[1]);
      case Function::root: {
        const bool whole = a[0]->kind == NodeKind::number && a[0]->value == std::round(a[0]->value) &&
                           a[0]->value >= 0 && a[0]->value < 1000;
        if (!english_) return raised(a[0]) + " 乗根" + argument(a[1]);
        const std::string index =
            whole ? ordinal(static_cast<int>(a[0]->value)) + " root" : "root with index " + raised(a[0]);
        return (is_short_form(style_) ? "" : "the ") + index + argument(a[1]);
      }
      default:
        break;
    }
    std::string name = function_name(n.function);
    if (english_ && !is_short_form(style_) && takes_article(n.function)) name = "the " + name;
    if (a.size() == 1) return name + argument(a[0]);
    std::string list = spoken(a[0]);
    for (std::size_t i = 1; i < a.size(); ++i) list += (english_ ? " and " : " と ") + spoken(a[i]);
    return name + (english_ ? " of " : " ") + list + (english_ ? " end " : " ") + function_name(n.function) +
           (english_ ? "" : " 終わり");
  }

  static bool takes_article(Function f) { return f >= Function::exp && f != Function::gamma; }

  bool english_;
  Language language_;
  SpeechStyle style_;
  Brackets words_;
  bool in_fraction_ = false;
};

}  // namespace

std::string number_words(double v, Language language) {
  if (v < 0) return (language == Language::english ? "minus " : "マイナス") + fmt::format("{}", -v);
  return fmt::format("{}", v);
}

std::string comparison_words(Comparison c, Language language) {
  constexpr std::array<std::string_view, 6> kEnglish{" equals ",          " is less than ", " is at most ",
                                                     " is greater than ", " is at least ",  " and "};
  constexpr std::array<std::string_view, 6> kJapanese{" イコール ", " 小なり ",         " 小なりイコール ",
                                                      " 大なり ",   " 大なりイコール ", " かつ "};
  return std::string((language == Language::english ? kEnglish : kJapanese)[static_cast<std::size_t>(c)]);
}

std::string in_words(const Expression& expression, Language language, SpeechStyle style) {
  return Speaker(language, style).spoken(expression);
}

}  // namespace nazori::functions
