// SPDX-License-Identifier: Apache-2.0
#include "meetings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "algebra.h"
#include "arc_probe.h"
#include "arcs.h"
#include "equation_points.h"
#include "one_variable.h"
#include "plane_system.h"
#include "zeros.h"

namespace nazori::functions {
namespace {

constexpr int kMostBoxes = 40'000;

Expression difference(const Expression& a, const Expression& b) { return binary(NodeKind::subtract, a, b); }

class Meetings {
 public:
  Meetings(int first, int second, PointList& list) : first_(first), second_(second), list_(list) {}

  void run() {
    const Statement& a = list_.statement(first_);
    const Statement& b = list_.statement(second_);
    const std::vector<Arc> arcs_a = arcs_of(a, list_.window());
    const std::vector<Arc> arcs_b = arcs_of(b, list_.window());
    const Expression fa = equation_of(a);
    const Expression fb = equation_of(b);
    if (!arcs_a.empty() && fb) {
      for (const Arc& arc : arcs_a) along(arc, fb);
    } else if (!arcs_b.empty() && fa) {
      for (const Arc& arc : arcs_b) along(arc, fa);
    } else if (fa && fb) {
      of_equations(fa, fb);
    } else {
      for (const Arc& p : arcs_a) {
        for (const Arc& q : arcs_b) of_arcs(p, q);
      }
    }
  }

 private:
  void add(bool crosses, double x, double y, double parameter) {
    const PointKind other = crosses ? PointKind::touching : PointKind::crossing;
    // Two arcs of one statement can meet the other one in the same place.
    if (list_.has_near(first_, other, x, y, 1e-6)) return;
    list_.add(first_, crosses ? PointKind::crossing : PointKind::touching, x, y, parameter, second_);
  }

  /// The other equation, followed along the arc, is a function of one variable.
  void along(const Arc& arc, const Expression& f) {
    // The placeholder keeps the second substitution from changing the result of the first.
    const Expression with_x = substitute(f, Variable::x, variable(Variable::z));
    const Expression with_y = substitute(with_x, Variable::y, arc.y);
    const Expression along = reduced(substitute(with_y, Variable::z, arc.x));
    const auto p = Polynomial::of(over_common_denominator(along).numerator);
    if (p && p->is_zero()) return;
    const OneVariable g(along, arc.parameter);
    const OneVariable x(arc.x, arc.parameter);
    const OneVariable y(arc.y, arc.parameter);
    const double span = arc.to - arc.from;
    for (double t : zeros_of(g.expression(), arc.parameter, arc.from, arc.to)) {
      if (arc.is_open_end(t)) continue;
      if (!std::isfinite(x.value(t)) || !std::isfinite(y.value(t))) {
        // At the border of a domain rounding may make it undefined, on one side only.
        const double hair = 4.6e-16 * std::max(std::abs(t), 1e-3 * span);
        const bool before = std::isfinite(y.value(t - hair)) && std::isfinite(x.value(t - hair));
        const bool after = std::isfinite(y.value(t + hair)) && std::isfinite(x.value(t + hair));
        if (before == after) continue;
        t += before ? -hair : hair;
      }
      const int before = sign_beside(g, t, -1, arc);
      const int after = sign_beside(g, t, 1, arc);
      // A jump over the other curve meets it only where it takes a value on it.
      if (!(std::abs(g.value(t)) <= 1e-6 * reach(g, t, span)) && list_.has_break(first_, t, 1e-9 * span))
        continue;
      add(before * after <= 0, x.value(t), y.value(t), t);
    }
  }

  static double reach(const OneVariable& g, double t, double span) {
    return std::max({std::abs(g.value(t - 1e-3 * span)), std::abs(g.value(t + 1e-3 * span)), 1e-12});
  }

  static int sign_beside(const OneVariable& g, double t, int side, const Arc& arc) {
    const double span = arc.to - arc.from;
    double h = 1e-8 * span;
    for (int i = 0; i < kSidesTried; ++i, h *= 8) {
      const double v = g.certain_value(t + side * h);
      if (v != 0 && !std::isnan(v)) return v < 0 ? -1 : 1;
    }
    return 0;
  }

