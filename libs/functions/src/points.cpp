// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/points.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "algebra.h"
#include "arc_points.h"
#include "arcs.h"
#include "asymptotes.h"
#include "break_places.h"
#include "equation_points.h"
#include "far_out.h"
#include "meetings.h"
#include "nazori/functions/curve_kinds.h"
#include "one_variable.h"
#include "point_list.h"

namespace nazori::functions {
namespace {

class PointFinder {
 public:
  PointFinder(const Plot& plot, const Tracing& tracing, std::size_t most)
      : plot_(plot), tracing_(tracing), list_(plot, tracing, most), branch_ends_(ends_of(tracing)) {}

  std::vector<PointOfInterest> run() {
    const auto count = static_cast<int>(plot_.statements.size());
    complete_.assign(plot_.statements.size(), false);
    for (int i = 0; i < count; ++i) solve_for_breaks(i);
    list_.set_events(exact_events());
    for (int i = 0; i < count; ++i) {
      const Statement& s = list_.statement(i);
      if (is_large(s)) continue;
      const std::vector<Arc> arcs = arcs_of(s, tracing_.window, kMargin);
      for (const Arc& arc : arcs) add_points_of(arc, i, list_);
      if (arcs.empty()) {
        if (const Expression f = equation_of(s))
          complete_[static_cast<std::size_t>(i)] = add_points_of_equation(f, i, list_);
      }
    }
    for (const Event& e : list_.events()) add(e);
    for (int i = 0; i < count; ++i) {
      add_values_at_steps(i);
      add_missed_gaps(i);
    }
    for (int i = 0; i < count; ++i) {
      if (!is_large(list_.statement(i))) add_asymptotes(i, list_);
    }
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j) {
        if (!is_large(list_.statement(i)) && !is_large(list_.statement(j))) add_meetings(i, j, list_);
      }
    }
    return list_.take();
  }

 private:
  static constexpr double kMargin = 0.02;
  // Shares of the range of the parameter.
  static constexpr double kNearBreak = 1e-6;
  // More are not told, and would take long to solve.
  static constexpr std::size_t kMostEvents = 400;

  /// Too large to be solved; what tracing found is told.
  static bool is_large(const Statement& s) {
    std::size_t n = 0;
    for (const Expression& e : s.terms) n += node_count(e);
    return n > kMostNodesOfAlgebra;
  }

  /// y = f(x) and x = g(y): where the parts of the expression break.
  void solve_for_breaks(int i) {
    breaks_.emplace_back();
    steps_.emplace_back();
    const Statement& s = list_.statement(i);
    const CurveKind& kind = curve_kind(s.kind);
    if (is_large(s) || (!kind.is_graph_of_x() && !kind.is_graph_of_y())) return;
    breaks_.back().emplace(s.terms[0], kind.parameter);
    const Window& w = tracing_.window;
    steps_.back() =
        kind.is_graph_of_x() ? breaks_.back()->steps(w.x0, w.x1) : breaks_.back()->steps(w.y0, w.y1);
  }

  [[nodiscard]] double span_of(const CurveKind& kind) const {
    const Window& w = tracing_.window;
    return kind.is_graph_of_x() ? w.x1 - w.x0 : w.y1 - w.y0;
  }

  /// Tracing encloses a break to some twelve digits; its place is solved for.
  [[nodiscard]] std::vector<Event> exact_events() const {
    std::vector<Event> events = tracing_.events;
    if (events.size() > kMostEvents) return events;
    for (Event& e : events) {
      const auto& breaks = breaks_[static_cast<std::size_t>(e.statement)];
      if (!breaks) continue;
      const CurveKind& kind = curve_kind(list_.statement(e.statement).kind);
      const auto place = breaks->near(e.parameter, kNearBreak * span_of(kind));
      if (!place) continue;
      e.parameter = place->at;
      (kind.is_graph_of_x() ? e.x : e.y) = place->at;
    }
    return events;
  }

  /// The exact value of y = f(x) at a break, NaN where there is none.
  [[nodiscard]] double value_at(int statement, double at) const {
    const auto& breaks = breaks_[static_cast<std::size_t>(statement)];
    const Statement& s = list_.statement(statement);
    if (const auto place = breaks ? breaks->near(at, kNearBreak * span_of(curve_kind(s.kind))) : std::nullopt)
      return place->value;
    return OneVariable(s.terms[0], curve_kind(s.kind).parameter).value(at);
  }

