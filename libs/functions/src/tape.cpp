// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/tape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <type_traits>

#include "antiderivative.h"
#include "taylor.h"

namespace nazori::functions {
namespace {

using Op = Tape::Op;

std::optional<Op> op_of(Function f) {
  switch (f) {
    case Function::sin:
      return Op::sin;
    case Function::cos:
      return Op::cos;
    case Function::tan:
      return Op::tan;
    case Function::asin:
      return Op::asin;
    case Function::acos:
      return Op::acos;
    case Function::atan:
      return Op::atan;
    case Function::atan2:
      return Op::atan2;
    case Function::sinh:
      return Op::sinh;
    case Function::cosh:
      return Op::cosh;
    case Function::tanh:
      return Op::tanh;
    case Function::asinh:
      return Op::asinh;
    case Function::acosh:
      return Op::acosh;
    case Function::atanh:
      return Op::atanh;
    case Function::ln:
      return Op::log;
    case Function::log2:
      return Op::log2;
    case Function::log10:
      return Op::log10;
    case Function::sqrt:
      return Op::sqrt;
    case Function::abs:
      return Op::abs;
    case Function::sign:
      return Op::sign;
    case Function::floor:
      return Op::floor;
    case Function::ceil:
      return Op::ceil;
    case Function::gamma:
      return Op::gamma;
    case Function::erf:
      return Op::erf;
    case Function::min:
      return Op::min;
    case Function::max:
      return Op::max;
    default:
      return std::nullopt;
  }
}

template <class T>
struct ConstantOf {
  static T make(double value, double /*lower*/, double /*upper*/) { return static_cast<T>(value); }
};
template <class R>
struct ConstantOf<BasicInterval<R>> {
  static BasicInterval<R> make(double /*value*/, double lower, double upper) {
    return {static_cast<R>(lower), static_cast<R>(upper)};
  }
};
template <class T, int N>
struct ConstantOf<Dual<T, N>> {
  static Dual<T, N> make(double value, double lower, double upper) {
    return Dual<T, N>(ConstantOf<T>::make(value, lower, upper));
  }
};

template <class T>
struct Undefined {
  static T make() { return std::numeric_limits<T>::quiet_NaN(); }
};
template <class R>
struct Undefined<BasicInterval<R>> {
  static BasicInterval<R> make() { return BasicInterval<R>::empty(); }
};
template <>
struct ConstantOf<Taylor> {
  static Taylor make(double /*value*/, double lower, double upper) { return {Interval(lower, upper)}; }
};
template <>
struct Undefined<Taylor> {
  static Taylor make() { return {Interval::empty()}; }
};
template <class T, int N>
struct Undefined<Dual<T, N>> {
  static Dual<T, N> make() { return Dual<T, N>(Undefined<T>::make()); }
};

}  // namespace

/// Collects steps, each different one once.
class Tape::Builder {
 public:
  Builder(Tape& tape, std::span<const Variable> inputs) : tape_(tape), inputs_(inputs) {}

  std::uint32_t add(const Expression& e) {
    const Node& n = *e;
    switch (n.kind) {
      case NodeKind::number:
        return number(n.value, n.exact);
      case NodeKind::constant:
        return constant(n.constant);
      case NodeKind::variable:
        return input(n.variable);
      case NodeKind::negate:
        return step(Op::negate, add(n.arguments[0]));
      case NodeKind::add:
        return step(Op::add, add(n.arguments[0]), add(n.arguments[1]));
      case NodeKind::subtract:
        return step(Op::subtract, add(n.arguments[0]), add(n.arguments[1]));
      case NodeKind::multiply: {
        const std::uint32_t a = add(n.arguments[0]);
        const std::uint32_t b = add(n.arguments[1]);
        return a == b ? step(Op::square, a) : step(Op::multiply, a, b);
      }
      case NodeKind::divide:
        return step(Op::divide, add(n.arguments[0]), add(n.arguments[1]));
      case NodeKind::power:
        return power(n);
      case NodeKind::function:
        break;
    }
    // A list has no single value.
    if (is_list(n.function)) return push({Op::undefined, 0, 0, 0, 1, 0, 0, 0, 0});
    if (n.function == Function::integral) return integral(n);
    if (n.function >= Function::less) return cases(n);
    const auto op = op_of(n.function);
    if (!op) return add(reduced(e));
    const std::uint32_t a = add(n.arguments[0]);
    return n.arguments.size() == 1 ? step(*op, a) : step(*op, a, add(n.arguments[1]));
  }

 private:
  std::uint32_t push(const Step& s) {
    const auto same = std::find(tape_.steps_.begin(), tape_.steps_.end(), s);
    if (same != tape_.steps_.end()) return static_cast<std::uint32_t>(same - tape_.steps_.begin());
    tape_.steps_.push_back(s);
    return static_cast<std::uint32_t>(tape_.steps_.size() - 1);
  }

