// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra.h"
#include "arc_probe.h"
#include "arcs.h"
#include "nazori/functions/curve_kinds.h"
#include "newton.h"
#include "polyline_crossings.h"
#include "roots.h"

namespace nazori::functions {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
// Two points of interest of one kind nearer than this share of the plate count as one.
constexpr double kSame = 1e-6;

class PointFinder {
 public:
  PointFinder(const Plot& plot, const Tracing& tracing, std::size_t most)
      : plot_(plot), tracing_(tracing), window_(tracing.window), most_(most) {}

  std::vector<PointOfInterest> run() {
    counts_.assign(plot_.statements.size(), 0);
    for (std::size_t i = 0; i < plot_.statements.size(); ++i) {
      const Statement& s = plot_.statements[i];
      statement_ = static_cast<int>(i);
      if (const auto arc = arc_of(s, window_, 0.02)) {
        walk(*arc);
      } else if (equation_of(s)) {
        intercepts(s);
      }
    }
    for (const Event& e : tracing_.events) add(e);
    for (std::size_t i = 0; i < plot_.statements.size(); ++i) {
      for (std::size_t j = i + 1; j < plot_.statements.size(); ++j)
        meet(static_cast<int>(i), static_cast<int>(j));
    }
    self_crossings();
    for (PointOfInterest& p : found_) {
      p.x_name = exact_name(p.x).value_or("");
      p.y_name = exact_name(p.y).value_or("");
    }
    std::stable_sort(found_.begin(), found_.end(), [](const PointOfInterest& a, const PointOfInterest& b) {
      if (a.statement != b.statement) return a.statement < b.statement;
      const double ax = std::isnan(a.x) ? -1e300 : a.x;
      const double bx = std::isnan(b.x) ? -1e300 : b.x;
      return ax < bx;
    });
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool in_window(double x, double y) const {
    constexpr double kHair = 1e-9;
    const double u = window_.u(x);
    const double v = window_.v(y);
    return (std::isnan(x) || (u >= -kHair && u <= 1 + kHair)) &&
           (std::isnan(y) || (v >= -kHair && v <= 1 + kHair)) && !(std::isnan(x) && std::isnan(y));
  }

  void add(PointKind kind, double x, double y, double parameter, int other = -1) {
    if (!in_window(x, y)) return;
    const auto owner = static_cast<std::size_t>(statement_);
    if (counts_[owner] >= most_) return;
    for (const PointOfInterest& p : found_) {
      if (p.kind != kind || p.statement != statement_ || p.other != other) continue;
      const double du = std::isnan(x) ? 0 : window_.u(p.x) - window_.u(x);
      const double dv = std::isnan(y) ? 0 : window_.v(p.y) - window_.v(y);
      if (std::hypot(du, dv) < kSame) return;
    }
    ++counts_[owner];
    found_.push_back({kind, statement_, other, x + 0.0, y + 0.0, parameter + 0.0, {}, {}});
  }

  void walk(const Arc& arc) {
    ArcProbe probe(arc);
    const CurveKind& kind = curve_kind(plot_.statements[static_cast<std::size_t>(statement_)].kind);
    const double flat = 1e-12 * std::max(std::abs(window_.y0), std::abs(window_.y1));
    for (const Branch& b : tracing_.branches) {
      if (b.statement != statement_ || !b.has_parameter) continue;
      sign_changes(
          b.points, [&](double t) { return probe.at(t).y; },
          [&](double t, bool) { add(PointKind::zero, probe.at(t).x, 0, t); });
      for (const CurvePoint* end : {&b.points.front(), &b.points.back()}) {
        if (arc.is_open_end(end->parameter)) continue;
        if (std::abs(probe.at(end->parameter).y) <= flat && !kind.is_graph_of_x())
          add(PointKind::zero, probe.at(end->parameter).x, 0, end->parameter);
      }
      if (!kind.is_graph_of_y()) {
        sign_changes(
            b.points, [&](double t) { return beyond_rounding(probe.at(t).slope_y, probe.slope_y(t)); },
            [&](double t, bool rising) {
              const auto v = probe.at(t);
              const bool least = kind.is_graph_of_x() ? rising : is_least(probe, t);
              const double y = std::isfinite(v.y) ? v.y : near_value(probe, t);
              if (std::abs(y) <= flat) add(PointKind::zero, v.x, 0, t);
              add(least ? PointKind::minimum : PointKind::maximum, v.x, std::abs(y) <= flat ? 0 : y, t);
            });
      }
      if (kind.is_graph_of_x()) inflections(b, probe);
      if (!kind.is_graph_of_x()) {
        sign_changes(
            b.points, [&](double t) { return probe.at(t).x; },
            [&](double t, bool) { add(PointKind::y_intercept, 0, probe.at(t).y, t); });
      }
    }
    if (kind.is_graph_of_x()) {
      const auto v = probe.at(0);
      if (window_.x0 <= 0 && window_.x1 >= 0 && std::isfinite(v.y)) add(PointKind::y_intercept, 0, v.y, 0);
    }
  }

  /// Extrema of the slope, found by differences of slopes, on branches that are not straight lines.
  void inflections(const Branch& b, ArcProbe& probe) {
    const double span = b.points.back().parameter - b.points.front().parameter;
    const double h = 3e-5 * span;
    const auto bend = [&](double t) {
      const double d = probe.at(t + h).slope_y - probe.at(t - h).slope_y;
      // Differences due to rounding are not a bend.
      return beyond_rounding(d, probe.slope_y(t + h) - probe.slope_y(t - h));
    };
    sign_changes(b.points, bend, [&](double t, bool) {
      const auto v = probe.at(t);
      const double around =
          std::max(std::abs(probe.at(t + 2 * h).slope_y), std::abs(probe.at(t - 2 * h).slope_y));
      // At corners and cusps the slope jumps.
      if (std::isfinite(v.slope_y) && std::abs(bend(t + 2 * h)) < 0.2 * (around + 1e-12))
        add(PointKind::inflection, snapped(v.x), probe.at(snapped(v.x)).y, t);
    });
  }

  /// Differences find an inflection to some eight digits only: use a nearby exact number instead.
  static double snapped(double x) {
    for (const double unit : {1.0, 0.5, std::acos(-1.0) / 2, std::acos(-1.0) / 4, 1.0 / 3}) {
      const double near = std::round(x / unit) * unit;
      if (std::abs(near - x) < 1e-6 * std::max(1.0, std::abs(x))) return near;
    }
    return x;
  }

  void intercepts(const Statement& s) {
    const Expression f = equation_of(s);
    const Expression on_x = reduced(substitute(f, Variable::y, number(0)));
    const Expression on_y = reduced(substitute(f, Variable::x, number(0)));
    const auto vanishes = [](const Expression& e) {
      const auto p = Polynomial::of(over_common_denominator(e).numerator);
      return p && p->is_zero();
    };
    if (window_.y0 <= 0 && window_.y1 >= 0 && !vanishes(on_x)) {
      for (const Root& r : find_roots(numerator(on_x), Variable::x, window_.x0, window_.x1).roots)
        if (is_defined(f, r.at, 0)) add(PointKind::zero, r.at, 0, 0);
    }
    if (window_.x0 <= 0 && window_.x1 >= 0 && !vanishes(on_y)) {
      for (const Root& r : find_roots(numerator(on_y), Variable::y, window_.y0, window_.y1).roots)
        if (is_defined(f, 0, r.at)) add(PointKind::y_intercept, 0, r.at, 0);
    }
  }

  static Expression numerator(const Expression& e) { return over_common_denominator(e).numerator; }
  static bool is_defined(const Expression& f, double x, double y) {
    const Tape tape = Tape::compile(std::array{f}, std::array{Variable::x, Variable::y});
    return std::isfinite(tape.evaluate_one<double>(std::array{x, y}));
  }

  void add(const Event& e) {
    statement_ = e.statement;
    const CurveKind& kind = curve_kind(plot_.statements[static_cast<std::size_t>(e.statement)].kind);
    switch (e.kind) {
      case EventKind::pole:
        if (kind.is_graph_of_x()) add(PointKind::vertical_asymptote, e.x, kNaN, e.parameter);
        if (kind.is_graph_of_y()) add(PointKind::horizontal_asymptote, kNaN, e.y, e.parameter);
        break;
      case EventKind::hole:
        add(PointKind::hole, e.x, e.y, e.parameter);
        break;
      case EventKind::jump:
        add(PointKind::jump, e.x, e.y, e.parameter);
        break;
      case EventKind::end:
        // A limit that is not attained is known to some ten digits.
        if (!is_passed_through(e)) add(PointKind::end, e.x, limit(e.y), e.parameter);
        break;
      case EventKind::singular:
        add(branches_at(e) >= 4 ? PointKind::self_crossing : PointKind::singular, e.x, e.y, e.parameter);
        break;
      case EventKind::isolated:
        add(PointKind::isolated, e.x, e.y, e.parameter);
        break;
      case EventKind::limit:
        break;
    }
  }

  static double limit(double y) {
    const double near = std::round(y * 1e4) / 1e4;
    return std::abs(near - y) < 1e-9 * std::max(1.0, std::abs(y)) ? near : y;
  }

  /// Pieces of curves that end at the event.
  [[nodiscard]] int branches_at(const Event& e) const {
    int n = 0;
    for (const Branch& b : tracing_.branches) {
      if (b.statement != e.statement) continue;
      for (const CurvePoint* p : {&b.points.front(), &b.points.back()})
        n += std::hypot(p->u - window_.u(e.x), p->v - window_.v(e.y)) < 1e-5 ? 1 : 0;
    }
    return n;
  }

  [[nodiscard]] bool is_passed_through(const Event& e) const { return branches_at(e) >= 2; }

  /// Crossings of two statements: in one variable where one of them is an arc, else where polylines meet.
  void meet(int i, int j) {
    const Statement& a = plot_.statements[static_cast<std::size_t>(i)];
    const Statement& b = plot_.statements[static_cast<std::size_t>(j)];
    statement_ = i;
    auto arc = arc_of(a, window_, 0);
    Expression f = equation_of(b);
    if (!arc || !f) {
      arc = arc_of(b, window_, 0);
      f = equation_of(a);
    }
    if (arc && f) {
      meet(*arc, f, j);
    } else {
      for (const Meeting& m : crossings_of(tracing_, i, j)) {
        PlatePoint at{window_.x(m.at.u), window_.y(m.at.v)};
        const Expression fa = equation_of(a);
        const Expression fb = equation_of(b);
        if (fa && fb) at = refined(fa, fb, at);
        add(PointKind::crossing, at.u, at.v, 0, j);
      }
    }
  }

  void meet(const Arc& arc, const Expression& f, int other) {
    // The placeholder keeps the second substitution from changing the result of the first.
    const Expression with_x = substitute(f, Variable::x, variable(Variable::z));
    const Expression with_y = substitute(with_x, Variable::y, arc.y);
    const Expression along = reduced(substitute(with_y, Variable::z, arc.x));
    const Expression top = numerator(along);
    const auto p = Polynomial::of(top);
    if (p && p->is_zero()) return;
    ArcProbe probe(arc);
    for (const Root& r : find_roots(top, arc.parameter, arc.from, arc.to).roots) {
      const auto v = probe.at(r.at);
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || arc.is_open_end(r.at)) continue;
      add(r.crosses ? PointKind::crossing : PointKind::touching, v.x, v.y, r.at, other);
    }
  }

