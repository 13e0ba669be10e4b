// SPDX-License-Identifier: Apache-2.0
#include "arc_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "arc_probe.h"
#include "derivative.h"
#include "nazori/functions/curve_kinds.h"
#include "one_variable.h"
#include "self_crossings.h"
#include "zeros.h"

namespace nazori::functions {
namespace {

// Slopes of waves without end need not be examined to the last.
constexpr int kSlopeBoxes = 4'000;

class ArcPoints {
 public:
  ArcPoints(const Arc& arc, int statement, PointList& list)
      : arc_(arc),
        statement_(statement),
        list_(list),
        kind_(curve_kind(list.statement(statement).kind)),
        x_(arc.x, arc.parameter),
        y_(arc.y, arc.parameter),
        span_(arc.to - arc.from) {
    const auto start = std::array{x_.value(arc.from), y_.value(arc.from)};
    const auto end = std::array{x_.value(arc.to), y_.value(arc.to)};
    const Window& w = list.window();
    closed_ = arc.ends_are_real && std::abs(start[0] - end[0]) < 1e-9 * (w.x1 - w.x0) &&
              std::abs(start[1] - end[1]) < 1e-9 * (w.y1 - w.y0);
    for (const Branch& b : list.tracing().branches) {
      if (b.statement == statement && b.has_parameter) branches_.push_back(&b);
    }
  }

  void run() {
    if (!(span_ > 0)) return;
    const Expression dx = derivative(x_.expression(), arc_.parameter);
    const Expression dy = derivative(y_.expression(), arc_.parameter);
    slope_x_ = dx ? OneVariable(dx, arc_.parameter) : OneVariable::slope_of(x_.expression(), arc_.parameter);
    slope_y_ = dy ? OneVariable(dy, arc_.parameter) : OneVariable::slope_of(y_.expression(), arc_.parameter);
    intercepts();
    if (!kind_.is_graph_of_y()) extrema();
    if (kind_.is_graph_of_x()) {
      inflections(y_, slope_y_);
      cusps_of_graph(slope_y_);
    }
    if (kind_.is_graph_of_y()) {
      inflections(x_, slope_x_);
      cusps_of_graph(slope_x_);
    }
    if (arc_.ends_are_real) {
      cusps();
      for (const SelfCrossing& c :
           self_crossings(arc_, statement_, x_, y_, slope_x_, slope_y_, list_.tracing()))
        add(PointKind::self_crossing, c.x, c.y, c.parameter);
      crossing_at_pole();
    }
  }

 private:
  /// Places where `f` is zero or changes its sign: by algebra where that finds them, else between the drawn
  /// points.
  std::vector<double> candidates(const OneVariable& f) {
    std::vector<double> all = zeros_of(f.expression(), arc_.parameter, arc_.from, arc_.to, kSlopeBoxes);
    const auto known = [&](double t) {
      const auto near = std::lower_bound(all.begin(), all.end(), t - 1e-7 * span_);
      return near != all.end() && *near <= t + 1e-7 * span_;
    };
    std::vector<double> more;
    const auto take = [&](double t, bool) {
      if (!known(t)) more.push_back(t);
    };
    const auto value = [&](double t) { return f.certain_value(t); };
    for (const Branch* b : branches_) sign_changes(b->points, value, take);
    // The drawn points of almost straight pieces are far apart.
    std::vector<CurvePoint> even(257);
    for (std::size_t i = 0; i < even.size(); ++i)
      even[i].parameter = arc_.from + span_ * (static_cast<double>(i) + 0.0137) / 256.0274;
    sign_changes(even, value, take);
    all.insert(all.end(), more.begin(), more.end());
    std::sort(all.begin(), all.end());
    std::vector<double> distinct;
    for (const double t : all) {
      if (distinct.empty() || t - distinct.back() > 1e-9 * span_) distinct.push_back(t);
    }
    return distinct;
  }

  /// The parameter of a point beside `t`: on a closed curve the other end follows the end.
  [[nodiscard]] std::optional<double> beside(double t, double step) const {
    const double s = t + step;
    if (s >= arc_.from && s <= arc_.to) return s;
    if (!closed_) return std::nullopt;
    return s < arc_.from ? s + span_ : s - span_;
  }

