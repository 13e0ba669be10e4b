// SPDX-License-Identifier: Apache-2.0
#include "plane_system.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>

#include "exact_name.h"
#include "nazori/functions/dual.h"
#include "nazori/functions/points.h"
#include "nazori/functions/tape.h"
#include "simplest_between.h"

namespace nazori::functions {
namespace {

// Boxes of this share of the rectangle that are still undecided are parts of a degenerate zero.
constexpr double kFinest = 1e-7;
// The same where the number of boxes is used up.
constexpr double kUnfinished = 2e-5;
constexpr double kEps = std::numeric_limits<double>::epsilon();

class SystemSolver {
 public:
  SystemSolver(std::span<const Expression> functions, const std::array<Variable, 2>& variables,
               const std::array<double, 2>& low, const std::array<double, 2>& high, int most)
      : tape_(Tape::compile(functions, variables)),
        count_(functions.size()),
        low_(low),
        range_{high[0] - low[0], high[1] - low[1]},
        most_(most),
        duals_(tape_.size()),
        values_(tape_.size()),
        intervals_(tape_.size()) {}

  SystemRoots run() {
    // Off round numbers, so that zeros do not lie on the borders of boxes.
    open_.push_back({{low_[0] - 0.00137 * range_[0], low_[1] - 0.00213 * range_[1]},
                     {low_[0] + 1.00171 * range_[0], low_[1] + 1.00193 * range_[1]}});
    // Large boxes first: a point where all is degenerate does not keep the others from being found.
    for (; !open_.empty() && boxes_ < most_; ++boxes_) {
      const Box box = open_.front();
      open_.pop_front();
      visit(box.low, box.high);
    }
    for (const Box& box : open_) leave_unfinished(box);
    judge_clusters();
    return std::move(out_);
  }

 private:
  using Point = std::array<double, 2>;
  using D = Dual<Interval, 2>;
  using G = Dual<double, 2>;
  struct Box {
    Point low, high;
  };

  /// Small boxes that are left over surround a degenerate zero.
  void leave_unfinished(const Box& box) {
    const bool small = box.high[0] - box.low[0] <= kUnfinished * range_[0] &&
                       box.high[1] - box.low[1] <= kUnfinished * range_[1];
    if (small) {
      fine_.push_back(box);
    } else {
      out_.complete = false;
    }
  }

  void visit(const Point& low, const Point& high) {
    const std::array sides{Interval(low[0], high[0]), Interval(low[1], high[1])};
    tape_.evaluate<D>(std::array{D(sides[0], 0), D(sides[1], 1)}, duals_);
    for (std::size_t i = 0; i < count_; ++i) {
      const Interval& f = duals_[tape_.output(i)].value;
      if (f.is_empty() || !f.contains(0)) return;
    }
    const Point middle{low[0] + (high[0] - low[0]) / 2, low[1] + (high[1] - low[1]) / 2};
    const Point half{Rounding<double>::up((high[0] - low[0]) / 2),
                     Rounding<double>::up((high[1] - low[1]) / 2)};
    if (excluded(middle, half)) return;
    const bool fine = high[0] - low[0] <= kFinest * range_[0] && high[1] - low[1] <= kFinest * range_[1];
    switch (krawczyk(middle, half)) {
      case Test::none:
        return;
      case Test::one:
        polish(middle, half);
        return;
      case Test::unknown:
        break;
    }
    if (fine) {
      fine_.push_back({low, high});
      return;
    }
    const std::size_t axis = (high[0] - low[0]) / range_[0] >= (high[1] - low[1]) / range_[1] ? 0 : 1;
    const double cut = low[axis] + (high[axis] - low[axis]) * 0.49731;
    Point upper = high;
    upper[axis] = cut;
    Point lower = low;
    lower[axis] = cut;
    open_.push_back({low, upper});
    open_.push_back({lower, high});
  }

  /// By the mean value form, from the derivatives in duals_.
  bool excluded(const Point& middle, const Point& half) {
    tape_.evaluate<Interval>(std::array{Interval(middle[0]), Interval(middle[1])}, intervals_);
    for (std::size_t i = 0; i < count_; ++i) {
      const D& f = duals_[tape_.output(i)];
      const Interval& centre = intervals_[tape_.output(i)];
      if (!f.value.is_continuous() || !f.slopes[0].is_bounded() || !f.slopes[1].is_bounded() ||
          centre.is_empty() || !centre.is_bounded())
        continue;
      const Interval range =
          centre + f.slopes[0] * Interval(-half[0], half[0]) + f.slopes[1] * Interval(-half[1], half[1]);
      if (!range.contains(0)) return true;
    }
    return false;
  }

  enum class Test { none, one, unknown };