  void self_crossings() {
    for (std::size_t i = 0; i < plot_.statements.size(); ++i) {
      if (!curve_kind(plot_.statements[i].kind).has_own_parameter()) continue;
      statement_ = static_cast<int>(i);
      const auto arc = arc_of(plot_.statements[i], window_, 0);
      if (!arc) continue;
      ArcProbe probe(*arc);
      for (const Meeting& m : crossings_of(tracing_, statement_, statement_)) {
        const double t = same_place(probe, m.first, m.second);
        const auto v = probe.at(t);
        const bool near = std::hypot(window_.u(v.x) - m.at.u, window_.v(v.y) - m.at.v) < 1e-3;
        add(PointKind::self_crossing, near ? v.x : window_.x(m.at.u), near ? v.y : window_.y(m.at.v), t);
      }
    }
  }

  const Plot& plot_;
  const Tracing& tracing_;
  Window window_;
  std::size_t most_;
  int statement_ = 0;
  std::vector<std::size_t> counts_;
  std::vector<PointOfInterest> found_;
};

}  // namespace

std::vector<PointOfInterest> points_of_interest(const Plot& plot, const Tracing& tracing, std::size_t most) {
  if (plot.is_surface()) return {};
  return PointFinder(plot, tracing, most).run();
}

}  // namespace nazori::functions