  /// The certain sign of `f` beside `t`, 0 where there is none.
  [[nodiscard]] int sign_beside(const OneVariable& f, double t, int side) const {
    double h = 1e-8 * span_;
    for (int i = 0; i < kSidesTried; ++i, h *= 8) {
      const auto s = beside(t, side * h);
      // Beyond a break it is the sign of another piece.
      if (!s || list_.has_break(statement_, t + side * h / 2, h / 2)) return 0;
      const double v = f.certain_value(*s);
      if (v != 0 && !std::isnan(v)) return v < 0 ? -1 : 1;
    }
    return 0;
  }

  void add(PointKind kind, double t) { add(kind, x_.value(t), y_.value(t), t); }
  /// A coordinate that is known to be zero at `t` is exactly zero.
  void add(PointKind kind, double x, double y, double t) {
    // At a break it may be zero on one side only.
    const bool is_exact = !is_broken(t);
    if (is_exact && is_among(zeros_of_x_, t)) x = 0;
    if (is_exact && is_among(zeros_of_y_, t)) y = 0;
    list_.add(statement_, kind, x, y, t);
  }
  [[nodiscard]] bool is_among(const std::vector<double>& zeros, double t) const {
    const auto near = std::lower_bound(zeros.begin(), zeros.end(), t - 1e-11 * span_);
    return near != zeros.end() && *near <= t + 1e-11 * span_;
  }

