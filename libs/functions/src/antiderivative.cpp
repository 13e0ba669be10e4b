// SPDX-License-Identifier: Apache-2.0
#include "antiderivative.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra.h"
#include "complete_cases.h"
#include "integral_leaves.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostLeavesOfRange = 64;

/// The distances from 0 at which block `number` begins and ends.
double inner_edge(int number) { return number == 0 ? 0 : std::ldexp(1.0, number - 1 - kFirstBlockPower); }
double outer_edge(int number) { return std::ldexp(1.0, number - kFirstBlockPower); }

int block_of(double distance) {
  if (distance < outer_edge(0)) return 0;
  return std::ilogb(distance) + kFirstBlockPower + 1;
}

Interval narrowed(const LongInterval& v) {
  if (v.is_empty()) return Interval::empty(v.cause);
  const auto low = static_cast<double>(v.lower);
  const auto high = static_cast<double>(v.upper);
  return {static_cast<long double>(low) == v.lower ? low : Rounding<double>::down(low),
          static_cast<long double>(high) == v.upper ? high : Rounding<double>::up(high), v.decoration,
          v.cause};
}

LongInterval widened(const Interval& v) {
  if (v.is_empty()) return LongInterval::empty(v.cause);
  return {static_cast<long double>(v.lower), static_cast<long double>(v.upper), v.decoration, v.cause};
}

/// Whether nothing undefined lies between two places.
bool is_clear(const IntegralLeaf& a, const IntegralLeaf& b) {
  if (a.is_bad || b.is_bad) return false;
  if (a.is_negative == b.is_negative) return a.passed.bad == b.passed.bad;
  return a.passed.bad == 0 && b.passed.bad == 0;
}

/// Whether the value between two places is known well enough to be one.
bool is_fine(const IntegralLeaf& a, const IntegralLeaf& b) {
  if (a.is_coarse || b.is_coarse) return false;
  if (a.is_negative == b.is_negative) return a.passed.coarse == b.passed.coarse;
  return a.passed.coarse == 0 && b.passed.coarse == 0;
}

}  // namespace

Antiderivative::Antiderivative(Expression integrand, Variable v)
    : integrand_(std::move(integrand)), variable_(v) {}

Antiderivative::~Antiderivative() = default;

const Tape& Antiderivative::tape() const {
  std::call_once(compiled_, [this] {
    const Expression form = improved(with_complete_cases(reduced(integrand_), variable_));
    tape_ = std::make_unique<const Tape>(Tape::compile({&form, 1}, {&variable_, 1}));
  });
  return *tape_;
}

const IntegralBlock& Antiderivative::block(bool negative, int number) const {
  Slot& slot = slots_[negative ? 1 : 0][static_cast<std::size_t>(number)];
  std::call_once(slot.built, [&] {
    // From the middle outwards: what was passed further in is counted first.
    const PassedLeaves passed = number == 0 ? PassedLeaves{} : block(negative, number - 1).passed;
    const double sign = negative ? -1 : 1;
    slot.block = std::make_unique<const IntegralBlock>(
        build_block(tape(), sign * inner_edge(number), sign * outer_edge(number), number, passed));
  });
  return *slot.block;
}

const IntegralLeaf* Antiderivative::find_on_side(bool negative, double distance) const {
  const int number = block_of(distance);
  if (number >= kBlocks) return nullptr;
  const auto& leaves = block(negative, number).leaves;
  auto found = std::lower_bound(leaves.begin(), leaves.end(), distance,
                                [](const IntegralLeaf& l, double d) { return l.outer < d; });
  if (found == leaves.end()) --found;
  if (!found->is_bad) return &*found;
  if (found->outer == distance && std::next(found) != leaves.end()) return &*std::next(found);
  if (found->inner == distance && number > 0) return &block(negative, number - 1).leaves.back();
  return &*found;
}

const IntegralLeaf* Antiderivative::find(double t) const {
  const IntegralLeaf* const leaf = find_on_side(t < 0, std::abs(t));
  return t == 0 && leaf != nullptr && leaf->is_bad ? find_on_side(true, 0) : leaf;
}