  Test krawczyk(const Point& middle, const Point& half) {
    const D& f = duals_[tape_.output(0)];
    const D& g = duals_[tape_.output(1)];
    if (!f.value.is_continuous() || !g.value.is_continuous()) return Test::unknown;
    for (const Interval* s : {&f.slopes[0], &f.slopes[1], &g.slopes[0], &g.slopes[1]}) {
      if (s->is_empty() || !s->is_bounded()) return Test::unknown;
    }
    // The inverse of the derivative in the middle of its enclosure.
    const double a = f.slopes[0].middle();
    const double b = f.slopes[1].middle();
    const double c = g.slopes[0].middle();
    const double d = g.slopes[1].middle();
    const double det = a * d - b * c;
    if (!(std::abs(det) > 1e-12 * (std::abs(a * d) + std::abs(b * c))) || !std::isfinite(1 / det))
      return Test::unknown;
    const std::array<std::array<double, 2>, 2> inverse{{{d / det, -b / det}, {-c / det, a / det}}};
    const Interval& fm = intervals_[tape_.output(0)];
    const Interval& gm = intervals_[tape_.output(1)];
    const std::array<Interval, 2> side{Interval(-half[0], half[0]), Interval(-half[1], half[1])};
    bool inside = true;
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval p(inverse[i][0]);
      const Interval q(inverse[i][1]);
      Interval move = Interval(0.0) - (p * fm + q * gm);
      for (std::size_t j = 0; j < 2; ++j) {
        const Interval identity(i == j ? 1.0 : 0.0);
        move = move + (identity - (p * f.slopes[j] + q * g.slopes[j])) * side[j];
      }
      if (move.is_empty() || !move.is_bounded()) return Test::unknown;
      if (move.lower > half[i] || move.upper < -half[i]) return Test::none;
      inside = inside && move.lower > -half[i] && move.upper < half[i];
    }
    (void)middle;
    return inside ? Test::one : Test::unknown;
  }

  [[nodiscard]] std::optional<Point> newton_step(const Point& p) {
    tape_.evaluate<G>(std::array{G(p[0], 0), G(p[1], 1)}, gradients());
    const G& f = gradients_[tape_.output(0)];
    const G& g = gradients_[tape_.output(1)];
    const double det = f.slopes[0] * g.slopes[1] - f.slopes[1] * g.slopes[0];
    const Point step{(f.value * g.slopes[1] - g.value * f.slopes[1]) / det,
                     (g.value * f.slopes[0] - f.value * g.slopes[0]) / det};
    if (!std::isfinite(step[0] + step[1])) return std::nullopt;
    return step;
  }

  std::span<G> gradients() {
    gradients_.resize(tape_.size());
    return gradients_;
  }

  void polish(const Point& middle, const Point& half) {
    Point p = middle;
    for (int i = 0; i < 40; ++i) {
      const auto step = newton_step(p);
      if (!step) break;
      for (std::size_t k = 0; k < 2; ++k) p[k] -= (*step)[k];
      if (std::hypot((*step)[0], (*step)[1]) < 1e-16 * (1 + std::hypot(p[0], p[1]))) break;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      if (!(std::abs(p[k] - middle[k]) <= 1.01 * half[k])) p[k] = middle[k];
    }
    // The other functions only have to vanish at this point.
    if (count_ > 2 && !vanishes(p)) return;
    add({p[0], p[1], true});
  }

  void add(const SystemRoot& root) {
    for (const SystemRoot& r : out_.roots) {
      if (std::abs(r.a - root.a) < 1e-9 * range_[0] && std::abs(r.b - root.b) < 1e-9 * range_[1]) return;
    }
    out_.roots.push_back(root);
  }

  /// Whether rounding leaves zero possible for every function.
  bool vanishes(const Point& p) {
    std::array<Interval, 2> around;
    for (std::size_t k = 0; k < 2; ++k) {
      const double hair = 8 * kEps * std::max(std::abs(p[k]), range_[k]);
      around[k] = Interval(p[k] - hair, p[k] + hair);
    }
    tape_.evaluate<Interval>(around, intervals_);
    for (std::size_t i = 0; i < count_; ++i) {
      const Interval& f = intervals_[tape_.output(i)];
      if (f.is_empty() || !f.contains(0)) return false;
    }
    return true;
  }

