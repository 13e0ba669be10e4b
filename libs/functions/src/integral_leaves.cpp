// SPDX-License-Identifier: Apache-2.0
#include "integral_leaves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace nazori::functions {
namespace {

// A block that needs more leaves has coarse ones. Few are spent beside 0, where there are many blocks, and
// far out, where mostly limits are looked for.
constexpr std::size_t kMostLeaves = 4096;
constexpr std::size_t kMostLeavesNearZero = 512;
constexpr double kNearZero = 1.0 / 16;
constexpr std::size_t kMostLeavesFarOut = 1024;
constexpr double kFarOut = 1024;
// The remainder may be as large as the rounding of the other terms.
constexpr double kTolerance = 1e-16;
constexpr double kCoarse = 1e-6;
constexpr double kNarrow = 0x1p-24;  // of the block
// Nearer to zero the steps between doubles are as large as the numbers: e^(-t^2) at 27.
constexpr double kVanishing = 1e-290;

bool is_usable(const Interval& v) { return !v.is_empty() && v.is_bounded(); }

double low_end(const IntegralLeaf& l) { return l.is_negative ? -l.outer : l.inner; }
double high_end(const IntegralLeaf& l) { return l.is_negative ? -l.inner : l.outer; }

/// How far the integral over the leaf may be off because of its remainder.
double remainder(const IntegralLeaf& l) {
  const double reach = std::max(high_end(l) - l.place, l.place - low_end(l));
  return l.terms[static_cast<std::size_t>(l.order)].width() * std::pow(reach, l.order + 1);
}

/// Fills in the polynomial with the remainder that is the smallest. @return whether there is one.
bool fit(IntegralLeaf& leaf, const Taylor& f) {
  const Interval& range = f.box[0];
  if (!is_usable(range) || range.decoration < Decoration::defined) return false;
  leaf.range = range;
  leaf.is_bad = false;
  const double reach = std::max(high_end(leaf) - leaf.place, leaf.place - low_end(leaf));
  double least = std::numeric_limits<double>::infinity();
  int best = 0;
  double power = reach;
  for (int n = 0; n <= Taylor::kOrder; ++n, power *= reach) {
    const auto k = static_cast<std::size_t>(n);
    // Beside a jump only the range holds.
    if (n > 0 && (!range.is_continuous() || !is_usable(f.place[k - 1]))) break;
    if (!is_usable(f.box[k])) continue;
    const double error = f.box[k].width() / (n + 1) * power;
    if (error < least) least = error, best = n;
  }
  leaf.order = best;
  for (int n = 0; n <= best; ++n) {
    const auto k = static_cast<std::size_t>(n);
    const Interval& c = n == best ? f.box[k] : f.place[k];
    const Interval term = Interval(c.lower, c.upper) / Interval(static_cast<double>(n + 1));
    leaf.terms[k] = term;
  }
  return true;
}

class BlockBuilder {
 public:
  BlockBuilder(const Tape& tape, double inner, double outer)
      : tape_(tape), registers_(tape.size()), inner_(inner), outer_(outer) {
    width_ = std::abs(outer - inner);
    const double reach = std::abs(outer);
    most_ = reach > kFarOut ? kMostLeavesFarOut : reach <= kNearZero ? kMostLeavesNearZero : kMostLeaves;
    narrowest_ = width_ * 0x1p-44;
  }

  std::vector<IntegralLeaf> run() {
    height_ = sampled_height();
    add(std::abs(inner_), std::abs(outer_));
    while (!open_.empty() && done_.size() + open_.size() < most_) {
      const IntegralLeaf leaf = open_.top().second;
      open_.pop();
      const double middle = leaf.inner + (leaf.outer - leaf.inner) / 2;
      add(leaf.inner, middle);
      add(middle, leaf.outer);
    }
    for (; !open_.empty(); open_.pop()) {
      IntegralLeaf leaf = open_.top().second;
      const double width = leaf.outer - leaf.inner;
      leaf.is_coarse = !leaf.is_bad && width > width_ * kNarrow &&
                       remainder(leaf) > kCoarse * leaf.range.magnitude() * width;
      done_.push_back(leaf);
    }
    std::sort(done_.begin(), done_.end(),
              [](const IntegralLeaf& a, const IntegralLeaf& b) { return a.inner < b.inner; });
    return std::move(done_);
  }

 private:
  using Entry = std::pair<double, IntegralLeaf>;
  struct Less {
    bool operator()(const Entry& a, const Entry& b) const { return a.first < b.first; }
  };

  /// The largest of some values: what counts as small is small beside it.
  double sampled_height() {
    double height = 0;
    constexpr int kSamples = 9;
    for (int i = 0; i < kSamples; ++i) {
      const double t = inner_ + (outer_ - inner_) * (i + 0.5) / kSamples;
      const double v = tape_.evaluate_one<double>({&t, 1});
      if (std::isfinite(v)) height = std::max(height, std::abs(v));
    }
    return height;
  }