double Antiderivative::between(double from, double to) const {
  if (!(std::isfinite(from) && std::isfinite(to)) || is_cut_off(from, to)) return kNaN;
  const IntegralLeaf* const a = find(from);
  const IntegralLeaf* const b = find(to);
  if (a == nullptr || b == nullptr || !is_clear(*a, *b)) return kNaN;
  if (from == to) return 0;
  if (!is_fine(*a, *b)) return kNaN;
  return static_cast<double>(sum_between(*a, *b).centre + b->near(to) - a->near(from));
}

bool Antiderivative::is_cut_off(double from, double to) const {
  const auto stops = [this](bool negative, double near, double far) {
    const int last = std::min(block_of(far), kBlocks);
    const int first = block_of(near);
    if (first >= last) return false;
    const IntegralLeaf* const start = find_on_side(negative, near);
    for (int i = first; i < last; ++i) {
      const PassedLeaves& passed = block(negative, i).passed;
      if (passed.bad > start->passed.bad || passed.coarse > start->passed.coarse) return true;
    }
    return false;
  };
  if (from > to) std::swap(from, to);
  if (from >= 0) return stops(false, from, to);
  if (to <= 0) return stops(true, -to, -from);
  return stops(true, 0, -from) || stops(false, 0, to);
}

IntegralSum Antiderivative::sum_from_zero(const IntegralLeaf& leaf) const {
  IntegralSum all;
  for (int i = 0; i < leaf.block; ++i) all.add(block(leaf.is_negative, i).tree[1]);
  all.add(block(leaf.is_negative, leaf.block).sum(0, leaf.index));
  all.add(leaf.to_place);
  return all;
}

IntegralSum Antiderivative::sum_between(const IntegralLeaf& from, const IntegralLeaf& to) const {
  if (&from == &to) return {};
  const auto reversed = [](IntegralSum s) {
    s.centre = -s.centre;
    return s;
  };
  if (from.is_negative != to.is_negative) {
    IntegralSum all = reversed(sum_from_zero(from));
    all.add(sum_from_zero(to));
    return all;
  }
  if (std::pair(from.block, from.index) > std::pair(to.block, to.index))
    return reversed(sum_between(to, from));
  IntegralSum all = from.to_outer;
  const IntegralBlock& first = block(from.is_negative, from.block);
  if (from.block == to.block) {
    all.add(first.sum(from.index + 1, to.index));
  } else {
    all.add(first.sum(from.index + 1, first.leaves.size()));
    for (int i = from.block + 1; i < to.block; ++i) all.add(block(from.is_negative, i).tree[1]);
    all.add(block(from.is_negative, to.block).sum(0, to.index));
  }
  all.add(to.to_place);
  return all;
}

std::optional<Interval> Antiderivative::proven_between(double from, double to) const {
  const IntegralLeaf* const a = find(from);
  const IntegralLeaf* const b = find(to);
  if (a == nullptr || b == nullptr || !is_clear(*a, *b)) return std::nullopt;
  if (from == to) return Interval(0.0);
  const Interval ends = b->enclosed_near(to) - a->enclosed_near(from);
  if (a == b) return ends;
  const IntegralSum s = sum_between(*a, *b);
  // The sum and the difference are rounded, too.
  const long double radius =
      s.radius + 2 * std::numeric_limits<long double>::epsilon() * (std::abs(s.centre) + s.radius);
  return ends + Interval(Rounding<double>::down(static_cast<double>(s.centre - radius)),
                         Rounding<double>::up(static_cast<double>(s.centre + radius)));
}

Interval Antiderivative::around(double middle, const Interval& t) const {
  if (t.is_point()) return {0.0};
  const Interval heights = integrand(t);
  const Interval plain = heights * (t - Interval(middle));
  if (heights.lower >= 0 || heights.upper <= 0) {
    const auto first = proven_between(middle, t.lower);
    const auto last = proven_between(middle, t.upper);
    if (!first || !last) return plain;
    // The integral only rises, or only falls.
    const bool rises = heights.lower >= 0;
    const Interval ends(rises ? first->lower : last->lower, rises ? last->upper : first->upper);
    return {std::max(ends.lower, plain.lower), std::min(ends.upper, plain.upper)};
  }
  return plain;
}