  /// A step that tracing has left undecided, beside one that is only touched.
  void add_missed_jump(int i, const BreakPlace& p, double before, double after) {
    const double span = tracing_.window.x1 - tracing_.window.x0;
    if (list_.has_break(i, p.at, kNearBreak * span)) return;
    const Expression& f = list_.statement(i).terms[0];
    Event e;
    e.kind = EventKind::jump;
    e.statement = i;
    e.parameter = e.x = e.x_after = p.at;
    e.y = limit_at(f, Variable::x, p.at, -1).value_or(before);
    e.y_after = limit_at(f, Variable::x, p.at, 1).value_or(after);
    add(e);
  }

  /// What tracing has left undecided where the expression is undefined: beside a denominator that only
  /// touches zero, as that of 1/(1 + sin(x)), and where a limit is reached slowly, as by 1/ln(x) at 0.
  void add_missed_gaps(int i) {
    const Statement& s = list_.statement(i);
    const auto& breaks = breaks_[static_cast<std::size_t>(i)];
    if (!breaks || !curve_kind(s.kind).is_graph_of_x()) return;
    const Window& w = tracing_.window;
    const double span = w.x1 - w.x0;
    const double reach = kNearBreak * span;
    const OneVariable f(s.terms[0], Variable::x);
    for (const BreakPlace& p : breaks->gaps(w.x0, w.x1)) {
      if (list_.has_break(i, p.at, reach) || list_.has_event(i, EventKind::end, p.at, reach)) continue;
      Event e;
      e.statement = i;
      e.parameter = e.x = e.x_after = p.at;
      e.y = e.y_after = PointList::kNaN;
      if (grows_towards(f, p.at, -span) || grows_towards(f, p.at, span)) {
        e.kind = EventKind::pole;
        add(e);
        continue;
      }
      const auto limit_of_side = [&](int side) {
        return std::isfinite(f.value(p.at + side * reach)) ? limit_at(s.terms[0], Variable::x, p.at, side)
                                                           : std::nullopt;
      };
      const auto before = limit_of_side(-1);
      const auto after = limit_of_side(1);
      if (!before && !after) continue;
      e.kind = before && after ? EventKind::jump : EventKind::end;
      e.y = before.value_or(after.value_or(0));
      e.y_after = after.value_or(e.y);
      if (before && after && std::abs(*before - *after) < 1e-9 * (w.y1 - w.y0)) e.kind = EventKind::hole;
      // A case of its own fills the gap: {x = 0: 1, sin(x)/x}.
      if (e.kind == EventKind::hole && p.is_step && std::isfinite(f.value(p.at))) continue;
      add(e);
    }
  }

  static bool grows_towards(const OneVariable& f, double at, double span) {
    constexpr double kGrowth = 5;
    const double near = std::abs(f.value(at + kNearBreak * span));
    return near > kGrowth * std::abs(f.value(at + 1e-3 * span)) && near > kGrowth;
  }

  /// Where the value at the edge of a step is on neither side, it is a point of its own: ceil(x) - floor(x)
  /// is 0 at whole numbers and 1 between them.
  void add_values_at_steps(int i) {
    const Statement& s = list_.statement(i);
    if (!curve_kind(s.kind).is_graph_of_x()) return;
    const Window& w = tracing_.window;
    const double span = w.x1 - w.x0;
    const OneVariable f(s.terms[0], Variable::x);
    for (const BreakPlace& p : steps_[static_cast<std::size_t>(i)]) {
      if (!p.is_step || !std::isfinite(p.value)) continue;
      const auto is_value = [&](double y) {
        return std::abs(y - p.value) < 1e-9 * std::max(1.0, std::abs(y));
      };
      const double before = f.value(p.at - kNearBreak * span);
      const double after = f.value(p.at + kNearBreak * span);
      const double slack = 1e-5 * (w.y1 - w.y0);
      if (std::abs(before - after) > slack) add_missed_jump(i, p, before, after);
      const auto joins = [&](double y) { return std::abs(y - p.value) < slack; };
      if (joins(before) || joins(after)) continue;
      if (std::abs(p.value) < 1e-12) list_.add(i, PointKind::zero, p.at, 0, p.at);
      if (p.at == 0) list_.add(i, PointKind::y_intercept, 0, p.value, 0);
      if (!(std::abs(before - after) < slack) || is_value(before)) continue;
      list_.add(i, PointKind::hole, p.at, limit((before + after) / 2), p.at);
      list_.add(i, PointKind::isolated, p.at, p.value, p.at);
    }
  }

