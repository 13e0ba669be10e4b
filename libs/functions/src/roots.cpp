// SPDX-License-Identifier: Apache-2.0
#include "roots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "nazori/functions/tape.h"
#include "simplest_between.h"

namespace nazori::functions {
namespace {

// A piece this narrow, as a share of the range, in which this many boxes remain undecided counts as one
// point: around a zero of third or higher order all values are smaller than rounding errors.
constexpr double kClusterWidth = 1e-6;
constexpr int kMostBoxesOfCluster = 400;
constexpr double kEps = std::numeric_limits<double>::epsilon();

class RootFinder {
 public:
  RootFinder(const Expression& f, Variable v, int most_boxes)
      : most_boxes_(most_boxes),
        tape_(Tape::compile(std::array{f}, std::array{v})),
        values_(tape_.size()),
        duals_(tape_.size()) {}

  Roots run(double low, double high) {
    range_ = high - low;
    visit(low, high);
    judge_clusters();
    std::sort(found_.roots.begin(), found_.roots.end(),
              [](const Root& a, const Root& b) { return a.at < b.at; });
    // One zero on the border of two pieces appears in both, a touching one in all boxes that rounding leaves
    // undecided.
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

  struct Cluster {
    double low, high;
  };

  void visit_narrow(double low, double high) {
    const auto before = found_;
    in_cluster_ = true;
    boxes_of_cluster_ = 0;
    visit(low, high);
    in_cluster_ = false;
    if (boxes_of_cluster_ <= kMostBoxesOfCluster) return;
    found_ = before;
    clusters_.push_back({low, high});
  }

  void judge_clusters() {
    for (std::size_t i = 0; i < clusters_.size();) {
      Cluster c = clusters_[i++];
      for (; i < clusters_.size() && clusters_[i].low - c.high < kClusterWidth * range_; ++i)
        c.high = clusters_[i].high;
      const double margin = kClusterWidth * range_;
      const bool crosses = value(c.low - margin) * value(c.high + margin) < 0;
      double x = roundest_zero(crosses ? flattest(c.low, c.high) : touching(c.low, c.high).at, margin);
      // Of cos(x) - 1 + x^2/2 slopes are rounding errors, too: the whole piece is one point.
      if (!is_zero_at(x)) x = roundest_zero(c.low + (c.high - c.low) / 2, (c.high - c.low) / 2 + margin);
      if (is_zero_at(x)) {
        found_.roots.push_back({x, crosses});
      } else {
        ++found_.undecided;
      }
    }
  }

  bool is_zero_at(double x) {
    const double around = 2 * kEps * std::abs(x);
    const Interval f = enclose(x - around, x + around).value;
    return f.is_continuous() && f.contains(0);
  }

  /// Where the slope is least: of a zero of odd order known to some eight digits only.
  double flattest(double low, double high) {
    constexpr double kGolden = 0.6180339887498949;
    for (int i = 0; i < 60; ++i) {
      const double a = high - kGolden * (high - low);
      const double b = low + kGolden * (high - low);
      (std::abs(slope(a)) < std::abs(slope(b)) ? high : low) =
          std::abs(slope(a)) < std::abs(slope(b)) ? b : a;
    }
    return low + (high - low) / 2;
  }

  /// The roundest number or multiple of pi nearby that cannot be distinguished from a zero; `x` if there is
  /// none. What is round in one unit has many decimals in the others: 2 pi, and not 6.28319.
  double roundest_zero(double x, double reach) {
    constexpr double kTwelfth = 1.0 / 12;
    constexpr std::array<double, 4> kUnits{1.0, std::numbers::pi, kTwelfth, std::numbers::pi * kTwelfth};
    std::array<RoundNumber, kUnits.size()> candidates;
    for (std::size_t i = 0; i < kUnits.size(); ++i) {
      candidates[i] = roundest_between((x - reach) / kUnits[i], (x + reach) / kUnits[i]);
      candidates[i].value *= kUnits[i];
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const RoundNumber& a, const RoundNumber& b) { return a.decimals < b.decimals; });
    for (const RoundNumber& c : candidates) {
      if (is_zero_at(c.value)) return c.value;
    }
    return x;
  }

  void visit(double low, double high) {
    if (in_cluster_) {
      if (++boxes_of_cluster_ > kMostBoxesOfCluster) return;
    } else if (high - low <= kClusterWidth * range_) {
      return visit_narrow(low, high);
    }
    if (++boxes_ > most_boxes_) {
      if (boxes_ == most_boxes_ + 1) ++found_.undecided;
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
      // A touching zero cannot be proven; it can only be indistinguishable from zero.
      const double x = roundest_zero(low + (high - low) / 2, high - low);
      if (is_zero_at(x)) {
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

  /// At a jump the function can be zero at the jump itself: x - floor(x). Only a round number can be
  /// recognised.
  bool add_at_jump(double low, double high) {
    const double x = simplest_between(low, high);
    const Interval at = enclose(x, x).value;
    const bool is_zero = at.is_point() && at.lower == 0 && at.decoration >= Decoration::defined;
    if (is_zero) found_.roots.push_back({x, true});
    // Between the values of both sides, but not at any number of this piece: a jump over zero.
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

  int most_boxes_;
  Tape tape_;
  std::vector<double> values_;
  std::vector<D> duals_;
  std::vector<Dual<double, 1>> slopes_;
  Roots found_;
  double range_ = 1;
  int boxes_ = 0;
  bool in_cluster_ = false;
  int boxes_of_cluster_ = 0;
  std::vector<Cluster> clusters_;
};

}  // namespace

Roots find_roots(const Expression& f, Variable v, double low, double high, int most_boxes) {
  return RootFinder(f, v, most_boxes).run(low, high);
}

}  // namespace nazori::functions
