// SPDX-License-Identifier: Apache-2.0
#include "equation_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "algebra.h"
#include "arc_probe.h"
#include "derivative.h"
#include "nazori/functions/tape.h"
#include "plane_system.h"
#include "zeros.h"

namespace nazori::functions {
namespace {

constexpr int kMostBoxes = 20'000;
constexpr std::ptrdiff_t kMostLines = 1000;

// Sines of the least angles at which an arm of a cusp, and of a corner, leads up or down.
constexpr double kSteep = 0.7;
constexpr double kSlanted = 0.01;

std::vector<Expression> edges_of(const Expression& e);

class EquationPoints {
 public:
  EquationPoints(const Expression& f, int statement, PointList& list)
      : whole_(reduced(f)),
        f_(square_free(f)),
        statement_(statement),
        list_(list),
        whole_tape_(Tape::compile(std::array{whole_}, std::array{Variable::x, Variable::y})),
        tape_(Tape::compile(std::array{f_}, std::array{Variable::x, Variable::y})),
        values_(std::max(whole_tape_.size(), tape_.size())) {}

  bool run() {
    intercepts();
    // So many lines have more points than can be told: those that tracing found are enough.
    const auto& branches = list_.tracing().branches;
    const auto lines = std::count_if(branches.begin(), branches.end(),
                                     [this](const Branch& b) { return b.statement == statement_; });
    if (lines > kMostLines) return false;
    const Expression fx = derivative(f_, Variable::x);
    const Expression fy = derivative(f_, Variable::y);
    if (!fx || !fy) return false;
    const Window& w = list_.window();
    const std::array low{w.x0, w.y0};
    const std::array high{w.x1, w.y1};
    const std::array variables{Variable::x, Variable::y};
    for (const Expression& u : edges_of(f_)) corners_along(u);
    const std::array<Expression, 3> singular{fx, fy, f_};
    const SystemRoots stops = solve_system(singular, variables, low, high, kMostBoxes);
    for (const SystemRoot& r : stops.roots) {
      if (is_defined(r.a, r.b) && !is_corner(r.a, r.b)) classify(r.a, r.b);
    }
    if (depends_on(f_, Variable::x) && depends_on(f_, Variable::y)) {
      const std::array<Expression, 2> level{f_, fx};
      const Expression bend = derivative(fx, Variable::x);
      if (bend) bend_ = Tape::compile(std::array{bend, fy}, std::array{Variable::x, Variable::y});
      for (const SystemRoot& r : solve_system(level, variables, low, high, kMostBoxes).roots) {
        if (is_defined(r.a, r.b) && !is_corner(r.a, r.b)) extremum(r.a, r.b);
      }
    }
    return stops.complete;
  }

 private:
  double value(double x, double y) {
    tape_.evaluate<double>(std::array{x, y}, values_);
    return values_[tape_.output(0)];
  }
  bool exists(double x, double y) {
    whole_tape_.evaluate<double>(std::array{x, y}, values_);
    return std::isfinite(values_[whole_tape_.output(0)]);
  }

  /// Whether the equation as typed is defined there, at least from one side of a border of its domain.
  bool is_defined(double x, double y) {
    if (exists(x, y)) return true;
    // Numbers with few decimals are exact: there it is undefined indeed.
    const auto is_round = [](double v) { return std::round(v * 1e6) / 1e6 == v; };
    if (is_round(x) && is_round(y)) return false;
    const Window& w = list_.window();
    const double hx = 4e-16 * std::max(std::abs(x), 1e-3 * (w.x1 - w.x0));
    const double hy = 4e-16 * std::max(std::abs(y), 1e-3 * (w.y1 - w.y0));
    int count = 0;
    for (const int i : {-1, 0, 1}) {
      for (const int j : {-1, 0, 1}) count += exists(x + i * hx, y + j * hy) ? 1 : 0;
    }
    // All around but not at the point itself: a gap.
    return count > 0 && count < 8;
  }