  void add(const Event& e) {
    const CurveKind& kind = curve_kind(list_.statement(e.statement).kind);
    const auto put = [&](PointKind k, double x, double y) {
      return list_.add(e.statement, k, x, y, e.parameter);
    };
    switch (e.kind) {
      case EventKind::pole:
        add_pole(e, kind);
        break;
      case EventKind::hole:
        put(PointKind::hole, e.x, exact_limit(e, limit(e.y)));
        break;
      case EventKind::jump:
        add_jump(e, kind);
        break;
      case EventKind::end:
        // A limit that is not attained is known to some ten digits.
        if (!is_passed_through(e)) add_end(e);
        break;
      case EventKind::singular:
        if (complete_[static_cast<std::size_t>(e.statement)]) break;
        if (list_.has_near(e.statement, PointKind::cusp, e.x, e.y, 1e-3) ||
            list_.has_near(e.statement, PointKind::self_crossing, e.x, e.y, 1e-3))
          break;
        put(branches_at(e) >= 4 ? PointKind::self_crossing : PointKind::singular, e.x, e.y);
        break;
      case EventKind::isolated:
        // The value at a jump is told with the jump.
        if (!list_.has_event(e.statement, EventKind::jump, e.parameter, 1e-9) || !kind.is_graph_of_x())
          if (!list_.has_near(e.statement, PointKind::isolated, e.x, e.y, 1e-4))
            put(PointKind::isolated, e.x, e.y);
        break;
      case EventKind::limit:
        break;
    }
  }

  void add_pole(const Event& e, const CurveKind& kind) {
    if (!kind.is_graph_of_x() && !kind.is_graph_of_y()) return;
    const bool of_x = kind.is_graph_of_x();
    PointOfInterest* const p =
        of_x ? list_.add(e.statement, PointKind::vertical_asymptote, e.x, PointList::kNaN, e.parameter)
             : list_.add(e.statement, PointKind::horizontal_asymptote, PointList::kNaN, e.y, e.parameter);
    if (p == nullptr) return;
    const Arc arc = arcs_of(list_.statement(e.statement), tracing_.window, kMargin)[0];
    const OneVariable f(of_x ? arc.y : arc.x, arc.parameter);
    const auto grows = [&](int side) {
      const auto size = [&](double h) {
        return std::abs(f.value(e.parameter + side * h * (arc.to - arc.from)));
      };
      const double near = size(1e-12);
      return std::isinf(near) || near - size(1e-9) > 0.2 * std::abs(size(1e-9) - size(1e-6));
    };
    const bool before = grows(-1);
    const bool after = grows(1);
    if (before != after) p->side = before ? -1 : 1;
    p->along_y = !of_x;
  }

  /// Both sides of a jump, and the value that is taken there.
  void add_jump(const Event& e, const CurveKind& kind) {
    double before = limit(e.y);
    double after = limit(e.y_after);
    double at = PointList::kNaN;
    if (kind.is_graph_of_x()) {
      at = value_at(e.statement, e.parameter);
      before = limit_beside(e, -1, before);
      after = limit_beside(e, 1, after);
      if (std::abs(before - after) < 1e-12 * (tracing_.window.y1 - tracing_.window.y0)) {
        // sign(x) sqrt(|x|) has a step that is zero high.
        if (std::isnan(at)) list_.add(e.statement, PointKind::hole, e.x, before, e.parameter);
        return;
      }
    }
    const double y = std::isnan(at) ? before : at;
    PointOfInterest* p = list_.add(e.statement, PointKind::jump, e.x, y, e.parameter);
    if (p == nullptr) p = list_.add(e.statement, PointKind::jump, e.x, before, e.parameter);
    if (p == nullptr) p = list_.add(e.statement, PointKind::jump, e.x, after, e.parameter);
    if (p == nullptr) return;
    Jump jump;
    jump.x_before = e.x;
    jump.y_before = before;
    jump.x_after = kind.is_graph_of_x() ? e.x : limit(e.x_after);
    jump.y_after = after;
    jump.y_at = at;
    p->jump = jump;
  }

  /// The limit on one side of a break, where it can be known better than from the sample beside it.
  [[nodiscard]] double limit_beside(const Event& e, int side, double measured) const {
    const auto exact = limit_at(list_.statement(e.statement).terms[0], Variable::x, e.parameter, side);
    const double height = tracing_.window.y1 - tracing_.window.y0;
    return exact && std::abs(*exact - measured) < 1e-3 * height ? limit(*exact) : measured;
  }

