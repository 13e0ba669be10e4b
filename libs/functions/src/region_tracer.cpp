// SPDX-License-Identifier: Apache-2.0
#include "region_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nazori::functions {
namespace {

constexpr std::array<Variable, 2> kPlane{Variable::x, Variable::y};
constexpr int kProgressLevel = 4;

}  // namespace

RegionTracer::RegionTracer(const std::vector<Condition>& conditions, const Expression& guard, int statement,
                           const TraceSettings& settings, Tracing& out, WorkProgress& progress)
    : statement_(statement), out_(out), progress_(progress) {
  std::size_t most = 1;
  for (const Condition& c : conditions)
    tests_.push_back({Tape::compile(std::array{c.expression}, kPlane), c.strict, false});
  if (guard) tests_.push_back({Tape::compile(std::array{guard}, kPlane), false, true});
  for (const Test& t : tests_) most = std::max(most, t.tape.size());
  values_.resize(most);
  intervals_.resize(most);
  while (std::exp2(finest_level_) < 2 * settings.resolution) ++finest_level_;
}

bool RegionTracer::run() {
  visit(0, 0, 1, 0);
  return !progress_.is_stopped();
}

bool RegionTracer::holds(PlatePoint p) {
  for (const Test& t : tests_) {
    t.tape.evaluate<double>(std::array{out_.window.x(p.u), out_.window.y(p.v)}, values_);
    const double f = values_[t.tape.output(0)];
    if (t.only_defined ? !std::isfinite(f) : !(t.strict ? f > 0 : f >= 0)) return false;
  }
  return true;
}

RegionTracer::Answer RegionTracer::ask(const Test& test, double u, double v, double side) {
  const Window& w = out_.window;
  test.tape.evaluate<Interval>(std::array{Interval(w.x(u), w.x(u + side)), Interval(w.y(v), w.y(v + side))},
                               intervals_);
  const Interval f = intervals_[test.tape.output(0)];
  if (f.is_empty()) return Answer::no;
  const bool sure = f.decoration >= Decoration::defined;
  if (test.only_defined) return sure ? Answer::yes : Answer::maybe;
  if (test.strict ? f.upper <= 0 : f.upper < 0) return Answer::no;
  return sure && (test.strict ? f.lower > 0 : f.lower >= 0) ? Answer::yes : Answer::maybe;
}

void RegionTracer::visit(double u, double v, double side, int level) {
  if (progress_.is_stopped() || !progress_.is_in_time()) return;
  if (level == kProgressLevel) {
    done_ += 1 / std::exp2(2 * kProgressLevel);
    if (!progress_.report(done_)) return;
  }
  Answer all = Answer::yes;
  for (const Test& t : tests_) all = std::min(all, ask(t, u, v, side));
  if (all == Answer::no) return;
  if (all == Answer::maybe && level >= finest_level_ && !holds({u + side / 2, v + side / 2})) return;
  if (all == Answer::yes || level >= finest_level_) {
    out_.fills.push_back({statement_, {u, v}, {u + side, v + side}});
    return;
  }
  const double h = side / 2;
  visit(u, v, h, level + 1);
  visit(u + h, v, h, level + 1);
  visit(u, v + h, h, level + 1);
  visit(u + h, v + h, h, level + 1);
}

}  // namespace nazori::functions