  void intercepts() {
    const Window& w = list_.window();
    const auto along = [&](Variable fixed, Variable free, double low, double high, PointKind kind) {
      const Expression on_axis = reduced(substitute(whole_, fixed, number(0)));
      const auto p = Polynomial::of(over_common_denominator(on_axis).numerator);
      if (p && p->is_zero()) return;
      for (const double at : zeros_of(on_axis, free, low, high)) {
        const bool zero = kind == PointKind::zero;
        const double x = zero ? at : 0;
        const double y = zero ? 0 : at;
        if (is_defined(x, y)) list_.add(statement_, kind, x, y);
      }
    };
    if (w.y0 <= 0 && w.y1 >= 0) along(Variable::y, Variable::x, w.x0, w.x1, PointKind::zero);
    if (w.x0 <= 0 && w.x1 >= 0) along(Variable::x, Variable::y, w.y0, w.y1, PointKind::y_intercept);
  }

  /// Directions in which the curve leaves a point: changes of sign on a small circle of the plate.
  std::vector<double> arms(double x, double y, double radius) {
    constexpr int kSteps = 1440;
    const Window& w = list_.window();
    const auto at = [&](double angle) {
      return value(x + radius * (w.x1 - w.x0) * std::cos(angle),
                   y + radius * (w.y1 - w.y0) * std::sin(angle));
    };
    // Off round angles, so that no arm runs exactly through a sample.
    const auto angle = [](int i) { return 0.0007 + 2 * std::numbers::pi * i / kSteps; };
    std::vector<double> values(kSteps + 1);
    for (int i = 0; i <= kSteps; ++i) values[static_cast<std::size_t>(i)] = at(angle(i % kSteps));
    std::vector<double> all;
    for (int i = 1; i <= kSteps; ++i) {
      const double last = values[static_cast<std::size_t>(i - 1)];
      const double here = values[static_cast<std::size_t>(i)];
      const double next = values[static_cast<std::size_t>(i % kSteps + 1)];
      if (std::isfinite(last) && std::isfinite(here) && (last < 0) != (here < 0))
        all.push_back((angle(i - 1) + angle(i)) / 2);
      const bool turns = (last < 0) == (here < 0) && (here < 0) == (next < 0) &&
                         std::abs(here) <= std::abs(last) && std::abs(here) <= std::abs(next);
      if (turns) add_close_arms(at, angle(i - 1), angle(i + 1), all);
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  /// Two arms between neighbouring samples, as where two lines touch: there the value turns beyond zero.
  template <class F>
  static void add_close_arms(const F& at, double low, double high, std::vector<double>& all) {
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kTurns = 45;
    const double sign = at(low) < 0 ? -1 : 1;
    const double from = low;
    const double to = high;
    for (int i = 0; i < kTurns; ++i) {
      const double a = high - kGolden * (high - low);
      const double b = low + kGolden * (high - low);
      const double value_a = sign * at(a);
      const double value_b = sign * at(b);
      if (std::min(value_a, value_b) < 0) {
        const double beyond = value_a < value_b ? a : b;
        all.push_back(bisect(from, beyond, at));
        all.push_back(bisect(beyond, to, at));
        return;
      }
      (value_a < value_b ? high : low) = value_a < value_b ? b : a;
    }
  }

  static double apart(const std::vector<double>& two) {
    const double angle = two[1] - two[0];
    return std::min(angle, 2 * std::numbers::pi - angle);
  }

  /// Towards the tip of a cusp both arms come closer; in a corner they keep their angle.
  static bool narrows(const std::vector<double>& wide, const std::vector<double>& near) {
    constexpr double kCloser = 0.75;
    return wide.size() == 2 && near.size() == 2 && apart(near) < 0.5 * std::numbers::pi &&
           apart(near) < kCloser * apart(wide);
  }

  /// A cusp that points up or down is the highest or the lowest place around, too.
  void add_cusp(double x, double y, const std::vector<double>& arms) {
    list_.add(statement_, PointKind::cusp, x, y);
    add_if_both_on_one_side(x, y, arms, kSteep);
  }

  void add_if_both_on_one_side(double x, double y, const std::vector<double>& arms, double least) {
    const double a = std::sin(arms[0]);
    const double b = std::sin(arms[1]);
    if (a > least && b > least) list_.add(statement_, PointKind::minimum, x, y);
    if (a < -least && b < -least) list_.add(statement_, PointKind::maximum, x, y);
  }

  /// The places of the curve at which `edge` is zero.
  void corners_along(const Expression& edge) {
    const Window& w = list_.window();
    const std::array low{w.x0, w.y0};
    const std::array high{w.x1, w.y1};
    const std::array variables{Variable::x, Variable::y};
    const auto take = [this](double x, double y) {
      if (is_defined(x, y)) corner(x, y);
    };
    const bool has_x = depends_on(edge, Variable::x);
    if (has_x && depends_on(edge, Variable::y)) {
      for (const SystemRoot& r : solve_system(std::array{f_, edge}, variables, low, high, kMostBoxes).roots)
        take(r.a, r.b);
      return;
    }
    const std::size_t fixed = has_x ? 0 : 1;
    const std::size_t free = 1 - fixed;
    for (const double c : zeros_of(edge, variables[fixed], low[fixed], high[fixed])) {
      const Expression on_line = reduced(substitute(f_, variables[fixed], number(c)));
      const auto p = Polynomial::of(over_common_denominator(on_line).numerator);
      if (p && p->is_zero()) continue;
      for (const double at : zeros_of(on_line, variables[free], low[free], high[free]))
        take(has_x ? c : at, has_x ? at : c);
    }
  }

  /// Where the equation has no gradient, as |x| + |y| = 1 on the axes: the arms tell what is there.
  void corner(double x, double y) {
    if (is_corner(x, y)) return;
    corners_.push_back({x, y});
    const std::vector<double> wide = arms(x, y, 1e-3);
    const std::vector<double> near = arms(x, y, 1e-4);
    if (std::min(wide.size(), near.size()) >= 4) {
      list_.add(statement_, PointKind::self_crossing, x, y);
      return;
    }
    if (wide.empty() && near.empty() && is_defined_around(x, y))
      list_.add(statement_, PointKind::isolated, x, y);
    if (near.size() != 2 || wide.size() != 2) return;
    if (narrows(wide, near)) {
      add_cusp(x, y, near);
    } else {
      add_if_both_on_one_side(x, y, near, kSlanted);
    }
  }

  [[nodiscard]] bool is_defined_around(double x, double y) {
    constexpr int kSteps = 16;
    const Window& w = list_.window();
    for (int i = 0; i < kSteps; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSteps;
      if (!exists(x + 1e-4 * (w.x1 - w.x0) * std::cos(angle), y + 1e-4 * (w.y1 - w.y0) * std::sin(angle)))
        return false;
    }
    return true;
  }

  [[nodiscard]] bool is_corner(double x, double y) const {
    const Window& w = list_.window();
    return std::any_of(corners_.begin(), corners_.end(), [&](const std::array<double, 2>& c) {
      return std::hypot((c[0] - x) / (w.x1 - w.x0), (c[1] - y) / (w.y1 - w.y0)) < 1e-6;
    });
  }

  void classify(double x, double y) {
    const std::vector<double> wide = arms(x, y, 1e-3);
    const std::vector<double> near = arms(x, y, 1e-4);
    const std::size_t count = std::min(wide.size(), near.size());
    if (count >= 4) {
      list_.add(statement_, PointKind::self_crossing, x, y);
      return;
    }
    if (count == 0 && wide.empty()) {
      list_.add(statement_, PointKind::isolated, x, y);
      return;
    }
    if (near.size() == 2) {
      if (narrows(wide, near)) add_cusp(x, y, near);
      return;
    }
    if (near.empty()) {
      // Too narrow for this circle: a cusp has both arms on one side.
      if (wide.size() == 2 && std::abs(wide[1] - wide[0]) < 1) list_.add(statement_, PointKind::cusp, x, y);
    }
  }

  /// A level place of higher order, the top of x^4 + y^4 = 1: beside it the curve is -F/Fy above its height.
  bool flat_extremum(double x, double y) {
    if (!bend_) return false;
    const double width = list_.window().x1 - list_.window().x0;
    const double height = list_.window().y1 - list_.window().y0;
    std::vector<double> registers(bend_->size());
    bend_->evaluate<double>(std::array{x, y}, registers);
    const double fy = registers[bend_->output(1)];
    if (!std::isfinite(fy) || fy == 0) return false;
    for (const double h : {1e-3, 4e-3, 1.6e-2}) {
      const double before = -value(x - h * width, y) / fy;
      const double after = -value(x + h * width, y) / fy;
      const bool certain = std::min(std::abs(before), std::abs(after)) > 1e-12 * height;
      if (!certain || !std::isfinite(before + after)) continue;
      if (before * after > 0)
        list_.add(statement_, before > 0 ? PointKind::minimum : PointKind::maximum, x, y);
      return true;
    }
    return false;
  }

  /// A level place of the curve: it is the highest or the lowest around if both arms run to one side.
  void extremum(double x, double y) {
    for (const PointKind k : {PointKind::cusp, PointKind::self_crossing, PointKind::isolated}) {
      if (list_.has_near(statement_, k, x, y, 1e-5)) return;
    }
    if (bend_) {
      // Where the curve is level it bends by y'' = -Fxx/Fy.
      std::vector<double> registers(bend_->size());
      bend_->evaluate<double>(std::array{x, y}, registers);
      const double fxx = registers[bend_->output(0)] * (list_.window().x1 - list_.window().x0);
      const double fy = registers[bend_->output(1)] * (list_.window().y1 - list_.window().y0);
      if (std::isfinite(fxx + fy) && std::abs(fxx) > 1e-6 * std::abs(fy) && fy != 0) {
        list_.add(statement_, fxx / fy < 0 ? PointKind::minimum : PointKind::maximum, x, y);
        return;
      }
    }
    if (flat_extremum(x, y)) return;
    const std::vector<double> all = arms(x, y, 1e-4);
    if (all.size() != 2) return;
    const double first = std::sin(all[0]);
    const double second = std::sin(all[1]);
    const bool level =
        std::cos(all[0]) * std::cos(all[1]) < 0 && std::abs(first) < 0.5 && std::abs(second) < 0.5;
    // A lone flat arm is hard to see on a small circle: the wide one decides.
    const std::vector<double> wide = arms(x, y, 3e-3);
    if (!level || wide.size() != 2) return;
    const double a = std::sin(wide[0]);
    const double b = std::sin(wide[1]);
    if (std::abs(a) < 1e-3 && std::abs(b) < 1e-3) return;
    if (a > 0 && b > 0) list_.add(statement_, PointKind::minimum, x, y);
    if (a < 0 && b < 0) list_.add(statement_, PointKind::maximum, x, y);
  }

  Expression whole_;
  Expression f_;
  int statement_;
  PointList& list_;
  Tape whole_tape_;
  Tape tape_;
  std::vector<double> values_;
  std::optional<Tape> bend_;
  std::vector<std::array<double, 2>> corners_;
};

/// Where the parts of an expression have no derivative: the arguments of |u| and of roots, the differences of
/// what min and max compare.
void collect_edges(const Expression& e, std::map<std::string, Expression>& found) {
  for (const Expression& a : parts_at_a_place(*e)) collect_edges(a, found);
  Expression edge;
  const auto& a = e->arguments;
  if (e->kind == NodeKind::power) {
    const auto n = rational_value(a[1]);
    if (n && n->q > 1) edge = a[0];
  }
  if (e->kind == NodeKind::function) {
    const Function f = e->function;
    if (f == Function::abs || f == Function::sqrt || f == Function::cbrt) edge = a[0];
    if (f == Function::root) edge = a[1];
    if ((f == Function::min || f == Function::max) && a.size() == 2)
      edge = binary(NodeKind::subtract, a[0], a[1]);
  }
  if (edge && !variables_of(edge).empty()) found.emplace(to_text(edge), edge);
}

std::vector<Expression> edges_of(const Expression& e) {
  constexpr std::size_t kMostEdges = 8;
  std::map<std::string, Expression> found;
  collect_edges(e, found);
  std::vector<Expression> all;
  if (found.size() > kMostEdges) return all;
  for (const auto& [text, edge] : found) all.push_back(edge);
  return all;
}

}  // namespace

Expression square_free(const Expression& f) {
  const Expression whole = without_even_roots(reduced(f));
  Expression numerator = over_common_denominator(whole).numerator;
  if (node_count(numerator) > 12 * node_count(whole) + 40) numerator = whole;
  Expression product;
  std::set<std::string> known;
  const auto take = [&](const Expression& part) {
    if (variables_of(part).empty() || !known.insert(to_text(part)).second) return;
    product = product ? binary(NodeKind::multiply, product, part) : part;
  };
  for (const Expression& factor : zero_factors(numerator)) {
    const auto p = Polynomial::of(factor);
    const Expression root = p ? p->square_root() : nullptr;
    if (!root) {
      take(factor);
      continue;
    }
    for (const Expression& part : zero_factors(root)) take(part);
  }
  return product ? product : whole;
}

bool add_points_of_equation(const Expression& f, int statement, PointList& list) {
  return EquationPoints(f, statement, list).run();
}

}  // namespace nazori::functions