  Taylor evaluated(const IntegralLeaf& leaf) {
    const Taylor t = Taylor::of_variable({low_end(leaf), high_end(leaf)}, leaf.place);
    tape_.evaluate<Taylor>({&t, 1}, registers_);
    return registers_[tape_.output(0)];
  }

  void add(double inner, double outer) {
    IntegralLeaf leaf;
    leaf.inner = inner;
    leaf.outer = outer;
    leaf.is_negative = outer_ < 0;
    leaf.place = low_end(leaf) + (high_end(leaf) - low_end(leaf)) / 2;
    const Taylor f = evaluated(leaf);
    bool fits = fit(leaf, f);
    // sin(t)/t at 0 can be continued around 0 only.
    for (const double end : {low_end(leaf), high_end(leaf)}) {
      if (fits || !has(f.box[0].cause, Cause::pole)) break;
      leaf.place = end;
      fits = fit(leaf, evaluated(leaf));
    }
    leaf.cause = f.box[0].cause;
    const double width = outer - inner;
    if (!fits) {
      const bool nowhere = f.box[0].decoration == Decoration::undefined;
      if (nowhere || width <= narrowest_)
        done_.push_back(leaf);
      else
        open_.emplace(std::numeric_limits<double>::infinity(), leaf);
      return;
    }
    const double error = remainder(leaf);
    const double fine = std::max(kTolerance * leaf.range.magnitude(), kVanishing) * width;
    // Beside a corner halving goes on until what is left vanishes beside the block. Of a wide leaf that says
    // nothing: over a block e^(t^2) has values that differ by a factor of 10^200.
    const bool vanishes = width <= width_ * kNarrow && error <= height_ * width_ * 0x1p-62;
    if (error <= fine || vanishes || width <= narrowest_)
      done_.push_back(leaf);
    else
      open_.emplace(error, leaf);
  }

  const Tape& tape_;
  std::vector<Taylor> registers_;
  double inner_;
  double outer_;
  double width_ = 0;
  double narrowest_ = 0;
  double height_ = 0;
  std::size_t most_ = 0;
  std::priority_queue<Entry, std::vector<Entry>, Less> open_;
  std::vector<IntegralLeaf> done_;
};

constexpr long double kStep = std::numeric_limits<long double>::epsilon();

IntegralSum sum_of(const Interval& stretch) {
  return {static_cast<long double>(stretch.middle()),
          static_cast<long double>(Rounding<double>::up(stretch.width()))};
}

}  // namespace

long double IntegralLeaf::near(double t) const {
  const long double s = static_cast<long double>(t) - static_cast<long double>(place);
  long double sum = 0;
  for (int n = order; n >= 0; --n) {
    const Interval& c = terms[static_cast<std::size_t>(n)];
    sum = sum * s + (static_cast<long double>(c.lower) + static_cast<long double>(c.upper)) / 2;
  }
  return sum * s;
}

double IntegralLeaf::height_near(double t) const {
  const double s = t - place;
  double sum = 0;
  for (int n = order; n >= 0; --n) sum = sum * s + terms[static_cast<std::size_t>(n)].middle() * (n + 1);
  return sum;
}

Interval IntegralLeaf::enclosed_near(double t) const {
  const Interval s = Interval(t) - Interval(place);
  Interval sum(0.0);
  for (int n = order; n >= 0; --n) sum = sum * s + terms[static_cast<std::size_t>(n)];
  return sum * s;
}

void IntegralSum::add(const IntegralSum& other) {
  centre += other.centre;
  radius = (radius + other.radius + std::abs(centre) * kStep) * (1 + 4 * kStep);
}

IntegralSum IntegralBlock::sum(std::size_t first, std::size_t last) const {
  IntegralSum all;
  const std::size_t n = leaves.size();
  for (first += n, last += n; first < last; first /= 2, last /= 2) {
    if (first % 2 == 1) all.add(tree[first++]);
    if (last % 2 == 1) all.add(tree[--last]);
  }
  return all;
}

IntegralBlock build_block(const Tape& tape, double inner, double outer, int number, PassedLeaves passed) {
  IntegralBlock block;
  block.leaves = BlockBuilder(tape, inner, outer).run();
  const std::size_t n = block.leaves.size();
  block.tree.resize(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    IntegralLeaf& leaf = block.leaves[i];
    leaf.passed = passed;
    leaf.block = number;
    leaf.index = i;
    if (leaf.is_bad) {
      ++passed.bad;
      continue;
    }
    const double sign = leaf.is_negative ? -1 : 1;
    leaf.to_place = sum_of(-leaf.enclosed_near(sign * leaf.inner));
    leaf.to_outer = sum_of(leaf.enclosed_near(sign * leaf.outer));
    block.tree[n + i] = leaf.to_place;
    block.tree[n + i].add(leaf.to_outer);
    if (leaf.is_coarse) ++passed.coarse;
  }
  for (std::size_t i = n; i-- > 1;) {
    block.tree[i] = block.tree[2 * i];
    block.tree[i].add(block.tree[2 * i + 1]);
  }
  block.passed = passed;
  return block;
}

}  // namespace nazori::functions