  std::uint32_t step(Op op, std::uint32_t a, std::uint32_t b = 0, int p = 0, int q = 1) {
    if (op == Op::exp || op == Op::power || op == Op::power_integer || op == Op::power_rational ||
        op == Op::sinh || op == Op::cosh || op == Op::gamma) {
      tape_.can_overflow_ = true;
    }
    return push({op, a, b, p, q, 0, 0, 0, 0});
  }

  std::uint32_t number(double v, bool exact) {
    if (exact) return push({Op::constant, 0, 0, 0, 1, v, v, v, 0});
    return push({Op::constant, 0, 0, 0, 1, v, Rounding<double>::down(v), Rounding<double>::up(v), 0});
  }

  std::uint32_t constant(Constant c) {
    switch (c) {
      case Constant::pi:
        return number(std::numbers::pi, false);
      case Constant::e:
        return number(std::numbers::e, false);
      case Constant::tau:
        return number(2 * std::numbers::pi, false);
    }
    return number(0, true);
  }

  std::uint32_t input(Variable v) {
    const auto found = std::find(inputs_.begin(), inputs_.end(), v);
    if (found == inputs_.end()) return push({Op::undefined, 0, 0, 0, 1, 0, 0, 0, 0});
    return push({Op::input, static_cast<std::uint32_t>(found - inputs_.begin()), 0, 0, 1, 0, 0, 0, 0});
  }

  std::uint32_t integral(const Node& n) {
    auto& all = tape_.integrals_;
    auto known = std::find(all.begin(), all.end(), n.antiderivative);
    if (known == all.end()) known = all.insert(all.end(), n.antiderivative);
    return step(Op::integral, add(n.arguments[1]), add(n.arguments[2]),
                static_cast<int>(known - all.begin()));
  }

  /// Conditions, and values that depend on one.
  std::uint32_t cases(const Node& n) {
    const std::uint32_t a = add(n.arguments[0]);
    const std::uint32_t b = add(n.arguments[1]);
    switch (n.function) {
      case Function::less:
        return step(Op::above_zero, step(Op::subtract, b, a));
      case Function::less_equal:
        return step(Op::at_least_zero, step(Op::subtract, b, a));
      case Function::greater:
        return step(Op::above_zero, step(Op::subtract, a, b));
      case Function::greater_equal:
        return step(Op::at_least_zero, step(Op::subtract, a, b));
      case Function::equal:
        return step(Op::min, step(Op::at_least_zero, step(Op::subtract, a, b)),
                    step(Op::at_least_zero, step(Op::subtract, b, a)));
      case Function::both:
        return step(Op::min, a, b);
      case Function::either:
        return step(Op::max, a, b);
      case Function::where:
        return step(Op::where, a, b);
      default:
        return push({Op::choose, a, b, 0, 1, 0, 0, 0, add(n.arguments[2])});
    }
  }

  std::uint32_t power(const Node& n) {
    const Expression& base = n.arguments[0];
    if (const auto r = rational_value(n.arguments[1]); r && std::abs(r->p) < 1'000'000 && r->q < 1'000'000) {
      const std::uint32_t a = add(base);
      const int p = static_cast<int>(r->p);
      const int q = static_cast<int>(r->q);
      if (q == 1 && p == 1) return a;
      if (q == 1 && p == 2) return step(Op::square, a);
      if (q == 1) return step(Op::power_integer, a, 0, p);
      if (q == 2 && p == 1) return step(Op::sqrt, a);
      return step(Op::power_rational, a, 0, p, q);
    }
    if (base->kind == NodeKind::constant && base->constant == Constant::e)
      return step(Op::exp, add(n.arguments[1]));
    return step(Op::power, add(base), add(n.arguments[1]));
  }

