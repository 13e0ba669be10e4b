// SPDX-License-Identifier: Apache-2.0
#include "roots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "nazori/functions/tape.h"
#include "simplest_between.h"

namespace nazori::functions {
namespace {

constexpr int kMostBoxes = 60'000;
constexpr double kEps = std::numeric_limits<double>::epsilon();

class RootFinder {
 public:
  RootFinder(const Expression& f, Variable v)
      : tape_(Tape::compile(std::array{f}, std::array{v})), values_(tape_.size()), duals_(tape_.size()) {}

  Roots run(double low, double high) {
    range_ = high - low;
    visit(low, high);
    std::sort(found_.roots.begin(), found_.roots.end(),
              [](const Root& a, const Root& b) { return a.at < b.at; });
    // One zero on the border of two pieces shows up in both, a touching one in all boxes that rounding
    // leaves.
    std::vector<Root> distinct;
    for (std::size_t i = 0; i < found_.roots.size();) {
      Root merged = found_.roots[i];
      std::size_t j = i + 1;
      while (j < found_.roots.size() && found_.roots[j].at - found_.roots[j - 1].at < 1e-8 * range_) {
        ++j;
      }
      // Rounding can fake changes of sign close to a touching zero: the values well outside decide.
      const double before = value(merged.at - 1e-6 * range_);
      const double after = value(found_.roots[j - 1].at + 1e-6 * range_);
      if (!merged.crosses || before * after > 0) merged = touching(merged.at, found_.roots[j - 1].at);
      distinct.push_back(merged);
      i = j;
    }
    found_.roots = std::move(distinct);
    return std::move(found_);
  }

 private:
  using D = Dual<Interval, 1>;

  double value(double x) {
    tape_.evaluate<double>(std::array{x}, values_);
    return values_[tape_.output(0)];
  }
  D enclose(double low, double high) {
    tape_.evaluate<D>(std::array{D(Interval(low, high), 0)}, duals_);
    return duals_[tape_.output(0)];
  }

  void visit(double low, double high) {
    if (++boxes_ > kMostBoxes) {
      if (boxes_ == kMostBoxes + 1) ++found_.undecided;
      return;
    }
    const D f = enclose(low, high);
    if (f.value.is_empty() || !f.value.contains(0)) return;
    if (f.value.is_point() && f.value.decoration >= Decoration::defined) {
      found_.has_ranges = true;
      return;
    }
    if (f.value.is_continuous() && !f.slopes[0].is_empty() && !f.slopes[0].contains(0)) {
      single(low, high);
      return;
    }
    if (high - low <= std::max(1e-13 * range_, 8 * kEps * std::max(std::abs(low), std::abs(high)))) {
      // A touching zero cannot be proven, only not be told from zero.
      const double x = low + (high - low) / 2;
      if (f.value.is_continuous() &&
          enclose(x - 2 * kEps * std::abs(x), x + 2 * kEps * std::abs(x)).value.contains(0)) {
        const double before = value(low - 1e-7 * range_);
        const double after = value(high + 1e-7 * range_);
        found_.roots.push_back({x, before * after < 0});
      } else if (!add_at_jump(low, high)) {
        ++found_.undecided;
      }
      return;
    }
    const double middle = low + (high - low) * 0.49731;
    visit(low, middle);
    visit(middle, high);
  }

  /// At a jump the function can be zero at the jump itself: x - floor(x). Only a round number can be told.
  bool add_at_jump(double low, double high) {
    const double x = simplest_between(low, high);
    const Interval at = enclose(x, x).value;
    const bool is_zero = at.is_point() && at.lower == 0 && at.decoration >= Decoration::defined;
    if (is_zero) found_.roots.push_back({x, true});
    // Somewhere between the sides but at no number of this piece: a jump over zero.
    return is_zero || (!at.is_empty() && !at.contains(0) && at.decoration >= Decoration::defined);
  }

  double slope(double x) {
    slopes_.resize(tape_.size());
    tape_.evaluate<Dual<double, 1>>(std::array{Dual<double, 1>(x, 0)}, slopes_);
    return slopes_[tape_.output(0)].slopes[0];
  }

  /// A touching zero lies where the slope changes sign, which is much sharper than the values.
  Root touching(double first, double last) {
    double low = first - 1e-6 * range_;
    double high = last + 1e-6 * range_;
    const bool crosses = value(low) * value(high) < 0;
    const double before = slope(low);
    if (!(before * slope(high) < 0)) return {(first + last) / 2, crosses};
    for (int i = 0; i < 80; ++i) {
      const double middle = low + (high - low) / 2;
      const double s = slope(middle);
      if (s == 0) return {middle, crosses};
      (s * before > 0 ? low : high) = middle;
    }
    return {low + (high - low) / 2, crosses};
  }

  void single(double low, double high) {
    double a = value(low);
    const double b = value(high);
    if (a == 0 || b == 0) {
      found_.roots.push_back({a == 0 ? low : high, true});
      return;
    }
    if (!std::isfinite(a) || !std::isfinite(b) || (a < 0) == (b < 0)) return;
    while (true) {
      const double middle = low + (high - low) / 2;
      if (middle <= low || middle >= high) break;
      const double m = value(middle);
      if (m == 0) {
        low = high = middle;
        break;
      }
      if ((m < 0) == (a < 0)) {
        low = middle;
        a = m;
      } else {
        high = middle;
      }
    }
    found_.roots.push_back({std::abs(value(low)) <= std::abs(value(high)) ? low : high, true});
  }

  Tape tape_;
  std::vector<double> values_;
  std::vector<D> duals_;
  std::vector<Dual<double, 1>> slopes_;
  Roots found_;
  double range_ = 1;
  int boxes_ = 0;
};

}  // namespace

Roots find_roots(const Expression& f, Variable v, double low, double high) {
  return RootFinder(f, v).run(low, high);
}

}  // namespace nazori::functions