  static double limit(double y) {
    const double near = std::round(y * 1e4) / 1e4;
    return std::abs(near - y) < 1e-9 * std::max(1.0, std::abs(y)) ? near : y;
  }

  void add_end(const Event& e) {
    const Statement& s = list_.statement(e.statement);
    if (!curve_kind(s.kind).is_graph_of_x() || exact_name(e.y)) {
      list_.add(e.statement, PointKind::end, e.x, exact_limit(e, limit(e.y)), e.parameter);
      return;
    }
    // sqrt(x^2 - 3) ends between two numbers: the last one with a value is not yet the end.
    const OneVariable f(s.terms[0], Variable::x);
    const double reach = 1e-9 * (tracing_.window.x1 - tracing_.window.x0);
    const bool after = std::isfinite(f.value(e.x + reach));
    if (after == std::isfinite(f.value(e.x - reach))) {
      list_.add(e.statement, PointKind::end, e.x, exact_limit(e, limit(e.y)), e.parameter);
      return;
    }
    const int side = after ? 1 : -1;
    double inside = e.x + side * reach;
    double outside = e.x - side * reach;
    for (int i = 0; i < 100; ++i) {
      const double middle = inside + (outside - inside) / 2;
      if (middle == inside || middle == outside) break;
      (std::isfinite(f.value(middle)) ? inside : outside) = middle;
    }
    const auto exact = limit_at(s.terms[0], Variable::x, inside, side);
    const double height = tracing_.window.y1 - tracing_.window.y0;
    list_.add(e.statement, PointKind::end, inside,
              exact && std::abs(*exact - e.y) < 0.01 * height ? *exact : limit(e.y), e.parameter);
  }

  /// The value that y = f(x) approaches at a place where it has none.
  [[nodiscard]] double exact_limit(const Event& e, double measured) const {
    const Statement& s = list_.statement(e.statement);
    if (!curve_kind(s.kind).is_graph_of_x()) return measured;
    if (std::isfinite(value_at(e.statement, e.parameter))) return measured;
    const double height = tracing_.window.y1 - tracing_.window.y0;
    for (const int side : {-1, 1}) {
      const auto exact = limit_at(s.terms[0], Variable::x, e.parameter, side);
      if (exact && std::abs(*exact - measured) < 0.05 * height) return *exact;
    }
    return measured;
  }

  struct BranchEnd {
    int statement;
    double u, v;
    bool operator<(const BranchEnd& other) const {
      return std::tie(statement, u) < std::tie(other.statement, other.u);
    }
  };

  [[nodiscard]] static std::vector<BranchEnd> ends_of(const Tracing& tracing) {
    std::vector<BranchEnd> ends;
    ends.reserve(2 * tracing.branches.size());
    for (const Branch& b : tracing.branches) {
      for (const CurvePoint* p : {&b.points.front(), &b.points.back()})
        ends.push_back({b.statement, p->u, p->v});
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  /// Pieces of curves that end at the event.
  [[nodiscard]] int branches_at(const Event& e) const {
    constexpr double kHere = 1e-5;
    const double u = tracing_.window.u(e.x);
    const double v = tracing_.window.v(e.y);
    int n = 0;
    for (auto end =
             std::lower_bound(branch_ends_.begin(), branch_ends_.end(), BranchEnd{e.statement, u - kHere, 0});
         end != branch_ends_.end() && end->statement == e.statement && end->u <= u + kHere; ++end)
      n += std::hypot(end->u - u, end->v - v) < kHere ? 1 : 0;
    return n;
  }

  [[nodiscard]] bool is_passed_through(const Event& e) const { return branches_at(e) >= 2; }

  const Plot& plot_;
  const Tracing& tracing_;
  PointList list_;
  std::vector<BranchEnd> branch_ends_;
  std::vector<bool> complete_;
  std::vector<std::optional<BreakPlaces>> breaks_;  // by statement
  std::vector<std::vector<BreakPlace>> steps_;
};

}  // namespace

std::vector<PointOfInterest> points_of_interest(const Plot& plot, const Tracing& tracing, std::size_t most) {
  if (plot.is_surface()) return {};
  return PointFinder(plot, tracing, most).run();
}

}  // namespace nazori::functions
