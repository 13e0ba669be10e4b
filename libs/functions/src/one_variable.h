// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "algebra.h"
#include "arc_probe.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {

/// A function of one variable, compiled once. Not for several threads: it has registers.
class OneVariable {
 public:
  OneVariable() = default;
  OneVariable(const Expression& e, Variable v)
      : expression_(e ? improved(e) : nullptr),
        is_parameter_(e && e->kind == NodeKind::variable && e->variable == v) {
    if (!expression_) return;
    tape_ = Tape::compile(std::array{expression_}, std::array{v});
    values_.resize(tape_.size());
    intervals_.resize(tape_.size());
    if (tape_.can_overflow()) long_values_.resize(tape_.size());
  }

  /// The derivative of an expression that has none in closed form.
  static OneVariable slope_of(const Expression& e, Variable v) {
    OneVariable f(e, v);
    f.is_parameter_ = false;
    f.is_slope_ = true;
    f.expression_ = nullptr;
    f.duals_.resize(f.tape_.size());
    f.interval_duals_.resize(f.tape_.size());
    return f;
  }

  /// The form that is evaluated; null of slope_of().
  [[nodiscard]] const Expression& expression() const { return expression_; }
  /// Whether the function is the variable itself.
  [[nodiscard]] bool is_parameter() const { return is_parameter_; }

  [[nodiscard]] double value(double t) const {
    if (is_slope_) {
      tape_.evaluate<Dual<double, 1>>(std::array{Dual<double, 1>(t, 0)}, duals_);
      return duals_[tape_.output(0)].slopes[0];
    }
    tape_.evaluate<double>(std::array{t}, values_);
    return values_[tape_.output(0)];
  }
  [[nodiscard]] long double long_value(long double t) const {
    long_values_.resize(tape_.size());
    tape_.evaluate<long double>(std::array{t}, long_values_);
    return long_values_[tape_.output(0)];
  }
  [[nodiscard]] Interval range(double low, double high) const {
    if (is_slope_) {
      tape_.evaluate<Dual<Interval, 1>>(std::array{Dual<Interval, 1>(Interval(low, high), 0)},
                                        interval_duals_);
      return interval_duals_[tape_.output(0)].slopes[0];
    }
    tape_.evaluate<Interval>(std::array{Interval(low, high)}, intervals_);
    return intervals_[tape_.output(0)];
  }
  /// The value, or 0 where its sign may be due to rounding.
  [[nodiscard]] double certain_value(double t) const {
    // Near the smallest numbers nothing is left of the digits: x e^(1/x) left of 0.
    constexpr double kVanishing = 1e-280;
    const double v = value(t);
    if (std::abs(v) < kVanishing) return 0;
    return std::isnan(v) ? v : beyond_rounding(v, range(t, t));
  }

 private:
  Expression expression_;
  bool is_parameter_ = false;
  bool is_slope_ = false;
  Tape tape_;
  mutable std::vector<double> values_;
  mutable std::vector<long double> long_values_;
  mutable std::vector<Interval> intervals_;
  mutable std::vector<Dual<double, 1>> duals_;
  mutable std::vector<Dual<Interval, 1>> interval_duals_;
};

}  // namespace nazori::functions