  /// Whether the curve reaches its value at `t`, at least from one side; at the border of its domain rounding
  /// may make it undefined.
  [[nodiscard]] std::optional<double> attained(double t) const {
    if (arc_.is_open_end(t) || list_.has_event(statement_, EventKind::hole, t, 1e-10 * span_))
      return std::nullopt;
    const auto exists = [&](double s) { return std::isfinite(x_.value(s)) && std::isfinite(y_.value(s)); };
    if (exists(t)) return t;
    // A number with few decimals is exact: x ln(x) has no value at 0.
    if (std::round(t * 1e6) / 1e6 == t) return std::nullopt;
    for (int ulps = 1; ulps <= 4; ++ulps) {
      const double hair = ulps * 2.3e-16 * std::max(std::abs(t), 1e-3 * span_);
      const bool before = exists(t - hair);
      const bool after = exists(t + hair);
      if (before && after) return std::nullopt;
      if (before || after) return before ? t - hair : t + hair;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::vector<double> attained(const std::vector<double>& all) const {
    std::vector<double> some;
    std::copy_if(all.begin(), all.end(), std::back_inserter(some),
                 [this](double t) { return attained(t).has_value(); });
    return some;
  }

  /// Whether the function stays what it is on one side; a sine of a step can be off zero by rounding.
  [[nodiscard]] bool is_level_beside(const OneVariable& f, double t) const {
    for (const int side : {-1, 1}) {
      const double first = f.value(t + side * 1e-9 * span_);
      bool level = f.certain_value(t + side * 1e-9 * span_) == 0;
      for (const double h : {1e-6, 1e-4}) level = level && f.value(t + side * h * span_) == first;
      if (level) return true;
    }
    return false;
  }

  void intercepts() {
    const Window& w = list_.window();
    const auto small = [](double v, double range) { return std::abs(v) <= 1e-6 * range; };
    const std::vector<double> on_x = zeros_of(y_.expression(), arc_.parameter, arc_.from, arc_.to);
    if (!kind_.is_graph_of_x())
      zeros_of_x_ = attained(zeros_of(x_.expression(), arc_.parameter, arc_.from, arc_.to));
    zeros_of_y_ = attained(on_x);
    for (const double t : zeros_of_y_) {
      const auto at = attained(t);
      // A whole piece on the axis is no point.
      if (!at || is_level_beside(y_, t)) continue;
      const double y = y_.value(*at);
      // Steep curves miss zero by rounding, but change their sign.
      // A jump over zero does not.
      const bool changes = !is_broken(t) && y_.value(t - 1e-13 * span_) * y_.value(t + 1e-13 * span_) <= 0;
      if (small(y, w.y1 - w.y0) || changes) add(PointKind::zero, x_.is_parameter() ? t : x_.value(*at), 0, t);
    }
    if (kind_.is_graph_of_x()) {
      if (w.x0 <= 0 && w.x1 >= 0 && std::isfinite(y_.value(0)) &&
          !list_.has_event(statement_, EventKind::hole, 0, 1e-10 * span_))
        add(PointKind::y_intercept, 0, y_.value(0), 0);
      return;
    }
    for (const double t : zeros_of_x_) {
      const auto at = attained(t);
      if (!at || is_level_beside(x_, t)) continue;
      if (small(x_.value(*at), w.x1 - w.x0) || x_.value(t - 1e-13 * span_) * x_.value(t + 1e-13 * span_) <= 0)
        add(PointKind::y_intercept, 0, y_.is_parameter() ? t : y_.value(*at), t);
    }
  }

  [[nodiscard]] bool is_broken(double t) const {
    return list_.has_break(statement_, t, 1e-9 * span_) || arc_.is_open_end(t);
  }

  void extrema() {
    const double height = list_.window().y1 - list_.window().y0;
    for (const double t : candidates(slope_y_)) {
      const double x = x_.value(t);
      double y = y_.value(t);
      if (!std::isfinite(x) || !std::isfinite(y) || is_broken(t)) continue;
      const int before = sign_beside(slope_y_, t, -1);
      const int after = sign_beside(slope_y_, t, 1);
      if (before * after >= 0 || !is_joined(t)) continue;
      // Where the curve turns round and goes back the same way it ends.
      if (arc_.ends_are_real && goes_back(t)) continue;
      if (std::abs(y) < 1e-15 * height) y = 0;
      add(after > 0 ? PointKind::minimum : PointKind::maximum, x, y, t);
    }
  }

  /// Whether the curve at `t` lies between close points of both sides.
  [[nodiscard]] bool is_joined(double t) const {
    const Window& w = list_.window();
    const auto gap = [&](double step) {
      const auto s = beside(t, step);
      if (!s) return 0.0;
      return std::hypot((x_.value(*s) - x_.value(t)) / (w.x1 - w.x0),
                        (y_.value(*s) - y_.value(t)) / (w.y1 - w.y0));
    };
    for (const int side : {-1, 1}) {
      const double near = gap(side * 1e-11 * span_);
      const double far = gap(side * 1e-7 * span_);
      if (!(near < 1e-6 || near < 0.5 * far)) return false;
    }
    return true;
  }

  /// Where the second derivative changes its sign and the curve has a tangent.
  void inflections(const OneVariable& value, const OneVariable& slope) {
    const Expression second = derivative(slope.expression(), arc_.parameter);
    if (!second) return;
    const OneVariable bend(second, arc_.parameter);
    for (const double t : candidates(bend)) {
      if (!std::isfinite(value.value(t)) || is_broken(t)) continue;
      const int before = sign_beside(bend, t, -1);
      const int after = sign_beside(bend, t, 1);
      if (before * after >= 0 || !has_tangent(slope, t) || !is_joined(t)) continue;
      add(PointKind::inflection, t);
    }
  }

  /// Whether the slopes of both sides approach each other: no corner and no cusp.
  [[nodiscard]] bool has_tangent(const OneVariable& slope, double t) const {
    const auto at = [&](double h) { return std::pair{slope.value(t - h), slope.value(t + h)}; };
    const auto [wide_before, wide_after] = at(1e-4 * span_);
    const auto [before, after] = at(1e-7 * span_);
    if (!std::isfinite(before) || !std::isfinite(after)) return false;
    const double size = std::max(std::abs(before), std::abs(after));
    const double gap = std::abs(before - after);
    if (gap <= 1e-6 * size + 1e-12) return true;
    // Upright: both slopes grow beyond all bounds, with one sign.
    const bool grows = size > 10 * std::max(std::abs(wide_before), std::abs(wide_after)) &&
                       before * after > 0 &&
                       std::min(std::abs(before), std::abs(after)) >
                           5 * std::min(std::abs(wide_before), std::abs(wide_after));
    return grows || gap < 0.2 * std::abs(wide_before - wide_after);
  }

  /// y = f(x) has a cusp where its slope goes to infinity with different signs on the two sides.
  void cusps_of_graph(const OneVariable& slope) {
    for (const double t : candidates(slope)) {
      if (!std::isfinite(x_.value(t)) || !std::isfinite(y_.value(t)) || is_broken(t)) continue;
      const auto at = [&](double h) { return std::pair{slope.value(t - h), slope.value(t + h)}; };
      const auto [far_before, far_after] = at(1e-5 * span_);
      const auto [before, after] = at(1e-10 * span_);
      if (before * after < 0 && std::abs(before) > 10 * std::abs(far_before) &&
          std::abs(after) > 10 * std::abs(far_after) && std::isfinite(before) && std::isfinite(after) &&
          is_joined(t))
        add(PointKind::cusp, t);
    }
  }

  /// A curve with a parameter of its own stops at a cusp and goes back.
  void cusps() {
    const Window& w = list_.window();
    const double width = w.x1 - w.x0;
    const double height = w.y1 - w.y0;
    std::vector<double> stops = zeros_of(slope_x_.expression(), arc_.parameter, arc_.from, arc_.to);
    for (const double t : zeros_of(slope_y_.expression(), arc_.parameter, arc_.from, arc_.to))
      stops.push_back(t);
    std::sort(stops.begin(), stops.end());
    double last = -1e300;
    for (const double t : stops) {
      if (t - last < 1e-7 * span_) continue;
      const double here = std::hypot(slope_x_.value(t) / width, slope_y_.value(t) / height) * span_;
      if (!(here < 1e-5)) continue;
      std::array<double, 2> way[2];
      bool known = true;
      for (const int side : {0, 1}) {
        const double h = (side == 0 ? -1 : 1) * 1e-5 * span_;
        const auto s = beside(t, h);
        known = known && s;
        if (!s) break;
        way[side] = {slope_x_.value(*s) / width, slope_y_.value(*s) / height};
        known = known && std::isfinite(way[side][0] + way[side][1]);
      }
      if (!known) continue;
      const double dot = way[0][0] * way[1][0] + way[0][1] * way[1][1];
      const double size = std::hypot(way[0][0], way[0][1]) * std::hypot(way[1][0], way[1][1]);
      last = t;
      // Where a curve turns round and goes back the same way it has an end, not a cusp.
      if (!(dot < -0.98 * size)) continue;
      add(goes_back(t) ? PointKind::end : PointKind::cusp, t);
    }
  }

  /// A polar curve that runs through the pole in two directions crosses itself there.
  void crossing_at_pole() {
    if (arc_.parameter != Variable::theta) return;
    std::optional<double> first;
    for (const double t : zeros_of_x_) {
      if (!is_among(zeros_of_y_, t)) continue;
      const double direction = std::fmod(t, std::numbers::pi);
      if (!first) first = direction;
      const double turn = std::abs(direction - *first);
      if (std::min(turn, std::abs(turn - std::numbers::pi)) < 1e-6) continue;
      add(PointKind::self_crossing, 0, 0, t);
      return;
    }
  }

  [[nodiscard]] bool goes_back(double t) const {
    const Window& w = list_.window();
    for (const double h : {1e-3, 1.7e-3, 3e-3}) {
      const auto a = beside(t, -h * span_);
      const auto b = beside(t, h * span_);
      if (!a || !b) return false;
      const double gap = std::hypot((x_.value(*a) - x_.value(*b)) / (w.x1 - w.x0),
                                    (y_.value(*a) - y_.value(*b)) / (w.y1 - w.y0));
      const double way = std::hypot((x_.value(*a) - x_.value(t)) / (w.x1 - w.x0),
                                    (y_.value(*a) - y_.value(t)) / (w.y1 - w.y0));
      if (!(gap < 1e-6 * way)) return false;
    }
    return true;
  }

  const Arc& arc_;
  int statement_;
  PointList& list_;
  const CurveKind& kind_;
  OneVariable x_;
  OneVariable y_;
  OneVariable slope_x_;
  OneVariable slope_y_;
  double span_;
  bool closed_ = false;
  std::vector<double> zeros_of_x_;  // parameters, attained
  std::vector<double> zeros_of_y_;
  std::vector<const Branch*> branches_;
};

}  // namespace

void add_points_of(const Arc& arc, int statement, PointList& list) { ArcPoints(arc, statement, list).run(); }

}  // namespace nazori::functions