  void judge_clusters() {
    // Boxes that touch belong together.
    std::vector<std::size_t> group(fine_.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto root = [&group](std::size_t i) {
      while (group[i] != i) i = group[i] = group[group[i]];
      return i;
    };
    std::vector<std::size_t> order(fine_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return fine_[i].low[0] < fine_[j].low[0]; });
    const double share = open_.empty() ? 4 * kFinest : 2 * kUnfinished;
    const Point reach{share * range_[0], share * range_[1]};
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Box& p = fine_[order[i]];
      for (std::size_t j = i + 1; j < order.size() && fine_[order[j]].low[0] <= p.high[0] + reach[0]; ++j) {
        const Box& q = fine_[order[j]];
        if (q.low[1] <= p.high[1] + reach[1] && p.low[1] <= q.high[1] + reach[1])
          group[root(order[i])] = root(order[j]);
      }
    }
    std::vector<std::optional<Box>> whole(fine_.size());
    for (std::size_t i = 0; i < fine_.size(); ++i) {
      auto& w = whole[root(i)];
      if (!w) w = fine_[i];
      for (std::size_t k = 0; k < 2; ++k) {
        w->low[k] = std::min(w->low[k], fine_[i].low[k]);
        w->high[k] = std::max(w->high[k], fine_[i].high[k]);
      }
    }
    for (const auto& w : whole) {
      if (w) judge(*w);
    }
  }

  /// One point of a group of boxes: the roundest one at which all functions vanish.
  void judge(const Box& box) {
    for (std::size_t k = 0; k < 2; ++k) {
      // A chain of boxes along a curve that both functions have in common is no point. Around a point where
      // the gradient vanishes to a high order it is longer.
      if (box.high[k] - box.low[k] > (count_ > 2 ? 2e-2 : 2e-4) * range_[k]) return;
    }
    std::array<std::vector<double>, 2> candidates;
    for (std::size_t k = 0; k < 2; ++k) {
      const double middle = box.low[k] + (box.high[k] - box.low[k]) / 2;
      const double half = (box.high[k] - box.low[k]) / 2 + 2 * kFinest * range_[k];
      candidates[k].push_back(simplest_between(middle - half, middle + half));
      for (const double tolerance : {1e-10, 1e-8, 1e-7, 1e-6}) {
        if (const auto named = exact_value_near(middle, std::min(tolerance, half)))
          candidates[k].push_back(*named);
      }
      candidates[k].push_back(middle);
    }
    for (const double a : candidates[0]) {
      for (const double b : candidates[1]) {
        if (!vanishes({a, b})) continue;
        add({a, b, false});
        return;
      }
    }
    Point p{candidates[0].back(), candidates[1].back()};
    const Point start = p;
    for (int i = 0; i < 60; ++i) {
      const auto step = newton_step(p);
      if (!step) break;
      const Point next{p[0] - (*step)[0], p[1] - (*step)[1]};
      const auto strays = [&](std::size_t k) {
        return std::abs(next[k] - start[k]) > std::max(1e-4 * range_[k], box.high[k] - box.low[k]);
      };
      if (strays(0) || strays(1)) break;
      p = next;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      if (const auto named = exact_value_near(p[k], 1e-7))
        candidates[k] = {*named, p[k]};
      else
        candidates[k] = {p[k]};
    }
    for (const double a : candidates[0]) {
      for (const double b : candidates[1]) {
        if (!vanishes({a, b})) continue;
        add({a, b, false});
        return;
      }
    }
    if (small_at(p, box)) add({p[0], p[1], false});
  }

  /// Whether all functions are far smaller at `p` than they are beside the box.
  bool small_at(const Point& p, const Box& box) {
    const auto sizes = [&](const Point& q) {
      tape_.evaluate<double>(std::array{q[0], q[1]}, values_);
      std::vector<double> all(count_);
      for (std::size_t i = 0; i < count_; ++i) all[i] = std::abs(values_[tape_.output(i)]);
      return all;
    };
    const std::vector<double> here = sizes(p);
    std::vector<double> beside(count_, 0.0);
    for (const double du : {-1e-3, 1e-3}) {
      for (const double dv : {-1e-3, 1e-3}) {
        const std::vector<double> there = sizes({box.low[0] + du * range_[0], box.low[1] + dv * range_[1]});
        for (std::size_t i = 0; i < count_; ++i)
          beside[i] = std::max(beside[i], std::isfinite(there[i]) ? there[i] : 0);
      }
    }
    for (std::size_t i = 0; i < count_; ++i) {
      if (!(here[i] <= 1e-9 * beside[i])) return false;
    }
    return true;
  }

  Tape tape_;
  std::size_t count_;
  Point low_;
  Point range_;
  int most_;
  int boxes_ = 0;
  std::vector<D> duals_;
  std::vector<double> values_;
  std::vector<Interval> intervals_;
  std::vector<G> gradients_;
  std::deque<Box> open_;
  std::vector<Box> fine_;
  SystemRoots out_;
};

}  // namespace

SystemRoots solve_system(std::span<const Expression> functions, const std::array<Variable, 2>& variables,
                         const std::array<double, 2>& low, const std::array<double, 2>& high,
                         int most_boxes) {
  return SystemSolver(functions, variables, low, high, most_boxes).run();
}

}  // namespace nazori::functions
