// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/interval.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <random>

#include "nazori/functions/expression.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {
namespace {

/// A number of MPFR, 140 bits: the independent reference.
class Precise {
 public:
  Precise() { mpfr_init2(v_, 140); }
  explicit Precise(double v) : Precise() { mpfr_set_d(v_, v, MPFR_RNDN); }
  Precise(const Precise& o) : Precise() { mpfr_set(v_, o.v_, MPFR_RNDN); }
  Precise& operator=(const Precise& o) {
    mpfr_set(v_, o.v_, MPFR_RNDN);
    return *this;
  }
  ~Precise() { mpfr_clear(v_); }
  mpfr_ptr get() { return v_; }
  [[nodiscard]] mpfr_srcptr get() const { return v_; }
  [[nodiscard]] bool is_number() const { return mpfr_number_p(v_) != 0; }
  [[nodiscard]] int sign() const { return mpfr_sgn(v_); }
  [[nodiscard]] bool is_whole() const { return mpfr_integer_p(v_) != 0; }

 private:
  mpfr_t v_;
};

using Value = std::optional<Precise>;

Value function_of(Function f, const Precise& a) {
  Precise r;
  const auto in = [&a](double low, double high) {
    return mpfr_cmp_d(a.get(), low) >= 0 && mpfr_cmp_d(a.get(), high) <= 0;
  };
  switch (f) {
    case Function::sin:
      mpfr_sin(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::cos:
      mpfr_cos(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::tan:
      mpfr_tan(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::asin:
      if (!in(-1, 1)) return std::nullopt;
      mpfr_asin(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::acos:
      if (!in(-1, 1)) return std::nullopt;
      mpfr_acos(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::atan:
      mpfr_atan(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::sinh:
      mpfr_sinh(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::cosh:
      mpfr_cosh(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::tanh:
      mpfr_tanh(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::asinh:
      mpfr_asinh(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::ln:
      if (a.sign() <= 0) return std::nullopt;
      mpfr_log(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::sqrt:
      if (a.sign() < 0) return std::nullopt;
      mpfr_sqrt(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::cbrt:
      mpfr_cbrt(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::abs:
      mpfr_abs(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::floor:
      mpfr_floor(r.get(), a.get());
      break;
    case Function::ceil:
      mpfr_ceil(r.get(), a.get());
      break;
    case Function::sign:
      r = Precise(a.sign());
      break;
    case Function::exp:
      mpfr_exp(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::erf:
      mpfr_erf(r.get(), a.get(), MPFR_RNDN);
      break;
    case Function::gamma:
      if (a.sign() <= 0 && a.is_whole()) return std::nullopt;
      mpfr_gamma(r.get(), a.get(), MPFR_RNDN);
      break;
    default:
      return std::nullopt;
  }
  if (!r.is_number()) return std::nullopt;
  return r;
}

Value value_of(const Expression& e, double x, double y);

Value power_of(const Expression& base_of, const Expression& exponent_of, double x, double y) {
  const Value base = value_of(base_of, x, y);
  const Value exponent = value_of(exponent_of, x, y);
  if (!base || !exponent) return std::nullopt;
  Precise r;
  if (const auto q = rational_value(exponent_of)) {
    if (base->sign() == 0 && q->p < 0) return std::nullopt;
    if (q->q == 1) {
      mpfr_pow_si(r.get(), base->get(), q->p, MPFR_RNDN);
    } else {
      if (base->sign() < 0 && q->q % 2 == 0) return std::nullopt;
      mpfr_rootn_ui(r.get(), base->get(), static_cast<unsigned long>(q->q), MPFR_RNDN);
      mpfr_pow_si(r.get(), r.get(), q->p, MPFR_RNDN);
    }
  } else {
    if ((base->sign() < 0 && !exponent->is_whole()) || (base->sign() == 0 && exponent->sign() <= 0))
      return std::nullopt;
    mpfr_pow(r.get(), base->get(), exponent->get(), MPFR_RNDN);
  }
  if (!r.is_number()) return std::nullopt;
  return r;
}

Value value_of(const Expression& e, double x, double y) {
  const auto& a = e->arguments;
  switch (e->kind) {
    case NodeKind::number:
      return Precise(e->value);
    case NodeKind::variable:
      return Precise(e->variable == Variable::x ? x : y);
    case NodeKind::constant: {
      Precise r;
      if (e->constant == Constant::pi) {
        mpfr_const_pi(r.get(), MPFR_RNDN);
      } else {
        mpfr_set_ui(r.get(), 1, MPFR_RNDN);
        mpfr_exp(r.get(), r.get(), MPFR_RNDN);
      }
      return r;
    }
    case NodeKind::function: {
      const Value inner = value_of(a[0], x, y);
      if (!inner) return std::nullopt;
      if (e->function == Function::min || e->function == Function::max) {
        const Value other = value_of(a[1], x, y);
        if (!other) return std::nullopt;
        const bool first = (mpfr_cmp(inner->get(), other->get()) < 0) == (e->function == Function::min);
        return first ? inner : other;
      }
      return function_of(e->function, *inner);
    }
    case NodeKind::negate: {
      Value v = value_of(a[0], x, y);
      if (v) mpfr_neg(v->get(), v->get(), MPFR_RNDN);
      return v;
    }
    case NodeKind::power:
      return power_of(a[0], a[1], x, y);
    default:
      break;
  }
  const Value left = value_of(a[0], x, y);
  const Value right = value_of(a[1], x, y);
  if (!left || !right) return std::nullopt;
  Precise r;
  switch (e->kind) {
    case NodeKind::add:
      mpfr_add(r.get(), left->get(), right->get(), MPFR_RNDN);
      break;
    case NodeKind::subtract:
      mpfr_sub(r.get(), left->get(), right->get(), MPFR_RNDN);
      break;
    case NodeKind::multiply:
      mpfr_mul(r.get(), left->get(), right->get(), MPFR_RNDN);
      break;
    default:
      if (right->sign() == 0) return std::nullopt;
      mpfr_div(r.get(), left->get(), right->get(), MPFR_RNDN);
      break;
  }
  if (!r.is_number()) return std::nullopt;
  return r;
}

/// Random trees over x and y.
class Grower {
 public:
  explicit Grower(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  Expression grow(int depth) {
    constexpr std::array kFunctions{Function::sin,  Function::cos,   Function::tan,   Function::asin,
                                    Function::acos, Function::atan,  Function::sinh,  Function::cosh,
                                    Function::tanh, Function::asinh, Function::ln,    Function::sqrt,
                                    Function::cbrt, Function::abs,   Function::floor, Function::ceil,
                                    Function::sign, Function::exp,   Function::erf,   Function::gamma};
    constexpr std::array kBinary{NodeKind::add, NodeKind::subtract, NodeKind::multiply, NodeKind::divide};
    if (depth == 0 || below(6) == 0) {
      switch (below(5)) {
        case 0:
          return number(below(9) - 4);
        case 1:
          return number(std::ldexp(below(64) - 32, -3));
        case 2:
          return constant(below(2) == 0 ? Constant::pi : Constant::e);
        default:
          return variable(below(2) == 0 ? Variable::x : Variable::y);
      }
    }
    const int kind = below(10);
    if (kind < 4)
      return binary(kBinary[static_cast<std::size_t>(below(4))], grow(depth - 1), grow(depth - 1));
    if (kind == 4) return binary(NodeKind::power, grow(depth - 1), number(below(9) - 3));
    if (kind == 5) {
      return binary(NodeKind::power, grow(depth - 1),
                    binary(NodeKind::divide, number(1 + below(5)), number(2 + below(4))));
    }
    if (kind == 6)
      return below(2) == 0 ? binary(NodeKind::power, grow(depth - 1), grow(depth - 1))
                           : negate(grow(depth - 1));
    if (kind == 7)
      return call(below(2) == 0 ? Function::min : Function::max, {grow(depth - 1), grow(depth - 1)});
    return call(kFunctions[static_cast<std::size_t>(below(static_cast<int>(kFunctions.size())))],
                {grow(depth - 1)});
  }

 private:
  std::mt19937 random_;
};

bool contains(const Interval& i, const Precise& v) {
  return mpfr_cmp_d(v.get(), i.lower) >= 0 && mpfr_cmp_d(v.get(), i.upper) <= 0;
}

// MPFR with 140 bits loses its own last places when large numbers cancel: then nothing can be checked.
bool is_clear(const Interval& i, const Precise& v) {
  const double size = std::abs(mpfr_get_d(v.get(), MPFR_RNDN));
  return size < 1e200 && i.magnitude() < 1e250;
}

/// A quarter of a million points each, so that the four run in parallel.
class IntervalOfRandomExpressions : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, IntervalOfRandomExpressions, testing::Values(20050401U, 2U, 3U, 4U));

TEST_P(IntervalOfRandomExpressions, ContainsTheTrueValueAtAQuarterOfAMillionPoints) {
  Grower grow(GetParam());
  constexpr std::array kVariables{Variable::x, Variable::y};
  std::int64_t points = 0;
  std::int64_t decided = 0;
  while (points < 250'000) {
    const Expression e = grow.grow(1 + grow.below(4));
    const Tape tape = Tape::compile(std::array{e}, kVariables);
    for (int box = 0; box < 4; ++box) {
      const double size = std::ldexp(1.0, -grow.below(24));
      const double x = grow.between(-6, 6);
      const double y = grow.between(-6, 6);
      const Interval ix(x, x + size);
      const Interval iy(y, y + size);
      const Interval f = tape.evaluate_one<Interval>(std::array{ix, iy});
      for (int k = 0; k < 25; ++k, ++points) {
        const double px = k == 0 ? x : std::min(ix.upper, x + grow.between(0, size));
        const double py = k == 0 ? y : std::min(iy.upper, y + grow.between(0, size));
        const Value v = value_of(e, px, py);
        if (v && is_clear(f, *v)) {
          ++decided;
          ASSERT_TRUE(!f.is_empty() && contains(f, *v))
              << to_text(e) << " at " << px << ", " << py << ": " << mpfr_get_d(v->get(), MPFR_RNDN)
              << " not in [" << f.lower << ", " << f.upper << "]";
        }
        if (!v && f.decoration >= Decoration::defined && f.is_bounded())
          ADD_FAILURE() << to_text(e) << " is undefined at " << px << ", " << py;
      }
    }
  }
  EXPECT_GT(decided, points / 3);
}

TEST(Interval, ProvesContinuityOnlyWhereThereIsNoPoleOrJump) {
  EXPECT_FALSE((Interval(1) / Interval(-1, 1)).is_continuous());
  EXPECT_TRUE((Interval(1) / Interval(0.5, 1)).is_continuous());
  EXPECT_FALSE(tan(Interval(1.5, 1.6)).is_continuous());
  EXPECT_TRUE(tan(Interval(1.6, 4.7)).is_continuous());
  EXPECT_EQ(floor(Interval(0.5, 1.5)).decoration, Decoration::defined);
  EXPECT_TRUE(floor(Interval(0.25, 0.75)).is_continuous());
  EXPECT_EQ(sqrt(Interval(-1, 1)).decoration, Decoration::partial);
  EXPECT_TRUE(sqrt(Interval(-2, -1)).is_empty());
  EXPECT_TRUE(has((Interval(1) / Interval(-1, 1)).cause, Cause::pole));
  EXPECT_TRUE(has(exp(Interval(700, 800)).cause, Cause::overflow));
}

TEST(Interval, ZeroToAComputedPowerOfZeroIsUndefinedAndToAPositiveOneIsNot) {
  const Interval around_zero(-1, 1);
  EXPECT_EQ(power(around_zero, Interval(0, 0)).decoration, Decoration::partial);
  EXPECT_EQ(power(Interval(-2, 0), Interval(0, 0)).decoration, Decoration::partial);
  EXPECT_GE(power(around_zero, Interval(2, 2)).decoration, Decoration::defined);
  EXPECT_GE(power(Interval(-2, -1), Interval(0, 0)).decoration, Decoration::defined);
}

TEST(Interval, RationalPowersOfVeryLargeAndVerySmallNumbersAreEnclosedAndClosely) {
  // The nearest double to p/q is off by up to half a last place, and the power by several hundred for it.
  double worst = 0;
  for (int p = 1; p <= 40; ++p) {
    for (int q = 2; q <= 40; ++q) {
      if (std::gcd(p, q) != 1) continue;
      const int digits = std::min(290, 290 * q / p);
      for (const double base : {std::pow(10.0, digits), std::pow(10.0, -digits)}) {
        Precise power(base);
        mpfr_rootn_ui(power.get(), power.get(), static_cast<unsigned long>(q), MPFR_RNDN);
        mpfr_pow_si(power.get(), power.get(), p, MPFR_RNDN);
        const Interval found = power_rational(Interval(base), p, q);
        ASSERT_TRUE(contains(found, power)) << base << "^(" << p << '/' << q << ')';
        worst = std::max(worst, found.width() / found.upper);
      }
    }
  }
  // 290 ln 10 = 668 half epsilons on both sides, and a few last places of the power itself.
  EXPECT_LT(worst, (668 + 12) * std::numeric_limits<double>::epsilon());
}

TEST(Interval, RoundsToTheOutsideByNoMoreThanALastPlace) {
  const Interval third = Interval(1) / Interval(3);
  EXPECT_LT(third.lower, third.upper);
  EXPECT_EQ(std::nextafter(third.lower, 1.0), third.upper);
  const Interval half = Interval(1) / Interval(2);
  EXPECT_TRUE(half.is_point());
  EXPECT_TRUE((Interval(0.1) - Interval(0.1)).is_point());
  EXPECT_EQ((Interval(0) * Interval::entire(Decoration::continuous, Cause::none)).upper, 0.0);
}

TEST(Interval, LongDoublesReachWhereDoublesOverflow) {
  const LongInterval big = exp(LongInterval(900.0L, 901.0L));
  EXPECT_TRUE(big.is_bounded());
  EXPECT_GT(big.lower, 1e308L);
}

}  // namespace
}  // namespace nazori::functions
