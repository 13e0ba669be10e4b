// SPDX-License-Identifier: Apache-2.0
#include "break_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra.h"
#include "one_variable.h"
#include "zeros.h"

namespace nazori::functions {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
// A value this near to an edge is on it: the place was solved for, and rounding is far smaller.
constexpr double kOnEdge = 1e-12;
constexpr double kWide = 1e4;
// Places nearer than this share of the range are one.
constexpr double kSame = 1e-9;
constexpr int kMostLevels = 60;
constexpr std::size_t kMostGaps = 100;

Expression difference(const Expression& a, const Expression& b) { return binary(NodeKind::subtract, a, b); }

double value_of(const Expression& e, Variable v, double t) { return OneVariable(e, v).value(t); }

/// Whether the function jumps at every whole number of its argument.
bool has_whole_steps(Function f) {
  return f == Function::floor || f == Function::ceil || f == Function::trunc || f == Function::fraction;
}

/// What a part that jumps is exactly at the edge.
Expression at_edge(const Expression& part, double level) {
  switch (part->function) {
    case Function::less_equal:
    case Function::greater_equal:
    case Function::equal:
      return number(1);
    case Function::less:
    case Function::greater:
    case Function::mod:
    case Function::sign:
      return number(0);
    case Function::round:
      return number(constant_value(call(Function::round, {number(level + 0.5)})));
    default:
      return number(constant_value(call(part->function, {number(level)})));
  }
}

}  // namespace

BreakPlaces::BreakPlaces(const Expression& f, Variable v) : f_(f), v_(v) { collect(f); }

void BreakPlaces::add(Cause cause, const Expression& argument, const Expression& part) {
  if (depends_on(argument, v_)) conditions_.push_back({cause, argument, part});
}

void BreakPlaces::collect(const Expression& e) {
  for (const Expression& a : parts_at_a_place(*e)) collect(a);
  if (e->kind == NodeKind::divide) add(Cause::undefined, e->arguments[1]);
  if (e->kind == NodeKind::power) {
    const auto n = rational_value(e->arguments[1]);
    if (!n || n->p < 0) add(Cause::undefined, e->arguments[0]);
    if (n && n->p > 0 && n->q % 2 == 0) add(Cause::edge, e->arguments[0]);
  }
  if (e->kind == NodeKind::function) collect_function(e);
}

void BreakPlaces::collect_function(const Expression& e) {
  const auto& a = e->arguments;
  const auto of = [](Function f, const Expression& u) { return call(f, {u}); };
  switch (e->function) {
    case Function::tan:
    case Function::sec:
      return add(Cause::undefined, of(Function::cos, a[0]));
    case Function::cot:
    case Function::csc:
      return add(Cause::undefined, of(Function::sin, a[0]));
    case Function::coth:
    case Function::csch:
    case Function::ln:
    case Function::log10:
    case Function::log2:
      return add(Cause::undefined, a[0]);
    case Function::log_base:
      return add(Cause::undefined, a[1]);
    case Function::asin:
    case Function::acos:
      add(Cause::edge, difference(a[0], number(1)));
      return add(Cause::edge, difference(a[0], number(-1)));
    case Function::atanh:
      add(Cause::undefined, difference(a[0], number(1)));
      return add(Cause::undefined, difference(a[0], number(-1)));
    case Function::acosh:
      return add(Cause::edge, difference(a[0], number(1)));
    case Function::sqrt:
      return add(Cause::edge, a[0]);
    case Function::floor:
    case Function::ceil:
    case Function::trunc:
    case Function::fraction:
    case Function::sign:
      return add(Cause::step, a[0], e);
    case Function::round:
      return add(Cause::step, difference(a[0], number(0.5)), e);
    case Function::mod:
      add(Cause::undefined, a[1]);
      return add(Cause::step, binary(NodeKind::divide, a[0], a[1]), e);
    case Function::less:
    case Function::less_equal:
    case Function::greater:
    case Function::greater_equal:
    case Function::equal:
      return add(Cause::step, difference(a[0], a[1]), e);
    default:
      return;
  }
}