  void of_equations(const Expression& fa, const Expression& fb) {
    const Window& w = list_.window();
    const Expression f = square_free(fa);
    const Expression g = square_free(fb);
    const std::array<Expression, 2> both{f, g};
    const SystemRoots found =
        solve_system(both, {Variable::x, Variable::y}, {w.x0, w.y0}, {w.x1, w.y1}, kMostBoxes);
    const Tape tape = Tape::compile(both, std::array{Variable::x, Variable::y});
    std::vector<double> registers(tape.size());
    for (const SystemRoot& r : found.roots) add(r.simple || alternates(tape, registers, r), r.a, r.b, 0);
  }

  /// Whether the arms of both curves alternate around a point: then they cross there.
  bool alternates(const Tape& tape, std::vector<double>& registers, const SystemRoot& r) const {
    constexpr int kSteps = 720;
    const Window& w = list_.window();
    const auto value = [&](double angle, std::size_t k) {
      tape.evaluate<double>(std::array{r.a + 1e-3 * (w.x1 - w.x0) * std::cos(angle),
                                       r.b + 1e-3 * (w.y1 - w.y0) * std::sin(angle)},
                            registers);
      return registers[tape.output(k)];
    };
    const auto angle = [](int i) { return 0.0007 + 2 * std::numbers::pi * i / kSteps; };
    std::vector<std::pair<double, int>> arms;
    for (std::size_t k = 0; k < 2; ++k) {
      double last = value(angle(0), k);
      for (int i = 1; i <= kSteps; ++i) {
        const double next = value(angle(i % kSteps), k);
        if ((next < 0) != (last < 0)) {
          // Arms of curves that touch are close to each other.
          arms.emplace_back(bisect(angle(i - 1), angle(i), [&](double at) { return value(at, k); }),
                            static_cast<int>(k));
        }
        last = next;
      }
    }
    std::sort(arms.begin(), arms.end());
    std::vector<int> order;
    order.reserve(arms.size());
    for (const auto& arm : arms) order.push_back(arm.second);
    // Between two arms of one curve there is an odd number of arms of the other.
    for (std::size_t i = 0; i < order.size(); ++i) {
      int between = 0;
      for (std::size_t j = 1; j < order.size(); ++j) {
        if (order[(i + j) % order.size()] == order[i]) break;
        ++between;
      }
      if (between % 2 == 1) return true;
    }
    return false;
  }

  /// Two arcs: one equation for x and one for y in both parameters.
  void of_arcs(const Arc& p, const Arc& q) {
    const auto as = [](const Expression& e, Variable from, Variable to) {
      return substitute(e, from, variable(to));
    };
    const std::array<Expression, 2> both{
        difference(reduced(as(p.x, p.parameter, Variable::x)), reduced(as(q.x, q.parameter, Variable::y))),
        difference(reduced(as(p.y, p.parameter, Variable::x)), reduced(as(q.y, q.parameter, Variable::y)))};
    const OneVariable x(p.x, p.parameter);
    const OneVariable y(p.y, p.parameter);
    const double hair_p = 1e-9 * (p.to - p.from);
    const double hair_q = 1e-9 * (q.to - q.from);
    for (const SystemRoot& r :
         solve_system(both, {Variable::x, Variable::y}, {p.from, q.from}, {p.to, q.to}, kMostBoxes).roots) {
      if (r.a < p.from - hair_p || r.a > p.to + hair_p || r.b < q.from - hair_q || r.b > q.to + hair_q)
        continue;
      if (p.is_open_end(r.a) || q.is_open_end(r.b)) continue;
      add(r.simple, x.value(r.a), y.value(r.a), r.a);
    }
  }

  int first_;
  int second_;
  PointList& list_;
};

}  // namespace

void add_meetings(int first, int second, PointList& list) { Meetings(first, second, list).run(); }

}  // namespace nazori::functions