  Tape& tape_;
  std::span<const Variable> inputs_;
};

Tape Tape::compile(std::span<const Expression> outputs, std::span<const Variable> inputs) {
  Tape tape;
  Builder builder(tape, inputs);
  for (const Expression& e : outputs) tape.outputs_.push_back(builder.add(e));
  return tape;
}

template <class T>
void Tape::evaluate(std::span<const T> inputs, std::span<T> registers) const {
  using std::abs, std::acos, std::acosh, std::asin, std::asinh, std::atan, std::atan2, std::atanh, std::ceil,
      std::cos, std::cosh, std::erf, std::exp, std::floor, std::log, std::log10, std::log2, std::sin,
      std::sinh, std::sqrt, std::tan, std::tanh;
  T* const r = registers.data();
  const auto undefined_at_zero = [](const T& a, const T& b) -> T {
    if constexpr (std::is_floating_point_v<T>) {
      return b == 0 ? std::numeric_limits<T>::quiet_NaN() : a / b;
    } else {
      return a / b;
    }
  };
  const auto logarithm = [](const T& a, auto f) -> T {
    if constexpr (std::is_floating_point_v<T>) {
      return a <= 0 ? std::numeric_limits<T>::quiet_NaN() : f(a);
    } else {
      return f(a);
    }
  };
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& s = steps_[i];
    const T& a = r[s.a];
    const T& b = r[s.b];
    switch (s.op) {
      case Op::constant:
        r[i] = ConstantOf<T>::make(s.value, s.lower, s.upper);
        break;
      case Op::input:
        r[i] = inputs[s.a];
        break;
      case Op::undefined:
        r[i] = Undefined<T>::make();
        break;
      case Op::negate:
        r[i] = -a;
        break;
      case Op::add:
        r[i] = a + b;
        break;
      case Op::subtract:
        r[i] = a - b;
        break;
      case Op::multiply:
        r[i] = a * b;
        break;
      case Op::divide:
        r[i] = undefined_at_zero(a, b);
        break;
      case Op::square:
        r[i] = square(a);
        break;
      case Op::power_integer:
        r[i] = power_integer(a, s.p);
        break;
      case Op::power_rational:
        r[i] = power_rational(a, s.p, s.q);
        break;
      case Op::power:
        r[i] = power(a, b);
        break;
      case Op::exp:
        r[i] = exp(a);
        break;
      case Op::log:
        r[i] = logarithm(a, [](const T& v) -> T { return log(v); });
        break;
      case Op::log2:
        r[i] = logarithm(a, [](const T& v) -> T { return log2(v); });
        break;
      case Op::log10:
        r[i] = logarithm(a, [](const T& v) -> T { return log10(v); });
        break;
      case Op::sqrt:
        r[i] = sqrt(a);
        break;
      case Op::abs:
        r[i] = abs(a);
        break;
      case Op::sin:
        r[i] = sin(a);
        break;
      case Op::cos:
        r[i] = cos(a);
        break;
      case Op::tan:
        r[i] = tan(a);
        break;
      case Op::asin:
        r[i] = asin(a);
        break;
      case Op::acos:
        r[i] = acos(a);
        break;
      case Op::atan:
        r[i] = atan(a);
        break;
      case Op::atan2:
        r[i] = atan2(a, b);
        break;
      case Op::sinh:
        r[i] = sinh(a);
        break;
      case Op::cosh:
        r[i] = cosh(a);
        break;
      case Op::tanh:
        r[i] = tanh(a);
        break;
      case Op::asinh:
        r[i] = asinh(a);
        break;
      case Op::acosh:
        r[i] = acosh(a);
        break;
      case Op::atanh:
        r[i] = atanh(a);
        break;
      case Op::erf:
        r[i] = erf(a);
        break;
      case Op::gamma:
        r[i] = gamma(a);
        break;
      case Op::floor:
        r[i] = floor(a);
        break;
      case Op::ceil:
        r[i] = ceil(a);
        break;
      case Op::sign:
        r[i] = sign(a);
        break;
      case Op::min:
        r[i] = min(a, b);
        break;
      case Op::max:
        r[i] = max(a, b);
        break;
      case Op::at_least_zero:
        r[i] = at_least_zero(a);
        break;
      case Op::above_zero:
        r[i] = above_zero(a);
        break;
      case Op::where:
        r[i] = where(a, b);
        break;
      case Op::choose:
        r[i] = choose(a, b, r[s.c]);
        break;
      case Op::integral:
        r[i] = integral(*integrals_[static_cast<std::size_t>(s.p)], a, b);
        break;
    }
  }
}

template void Tape::evaluate<double>(std::span<const double>, std::span<double>) const;
template void Tape::evaluate<long double>(std::span<const long double>, std::span<long double>) const;
template void Tape::evaluate<Interval>(std::span<const Interval>, std::span<Interval>) const;
template void Tape::evaluate<LongInterval>(std::span<const LongInterval>, std::span<LongInterval>) const;
template void Tape::evaluate<Dual<double, 1>>(std::span<const Dual<double, 1>>,
                                              std::span<Dual<double, 1>>) const;
template void Tape::evaluate<Dual<double, 2>>(std::span<const Dual<double, 2>>,
                                              std::span<Dual<double, 2>>) const;
template void Tape::evaluate<Dual<Interval, 1>>(std::span<const Dual<Interval, 1>>,
                                                std::span<Dual<Interval, 1>>) const;
template void Tape::evaluate<Dual<Interval, 2>>(std::span<const Dual<Interval, 2>>,
                                                std::span<Dual<Interval, 2>>) const;
template void Tape::evaluate<Dual<LongInterval, 1>>(std::span<const Dual<LongInterval, 1>>,
                                                    std::span<Dual<LongInterval, 1>>) const;
template void Tape::evaluate<Taylor>(std::span<const Taylor>, std::span<Taylor>) const;

}  // namespace nazori::functions