/// Whether the argument is on an edge at `t`, and on which one.
bool BreakPlaces::holds(const Condition& c, double t, double& level) const {
  const double u = value_of(c.argument, v_, t);
  if (!std::isfinite(u)) return false;
  const bool whole = c.part && (has_whole_steps(c.part->function) || c.part->function == Function::round ||
                                c.part->function == Function::mod);
  level = whole ? std::round(u) : 0;
  // Rounding of the place itself, times the slope, is not more than this. What changes more is a jump.
  constexpr double kMostMoved = 1e-9;
  const double hair = 4e-16 * std::max(1.0, std::abs(t));
  double slack = kOnEdge * std::max(1.0, std::abs(level));
  for (const double s : {t - hair, t + hair}) {
    const double moved = std::abs(value_of(c.argument, v_, s) - u);
    if (moved < kMostMoved) slack += 2 * moved;
  }
  return std::abs(u - level) <= slack;
}

BreakPlace BreakPlaces::place(double at) const {
  BreakPlace p;
  if (std::abs(at) < kOnEdge) at = 0;
  p.at = at;
  Expression exact = f_;
  for (const Condition& c : conditions_) {
    double level = 0;
    if (!holds(c, at, level)) continue;
    p.undefined = p.undefined || c.cause == Cause::undefined;
    if (c.cause != Cause::step) continue;
    p.is_step = true;
    exact = replaced(exact, c.part, at_edge(c.part, level));
  }
  p.value = p.undefined ? kNaN : value_of(exact, v_, at);
  return p;
}

std::optional<BreakPlace> BreakPlaces::near(double t, double reach) const {
  std::optional<double> best;
  for (const Condition& c : conditions_) {
    Expression argument = c.argument;
    if (c.cause == Cause::step) {
      const double u = value_of(argument, v_, t);
      const double level =
          c.part->function == Function::sign || is_condition(c.part->function) ? 0 : std::round(u);
      if (!std::isfinite(level)) continue;
      if (level != 0) argument = difference(argument, number(level));
    }
    // Where it only touches zero, the place is found from farther away.
    const double wide = kWide * reach;
    for (const double z : zeros_of(argument, v_, t - wide, t + wide)) {
      if (std::abs(z - t) > reach) continue;
      if (!best || std::abs(z - t) < std::abs(*best - t)) best = z;
    }
  }
  if (!best) return std::nullopt;
  return place(*best);
}

std::vector<BreakPlace> BreakPlaces::steps(double low, double high) const {
  std::vector<double> all;
  for (const Condition& c : conditions_) {
    if (c.cause != Cause::step) continue;
    int first = 0;
    int last = 0;
    if (c.part->function != Function::sign && !is_condition(c.part->function)) {
      const Interval range = OneVariable(c.argument, v_).range(low, high);
      if (range.is_empty() || !range.is_bounded() || range.width() > kMostLevels) return {};
      first = static_cast<int>(std::ceil(range.lower));
      last = static_cast<int>(std::floor(range.upper));
    }
    for (int level = first; level <= last; ++level) {
      const Expression argument = level == 0 ? c.argument : difference(c.argument, number(level));
      for (const double t : zeros_of(argument, v_, low, high)) all.push_back(t);
    }
  }
  return places(std::move(all), kSame * (high - low));
}

std::vector<BreakPlace> BreakPlaces::gaps(double low, double high) const {
  std::vector<double> all;
  for (const Condition& c : conditions_) {
    if (c.cause != Cause::undefined) continue;
    const std::vector<double> zeros = zeros_of(c.argument, v_, low, high);
    if (all.size() + zeros.size() > kMostGaps) return {};
    all.insert(all.end(), zeros.begin(), zeros.end());
  }
  return places(std::move(all), kSame * (high - low));
}

std::vector<BreakPlace> BreakPlaces::places(std::vector<double> all, double apart) const {
  std::sort(all.begin(), all.end());
  std::vector<BreakPlace> found;
  for (const double t : all) {
    if (found.empty() || t - found.back().at > apart) found.push_back(place(t));
  }
  return found;
}

}  // namespace nazori::functions
