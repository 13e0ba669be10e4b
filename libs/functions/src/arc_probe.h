// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "algebra.h"
#include "arcs.h"
#include "nazori/functions/tape.h"
#include "nazori/functions/tracing.h"

namespace nazori::functions {

/// How many places beside a value are tried for a certain sign: at 1e-8 of the span, then each time at eight
/// times the distance.
inline constexpr int kSidesTried = 6;

/// Values and slopes of an arc.
class ArcProbe {
 public:
  explicit ArcProbe(const Arc& arc)
      : tape_(Tape::compile(std::array{improved(arc.x), improved(arc.y)}, std::array{arc.parameter})),
        registers_(tape_.size()),
        enclosures_(tape_.size()) {}

  struct Values {
    double x, y, slope_x, slope_y;
  };
  Values at(double t) {
    tape_.evaluate<Dual<double, 1>>(std::array{Dual<double, 1>(t, 0)}, registers_);
    const auto& x = registers_[tape_.output(0)];
    const auto& y = registers_[tape_.output(1)];
    return {x.value, y.value, x.slopes[0], y.slopes[0]};
  }

  /// Proven bounds of the slope of y.
  Interval slope_y(double t) {
    using D = Dual<Interval, 1>;
    tape_.evaluate<D>(std::array{D(Interval(t), 0)}, enclosures_);
    return enclosures_[tape_.output(1)].slopes[0];
  }

 private:
  Tape tape_;
  std::vector<Dual<double, 1>> registers_;
  std::vector<Dual<Interval, 1>> enclosures_;
};

/// The value, or 0 where its sign may be due to rounding.
inline double beyond_rounding(double value, const Interval& enclosure) {
  return !enclosure.is_empty() && enclosure.is_bounded() && enclosure.contains(0) ? 0.0 : value;
}

/// The argument in (low, high) where `f` changes sign.
template <class F>
double bisect(double low, double high, const F& f) {
  const bool negative = f(low) < 0;
  for (int i = 0; i < 100; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    const double v = f(middle);
    if (v == 0) return middle;
    ((v < 0) == negative ? low : high) = middle;
  }
  const double a = std::abs(f(low));
  const double b = std::abs(f(high));
  return a <= b ? low : high;
}

/// Calls found(t, rising) wherever `f` changes sign along a branch.
template <class F, class Found>
void sign_changes(const std::vector<CurvePoint>& points, const F& f, const Found& found) {
  double last = 0;
  double last_at = 0;
  bool has_last = false;
  int zeros = 0;
  for (const CurvePoint& p : points) {
    const double v = f(p.parameter);
    if (std::isnan(v)) {
      has_last = false;
      continue;
    }
    if (v == 0) {
      ++zeros;
      continue;
    }
    // A run of zeros is a flat piece, not a point.
    if (has_last && (v < 0) != (last < 0) && zeros <= 1 && p.parameter > last_at)
      found(bisect(last_at, p.parameter, f), v > 0);
    last = v;
    last_at = p.parameter;
    has_last = true;
    zeros = 0;
  }
}

}  // namespace nazori::functions
