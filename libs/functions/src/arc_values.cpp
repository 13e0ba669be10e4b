// SPDX-License-Identifier: Apache-2.0
// The values of an arc and the intervals that enclose them: what an ArcTracer decides by.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "arc_tracer.h"

namespace nazori::functions {
namespace {

Interval narrowed(const Interval& i) { return i; }
Interval narrowed(const LongInterval& i) {
  constexpr long double kMost = std::numeric_limits<double>::max();
  const auto low = static_cast<double>(std::clamp(i.lower, -kMost, kMost));
  const auto high = static_cast<double>(std::clamp(i.upper, -kMost, kMost));
  if (i.is_empty()) return Interval::empty(i.cause);
  return {std::isinf(i.lower) ? -Rounding<double>::kInf : Rounding<double>::down(low),
          std::isinf(i.upper) ? Rounding<double>::kInf : Rounding<double>::up(high), i.decoration, i.cause};
}

Interval scaled(Interval i, double origin, double scale) {
  if (i.is_empty()) return i;
  return {(i.lower - origin) * scale, (i.upper - origin) * scale, i.decoration, i.cause};
}

}  // namespace

ArcTracer::Sample ArcTracer::sample(double t) {
  tape_.evaluate<double>(std::array{t}, values_);
  double x = values_[tape_.output(0)];
  double y = values_[tape_.output(1)];
  if (tape_.can_overflow() && !(std::isfinite(x) && std::isfinite(y))) {
    tape_.evaluate<long double>(std::array{static_cast<long double>(t)}, long_values_);
    x = static_cast<double>(long_values_[tape_.output(0)]);
    y = static_cast<double>(long_values_[tape_.output(1)]);
  }
  return {t, out_.window.u(x), out_.window.v(y)};
}

template <class R>
ArcTracer::Box ArcTracer::enclose_with(double from, double to,
                                       std::vector<Dual<BasicInterval<R>, 1>>& registers) {
  using D = Dual<BasicInterval<R>, 1>;
  tape_.evaluate<D>(std::array{D(BasicInterval<R>(static_cast<R>(from), static_cast<R>(to)), 0)}, registers);
  const D& x = registers[tape_.output(0)];
  const D& y = registers[tape_.output(1)];
  return {scaled(narrowed(x.value), out_.window.x0, scale_[0]),
          scaled(narrowed(y.value), out_.window.y0, scale_[1]), scaled(narrowed(x.slopes[0]), 0, scale_[0]),
          scaled(narrowed(y.slopes[0]), 0, scale_[1])};
}

ArcTracer::Box ArcTracer::enclose(double from, double to) {
  Box box = enclose_with<double>(from, to, duals_);
  if (tape_.can_overflow() && has(box.cause(), Cause::overflow) && !is_outside(box.u, box.v))
    box = enclose_with<long double>(from, to, long_duals_);
  return box;
}

/// The same for a single parameter, without slopes.
ArcTracer::PointBox ArcTracer::enclose_point(double t) {
  tape_.evaluate<Interval>(std::array{Interval(t)}, intervals_);
  const Interval& x = intervals_[tape_.output(0)];
  const Interval& y = intervals_[tape_.output(1)];
  const bool overflows = tape_.can_overflow() && has(x.cause | y.cause, Cause::overflow);
  if (overflows) {
    const Box box = enclose(t, t);
    return {box.u, box.v};
  }
  return {scaled(x, out_.window.x0, scale_[0]), scaled(y, out_.window.y0, scale_[1])};
}

/// Whether the sample is not moved visibly by rounding: near removable gaps, (1 - cos x)/x^2, it is. Outside
/// the window it only has to be certainly outside.
bool ArcTracer::is_reliable(const Sample& s) {
  if (!s.exists()) return true;
  const PointBox box = enclose_point(s.t);
  if (box.u.is_empty() || box.v.is_empty()) return false;
  if (std::max(box.u.width(), box.v.width()) <= 4 * tolerance_) return true;
  return !is_inside(s) && is_outside(box.u, box.v);
}

/// The range across a narrow piece, by the mean value theorem where that is sharper.
Interval ArcTracer::by_mean_value(const Sample& a, const Sample& b, const Box& box, bool upright) {
  const Interval& range = upright ? box.v : box.u;
  const Interval& slope = upright ? box.slope_v : box.slope_u;
  if (!slope.is_bounded()) return range;
  const double half = Rounding<double>::up((b.t - a.t) / 2);
  const double middle = a.t + (b.t - a.t) / 2;
  const PointBox centre = enclose_point(middle);
  const Interval& c = upright ? centre.v : centre.u;
  if (!c.is_bounded()) return range;
  const Interval sharper = c + slope * Interval(-half, half);
  return {std::max(range.lower, sharper.lower), std::min(range.upper, sharper.upper), range.decoration,
          range.cause};
}

}  // namespace nazori::functions
