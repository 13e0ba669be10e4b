// SPDX-License-Identifier: Apache-2.0
#include "plane_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "algebra.h"

namespace nazori::functions {
namespace {

// The grid has an irregular offset, so that axes and other round numbers do not fall on borders of boxes.
constexpr double kShiftU = 0.00137391;
constexpr double kShiftV = 0.00213173;
constexpr int kProgressLevel = 4;
// With more strips than this, halving the box is cheaper.
constexpr double kMostStrips = 16;

int sign_of(double v) { return std::isnan(v) ? 0 : v < 0 ? -1 : 1; }

Tape compile_one(const Expression& e, const std::array<Variable, 2>& variables) {
  return Tape::compile(std::array{e}, variables);
}

}  // namespace

PlaneTracer::PlaneTracer(const PlaneEquation& equation, int cells, double margin, WorkProgress& progress)
    : equation_(equation),
      cells_(cells),
      margin_(margin),
      progress_(progress),
      function_(compile_one(equation.function, equation.variables)),
      whole_(compile_one(equation.whole, equation.variables)),
      has_whole_(to_text(equation.function) != to_text(equation.whole) && !is_total(equation.whole)),
      tolerance_(1.0 / (16.0 * std::max(cells, 256))) {
  std::size_t most = std::max(function_.size(), whole_.size());
  for (const auto& conditions : equation.areas) {
    areas_.emplace_back();
    for (const Expression& e : conditions) {
      areas_.back().push_back(compile_one(e, equation.variables));
      most = std::max(most, areas_.back().back().size());
    }
  }
  values_.resize(most);
  gradients_.resize(most);
  intervals_.resize(most);
  duals_.resize(most);
  for (const std::size_t i : {0U, 1U}) range_[i] = equation.high[i] - equation.low[i];
}

bool PlaneTracer::run(PlaneSolution& solution) {
  out_ = &solution;
  const double side = 1 + 2 * margin_ + 0.0047;
  finest_level_ = 0;
  while (side / std::exp2(finest_level_) > 1.0 / cells_) ++finest_level_;
  solution.leaf = side / std::exp2(finest_level_);
  visit({-margin_ - kShiftU, -margin_ - kShiftV, side}, 0);
  return !progress_.is_stopped();
}

double PlaneTracer::value(Point p) {
  function_.evaluate<double>(
      std::array{equation_.low[0] + p.u * range_[0], equation_.low[1] + p.v * range_[1]}, values_);
  return values_[function_.output(0)];
}

PlaneTracer::Gradient PlaneTracer::gradient(Point p) {
  Gradient a(equation_.low[0] + p.u * range_[0], 0);
  Gradient b(equation_.low[1] + p.v * range_[1], 1);
  a.slopes[0] = range_[0];
  b.slopes[1] = range_[1];
  function_.evaluate<Gradient>(std::array{a, b}, gradients_);
  return gradients_[function_.output(0)];
}

Interval PlaneTracer::enclose(const Tape& tape, Interval u, Interval v) {
  const auto mapped = [this](Interval i, std::size_t axis) {
    return Interval(equation_.low[axis] + i.lower * range_[axis],
                    equation_.low[axis] + i.upper * range_[axis]);
  };
  tape.evaluate<Interval>(std::array{mapped(u, 0), mapped(v, 1)}, intervals_);
  return intervals_[tape.output(0)];
}

Interval PlaneTracer::enclose(const Tape& tape, const Square& s) {
  return enclose(tape, Interval(s.u, s.u + s.side), Interval(s.v, s.v + s.side));
}

bool PlaneTracer::fills(const Square& s) {
  for (const auto& conditions : areas_) {
    bool certain = true;
    for (const Tape& tape : conditions) {
      const Interval i = enclose(tape, s);
      certain = certain && !i.is_empty() && i.lower >= 0 && i.decoration >= Decoration::defined;
    }
    if (certain && (!has_whole_ || enclose(whole_, s).decoration >= Decoration::defined)) return true;
  }
  return false;
}

/// Zero as far as the function can be computed: the enclosure over a few last places contains zero and proves
/// that the function is continuous there.
bool PlaneTracer::is_zero_at(Point p) {
  const double eps = 4 * std::numeric_limits<double>::epsilon();
  const auto around = [eps](double c) {
    return Interval(c - eps * (1 + std::abs(c)), c + eps * (1 + std::abs(c)));
  };
  const Interval f = enclose(function_, around(p.u), around(p.v));
  return !f.is_empty() && f.contains(0) && f.is_continuous() && counts_at(p);
}

bool PlaneTracer::counts_at(Point p) {
  if (!has_whole_) return true;
  constexpr double kAround = 1e-11;
  const Interval w =
      enclose(whole_, Interval(p.u - kAround, p.u + kAround), Interval(p.v - kAround, p.v + kAround));
  const bool counts = !w.is_empty() && w.decoration >= Decoration::defined;
  rejected_ = rejected_ || !counts;
  return counts;
}

void PlaneTracer::visit(const Square& s, int level) {
  if (progress_.is_stopped() || !progress_.is_in_time()) return;
  if (level == kProgressLevel) {
    done_ += 1 / std::exp2(2 * kProgressLevel);
    if (!progress_.report(done_)) return;
  }
  const Interval f = enclose(function_, s);
  if (f.is_empty() || !f.contains(0)) return;
  if (f.is_point() && f.decoration >= Decoration::defined &&
      (!has_whole_ || enclose(whole_, s).decoration >= Decoration::defined)) {
    out_->fills.push_back({Point{s.u, s.v}, Point{s.u + s.side, s.v + s.side}});
    return;
  }
  if (!areas_.empty() && fills(s)) {
    out_->fills.push_back({Point{s.u, s.v}, Point{s.u + s.side, s.v + s.side}});
    return;
  }
  bool whole_is_sound = true;
  if (has_whole_) {
    const Interval w = enclose(whole_, s);
    if (w.is_empty() || !w.contains(0)) return;
    whole_is_sound = w.decoration >= Decoration::defined;
  }
  const bool finest = level >= finest_level_;
  if (f.is_continuous() && level >= 3) {
    using D = Dual<Interval, 2>;
    D a(Interval(equation_.low[0] + s.u * range_[0], equation_.low[0] + (s.u + s.side) * range_[0]), 0);
    D b(Interval(equation_.low[1] + s.v * range_[1], equation_.low[1] + (s.v + s.side) * range_[1]), 1);
    a.slopes[0] = Interval(range_[0]);
    b.slopes[1] = Interval(range_[1]);
    function_.evaluate<D>(std::array{a, b}, duals_);
    const Interval slope_u = duals_[function_.output(0)].slopes[0];
    const Interval slope_v = duals_[function_.output(0)].slopes[1];
    if (slope_u.is_bounded() && slope_v.is_bounded()) {
      const double h = s.side / 2;
      const Interval centre = enclose(function_, Interval(s.u + h), Interval(s.v + h));
      const Interval both = centre + slope_u * Interval(-h, h) + slope_v * Interval(-h, h);
      if (!both.contains(0)) return;
      if (whole_is_sound && draw_graph(s, slope_u, slope_v, finest)) return;
    }
  }
  if (!finest) {
    const double h = s.side / 2;
    visit({s.u, s.v, h}, level + 1);
    visit({s.u + h, s.v, h}, level + 1);
    visit({s.u, s.v + h, h}, level + 1);
    visit({s.u + h, s.v + h, h}, level + 1);
    return;
  }
  settle_leaf(s, f.is_continuous());
}

/// Where the function rises or falls along one axis the zero set is a graph over the other. The box is cut
/// into strips across that other axis, so narrow that the graph is straight within the tolerance in each; the
/// corners of a strip then determine it.
bool PlaneTracer::draw_graph(const Square& s, const Interval& slope_u, const Interval& slope_v, bool finest) {
  const bool over_u = !slope_v.contains(0);
  const bool over_v = !slope_u.contains(0);
  if (!over_u && !over_v) return false;
  bool strips_in_u = over_u;
  std::size_t strips = 1;
  if (!finest) {
    double stray = std::numeric_limits<double>::infinity();
    for (const auto& [graph, in_u, along, across] :
         {std::tuple{over_u, true, slope_u, slope_v}, std::tuple{over_v, false, slope_v, slope_u}}) {
      if (!graph) continue;
      const Interval steepness = along / across;
      if (!steepness.is_bounded() || !(s.side / 4 * steepness.width() < stray)) continue;
      stray = s.side / 4 * steepness.width();
      strips_in_u = in_u;
    }
    if (!(stray <= kMostStrips * tolerance_)) return false;
    strips = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(stray / tolerance_)));
  }
  struct Border {
    Point low, high;
    double f_low, f_high;
  };
  std::vector<Border> borders(strips + 1);
  for (std::size_t i = 0; i <= strips; ++i) {
    const double at = i == strips ? s.side : s.side * static_cast<double>(i) / static_cast<double>(strips);
    Border& b = borders[i];
    b.low = strips_in_u ? Point{s.u + at, s.v} : Point{s.u, s.v + at};
    b.high = strips_in_u ? Point{s.u + at, s.v + s.side} : Point{s.u + s.side, s.v + at};
    b.f_low = value(b.low);
    b.f_high = value(b.high);
    if (!std::isfinite(b.f_low) || !std::isfinite(b.f_high)) return false;
  }
  const auto add_side = [this](Point p, Point q, double fp, double fq, std::vector<Point>& roots) {
    if (sign_of(fp) != sign_of(fq)) add_root(p, q, fp, fq, true, roots);
  };
  std::vector<Point> first;
  std::vector<Point> second;
  add_side(borders[0].low, borders[0].high, borders[0].f_low, borders[0].f_high, first);
  for (std::size_t i = 0; i < strips; ++i) {
    const Border& a = borders[i];
    const Border& b = borders[i + 1];
    second.clear();
    add_side(b.low, b.high, b.f_low, b.f_high, second);
    std::vector<Point> roots = first;
    roots.insert(roots.end(), second.begin(), second.end());
    add_side(a.low, b.low, a.f_low, b.f_low, roots);
    add_side(a.high, b.high, a.f_high, b.f_high, roots);
    if (roots.size() == 2) out_->segments.push_back({roots[0], roots[1]});
    std::swap(first, second);
  }
  return true;
}

}  // namespace nazori::functions
