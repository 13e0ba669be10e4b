// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "nazori/functions/dual.h"
#include "nazori/functions/expression.h"
#include "nazori/functions/interval.h"

namespace nazori::functions {

/// Expressions compiled to a flat list of steps in which equal parts are computed once, for millions of
/// evaluations.
///
/// One tape works with every kind of number: double and long double (NaN where undefined), decorated
/// intervals, duals of all of these and Taylor coefficients. Immutable; thread-safe if each thread uses its
/// own registers.
class Tape {
 public:
  /// @param outputs  the expressions, over `inputs` only; other variables count as undefined.
  /// @param inputs   the order in which evaluate() takes the variables.
  [[nodiscard]] static Tape compile(std::span<const Expression> outputs, std::span<const Variable> inputs);

  /// Registers that evaluate() needs.
  [[nodiscard]] std::size_t size() const { return steps_.size(); }
  [[nodiscard]] std::size_t output_count() const { return outputs_.size(); }
  /// Whether a step can overflow the format (exp, powers, products of them): long double may help.
  [[nodiscard]] bool can_overflow() const { return can_overflow_; }

  /// Evaluates all outputs; output(i) returns its index in `registers`.
  /// @param inputs     as many as given to compile().
  /// @param registers  at least size() of them; overwritten.
  template <class T>
  void evaluate(std::span<const T> inputs, std::span<T> registers) const;
  [[nodiscard]] std::size_t output(std::size_t i) const { return outputs_[i]; }

  /// The first output. Allocates; for single evaluations.
  template <class T>
  [[nodiscard]] T evaluate_one(std::span<const T> inputs) const {
    std::vector<T> registers(size());
    evaluate<T>(inputs, registers);
    return registers[output(0)];
  }

  enum class Op : std::uint8_t {
    constant,
    input,
    undefined,
    negate,
    add,
    subtract,
    multiply,
    divide,
    square,
    power_integer,
    power_rational,
    power,
    exp,
    log,
    log2,
    log10,
    sqrt,
    abs,
    sin,
    cos,
    tan,
    asin,
    acos,
    atan,
    atan2,
    sinh,
    cosh,
    tanh,
    asinh,
    acosh,
    atanh,
    erf,
    gamma,
    floor,
    ceil,
    sign,
    min,
    max,
    at_least_zero,
    above_zero,
    where,
    choose,
    integral
  };

 private:
  struct Step {
    Op op = Op::constant;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    int p = 0;  ///< of an integral: the index of its antiderivative
    int q = 1;
    double value = 0;  ///< value of a constant, with the bounds of the typed number
    double lower = 0;
    double upper = 0;
    std::uint32_t c = 0;  ///< third operand, of choose
    friend bool operator==(const Step&, const Step&) = default;
  };
  class Builder;

  std::vector<Step> steps_;
  std::vector<std::uint32_t> outputs_;
  std::vector<std::shared_ptr<const Antiderivative>> integrals_;
  bool can_overflow_ = false;
};

}  // namespace nazori::functions
