// SPDX-License-Identifier: Apache-2.0
// Spoken forms can be told apart: different trees never sound alike, in any language and style.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "nazori/functions/plot.h"

namespace nazori::functions {
namespace {

/// Trees as parse() makes them: numbers are not negative.
class RandomTrees {
 public:
  explicit RandomTrees(unsigned seed) : random_(seed) {}

  Expression tree(int depth) {
    const int kind = depth == 0 ? below(5) : below(24);
    const auto deeper = [&] { return tree(depth - 1 - below(2) < 0 ? 0 : depth - 1 - below(2)); };
    switch (kind) {
      case 0:
        return number(below(5));
      case 1:
        return variable(Variable::x);
      case 2:
        return variable(Variable::y);
      case 3:
        return constant(below(2) == 0 ? Constant::pi : Constant::e);
      case 4:
        return below(2) == 0 ? parameter("a", -2, true) : number(1);
      case 20:
      case 21:
        return list();
      case 15:
        return negate(deeper());
      case 16:
        return degrees(deeper());
      case 17:
        return call(Function::where, {condition(), deeper()});
      case 18:
      case 19:
        return call(Function::choose, {condition(), deeper(), deeper()});
      case 22:
      case 23:
        return integral(deeper(), below(2) == 0 ? Variable::t : Variable::x, deeper(), deeper());
      case 5:
      case 6:
        return binary(NodeKind::add, deeper(), deeper());
      case 7:
        return binary(NodeKind::subtract, deeper(), deeper());
      case 8:
      case 9:
        return binary(NodeKind::multiply, deeper(), deeper());
      case 10:
      case 11:
        return binary(NodeKind::divide, deeper(), deeper());
      case 12:
        return binary(NodeKind::power, deeper(), below(2) == 0 ? number(2 + below(3)) : deeper());
      default:
        return function(deeper(), deeper());
    }
  }

  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  Expression comparison() {
    constexpr std::array kSigns{Function::less, Function::less_equal, Function::greater,
                                Function::greater_equal, Function::equal};
    return call(kSigns[static_cast<std::size_t>(below(5))], {tree(1), tree(1)});
  }

 private:
  /// [1, x], [2...3], [1, 2...3]: never a list in a list.
  Expression list() {
    std::vector<Expression> elements;
    const int count = 1 + below(3);
    for (int i = 0; i < count; ++i) elements.push_back(tree(0));
    if (below(2) == 0 || count == 1) return call(Function::list, std::move(elements));
    return call(Function::range, std::move(elements));
  }

  /// "or" of chains joined by "and", as it is parsed.
  Expression condition() {
    const auto all = [this] {
      const Expression one = comparison();
      return below(3) == 0 ? call(Function::both, {one, comparison()}) : one;
    };
    const Expression first = all();
    return below(4) == 0 ? call(Function::either, {first, all()}) : first;
  }

  Expression function(const Expression& a, const Expression& b) {
    constexpr std::array kOfOne{Function::sin,  Function::cos, Function::tan,       Function::ln,
                                Function::sqrt, Function::abs, Function::factorial, Function::gamma,
                                Function::cbrt, Function::exp, Function::asinh,     Function::floor};
    constexpr std::array kOfTwo{Function::min,  Function::max,   Function::mod,
                                Function::root, Function::atan2, Function::log_base};
    if (below(4) == 0) return call(kOfTwo[static_cast<std::size_t>(below(6))], {a, b});
    return call(kOfOne[static_cast<std::size_t>(below(12))], {a});
  }

  std::mt19937 random_;
};

constexpr std::array kStyles{SpeechStyle::verbose, SpeechStyle::brief, SpeechStyle::superbrief};
constexpr std::array kLanguages{Language::english, Language::japanese};

/// The same tree with one part changed: the pairs that are most easily confused.
Expression changed(const Expression& e, RandomTrees& random) {
  const bool is_value = e->kind != NodeKind::function || !is_condition(e->function);
  // A condition stays one: only parse() makes these trees.
  if (e->arguments.empty() || (is_value && random.below(4) == 0)) return random.tree(1);
  if (!is_value && e->function <= Function::equal && random.below(4) == 0) return random.comparison();
  Node n = *e;
  if (n.arguments.size() == 2 && random.below(3) == 0) {
    // (a b) c for a (b c), and the like.
    const Expression& left = n.arguments[0];
    if (left->arguments.size() == 2 && left->kind != NodeKind::function && n.kind != NodeKind::function)
      return binary(left->kind, left->arguments[0], binary(n.kind, left->arguments[1], n.arguments[1]));
  }
  if (n.kind == NodeKind::power && n.arguments[0]->kind == NodeKind::function &&
      n.arguments[0]->arguments.size() == 1)
    return call(n.arguments[0]->function,
                {binary(NodeKind::power, n.arguments[0]->arguments[0], n.arguments[1])});
  if (is_integral(n) && random.below(4) == 0) {
    n.variable = n.variable == Variable::x ? Variable::t : Variable::x;
    return std::make_shared<const Node>(std::move(n));
  }
  Expression& part =
      n.arguments[static_cast<std::size_t>(random.below(static_cast<int>(n.arguments.size())))];
  part = changed(part, random);
  return std::make_shared<const Node>(std::move(n));
}

TEST(SpokenForms, TenThousandPairsOfDifferentTreesSoundDifferent) {
  RandomTrees random(20'261'124);
  int pairs = 0;
  while (pairs < 10'000) {
    const Expression a = random.tree(4);
    const Expression b = pairs % 2 == 0 ? changed(a, random) : random.tree(4);
    if (to_text(a) == to_text(b)) continue;
    ++pairs;
    for (const Language language : kLanguages) {
      for (const SpeechStyle style : kStyles)
        ASSERT_NE(in_words(a, language, style), in_words(b, language, style))
            << to_text(a) << "  and  " << to_text(b);
    }
  }
}

TEST(SpokenForms, NoTwoOfAllSmallTreesSoundAlike) {
  RandomTrees random(42);
  for (const Language language : kLanguages) {
    for (const SpeechStyle style : kStyles) {
      std::map<std::string, std::string> heard;
      for (int i = 0; i < 30'000; ++i) {
        const Expression e = random.tree(1 + i % 3);
        const std::string text = to_text(e);
        const auto [place, is_new] = heard.emplace(in_words(e, language, style), text);
        ASSERT_EQ(place->second, text) << place->first;
      }
    }
  }
}

TEST(SpokenForms, TheStylesDifferInLength) {
  const auto plot = parse("y = (x+1)^2/(x-1) + sin(x+1)");
  ASSERT_TRUE(plot);
  EXPECT_EQ(in_words(*plot, Language::english, SpeechStyle::verbose),
            "y equals the fraction with numerator the quantity x plus 1 end quantity squared and denominator "
            "x minus 1 "
            "end fraction plus sine of the quantity x plus 1 end quantity");
  EXPECT_EQ(in_words(*plot, Language::english, SpeechStyle::brief),
            "y equals fraction quantity x plus 1 end squared over x minus 1 end fraction plus sine of "
            "quantity x plus 1 "
            "end");
  EXPECT_EQ(
      in_words(*plot, Language::english, SpeechStyle::superbrief),
      "y equals frac open x plus 1 close squared over x minus 1 end frac plus sine open x plus 1 close");
  EXPECT_EQ(
      in_words(*plot, Language::japanese, SpeechStyle::brief),
      "y イコール 分数 x 引く 1 分の 括弧 x 足す 1 閉じ の 2 乗 分数終わり 足す サイン 括弧 x 足す 1 閉じ");
}

}  // namespace
}  // namespace nazori::functions