Interval Antiderivative::between(const Interval& from, const Interval& to) const {
  if (from.is_empty() || to.is_empty()) return Interval::empty(from.cause | to.cause);
  const Decoration proven = std::min(from.decoration, to.decoration);
  const Cause why = from.cause | to.cause;
  const IntegralLeaf* const a = from.is_bounded() ? find(from.lower) : nullptr;
  const IntegralLeaf* const b = from.is_bounded() ? find(from.upper) : nullptr;
  const IntegralLeaf* const c = to.is_bounded() ? find(to.lower) : nullptr;
  const IntegralLeaf* const d = to.is_bounded() ? find(to.upper) : nullptr;
  if (a == nullptr || b == nullptr || c == nullptr || d == nullptr)
    return Interval::entire(Decoration::partial, why | Cause::overflow);
  if (is_clear(*a, *b) && is_clear(*b, *c) && is_clear(*c, *d)) {
    const double middle_from = from.middle();
    const double middle_to = to.middle();
    if (auto value = proven_between(middle_from, middle_to)) {
      Interval r = *value + around(middle_to, to) - around(middle_from, from);
      r.decoration = proven;
      r.cause = why;
      return r;
    }
  }
  const Cause cause = why | (a->is_bad ? a->cause : Cause::none) | (c->is_bad ? c->cause : Cause::none) |
                      (d->is_bad ? d->cause : Cause::none) | Cause::domain;
  const auto lies_in = [](const IntegralLeaf& first, const IntegralLeaf& last) {
    return first.is_bad && &first == &last;
  };
  const bool apart = from.upper < to.lower ? !is_clear(*b, *c) && b != c
                                           : to.upper < from.lower && !is_clear(*d, *a) && a != d;
  if (lies_in(*a, *b) || lies_in(*c, *d) || (apart && !b->is_bad && !c->is_bad && !a->is_bad && !d->is_bad))
    return Interval::empty(cause);
  return Interval::entire(Decoration::partial, cause | Cause::pole);
}

double Antiderivative::integrand(double t) const {
  const double v = tape().evaluate_one<double>({&t, 1});
  if (std::isfinite(v)) return v;
  const IntegralLeaf* const leaf = std::isfinite(t) ? find(t) : nullptr;
  return leaf == nullptr || leaf->is_bad ? v : leaf->height_near(t);
}

Interval Antiderivative::range_of_leaves(const Interval& t) const {
  Interval all = Interval::empty();
  double at = t.lower;
  for (std::size_t i = 0; i < kMostLeavesOfRange; ++i) {
    const IntegralLeaf* const leaf = find(at);
    if (leaf == nullptr || leaf->is_bad) break;
    all = hull(all, leaf->range);
    const double end = at < 0 ? -leaf->inner : leaf->outer;
    if (end >= t.upper) return all;
    at = Rounding<double>::up(end);
  }
  return Interval::entire(Decoration::partial, Cause::pole);
}

Interval Antiderivative::integrand(const Interval& t) const {
  const Interval v = tape().evaluate_one<Interval>({&t, 1});
  const bool known = !v.is_empty() && v.is_bounded() && v.decoration >= Decoration::defined;
  return known || t.is_empty() || !t.is_bounded() ? v : range_of_leaves(t);
}

Taylor Antiderivative::integrand(const Taylor& t) const { return tape().evaluate_one<Taylor>({&t, 1}); }

long double integral(const Antiderivative& f, long double from, long double to) {
  return f.between(static_cast<double>(from), static_cast<double>(to));
}

LongInterval integral(const Antiderivative& f, const LongInterval& from, const LongInterval& to) {
  return widened(f.between(narrowed(from), narrowed(to)));
}

LongInterval integrand_at(const Antiderivative& f, const LongInterval& t) {
  return widened(f.integrand(narrowed(t)));
}

Taylor integral(const Antiderivative& f, const Taylor& from, const Taylor& to) {
  const Taylor values = [&] {
    Taylor r;
    r.box[0] = f.between(from.box[0], to.box[0]);
    r.place[0] = f.between(from.place[0], to.place[0]);
    return r;
  }();
  return chained(values, f.integrand(to), to) - chained(Taylor(Interval(0.0)), f.integrand(from), from);
}

}  // namespace nazori::functions
