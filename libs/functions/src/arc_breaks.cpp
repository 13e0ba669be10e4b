// SPDX-License-Identifier: Apache-2.0
// What happens where a curve is not proven continuous: holes, jumps, poles, ends, single points.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "arc_tracer.h"
#include "simplest_between.h"

namespace nazori::functions {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Whether two cases meet exactly at `t`: there the curve has the value that its case gives it.
bool is_border(const Expression& e, Variable parameter, double t) {
  if (e->kind == NodeKind::function && e->function >= Function::less && e->function <= Function::equal) {
    const Expression gap = binary(NodeKind::subtract, e->arguments[0], e->arguments[1]);
    if (constant_value(substitute(gap, parameter, number(t))) == 0) return true;
  }
  const auto parts = parts_at_a_place(*e);
  return std::any_of(parts.begin(), parts.end(),
                     [&](const Expression& a) { return is_border(a, parameter, t); });
}

}  // namespace

/// The sample itself or the first reliable one in steps that double from `away` on.
ArcTracer::Sample ArcTracer::nearest_reliable(const Sample& from, double away) {
  Sample s = from;
  for (int i = 0; i < 32 && s.exists() && !is_reliable(s); ++i, away *= 2) s = sample(from.t + away);
  return s;
}

ArcTracer::Side ArcTracer::side(const Sample& near, double away) {
  // e^(1/x) is beyond every number beside its pole.
  if (std::isinf(near.u) || std::isinf(near.v)) return Side::growing;
  if (!near.exists()) return Side::undefined;
  const Sample far = sample(near.t + 64 * away);
  if (!far.exists()) return Side::settled;
  if (is_near(near, far, 4 * tolerance_)) return Side::settled;
  const Sample farther = sample(near.t + 4096 * away);
  const double step = std::hypot(near.u - far.u, near.v - far.v);
  const bool outward = std::hypot(near.u - farther.u, near.v - farther.v) > step;
  return outward || !farther.exists() ? Side::growing : Side::wandering;
}

/// Classifies a piece that is as narrow as numbers allow and still not proven continuous.
void ArcTracer::settle_break(const Sample& left, const Sample& right, const Box& box) {
  const double width = right.t - left.t;
  const Sample a = nearest_reliable(left, -width);
  const Sample b = nearest_reliable(right, width);
  const Side before = side(a, -width);
  const Side after = side(b, width);
  Sample at = sample(simplest_between(left.t, right.t));
  if (!is_reliable(at)) at.u = at.v = kNaN;
  const bool unbounded = !box.u.is_bounded() || !box.v.is_bounded();
  const double reach = left.t == a.t && right.t == b.t ? 4 * tolerance_ : cell_ / 8;
  const bool joined = is_near(a, b, reach) && before != Side::growing && after != Side::growing;
  if (joined) {
    const bool missing = !at.exists() || !is_near(at, a, reach);
    const bool given = is_border(arc_.x, arc_.parameter, at.t) || is_border(arc_.y, arc_.parameter, at.t);
    if (is_inside(a) && (missing || (has(box.cause(), Cause::pole) && !given))) {
      Sample hole = a;
      hole.t = at.t;
      hole.u = (a.u + b.u) / 2;
      hole.v = (a.v + b.v) / 2;
      add_event(EventKind::hole, hole);
    }
    extend(a, b);
    if (at.exists() && !is_near(at, a, reach) && is_inside(at)) {
      out_.dots.push_back({statement_, {at.u, at.v}});
      add_event(EventKind::isolated, at);
    }
    return;
  }
  end_branch();
  const bool limits = before == Side::settled || after == Side::settled;
  const bool in_view = (a.exists() && is_inside(a)) || (b.exists() && is_inside(b));
  if (at.exists() && is_inside(at) && !is_near(at, a, reach) && !is_near(at, b, reach) &&
      (limits || (!a.exists() && !b.exists()))) {
    out_.dots.push_back({statement_, {at.u, at.v}});
    add_event(EventKind::isolated, at);
  }
  const auto has_grown = [&](Side s, const Sample& p) {
    return s == Side::growing || (s == Side::settled && !is_inside(p));
  };
  const bool grown = has_grown(before, a) || has_grown(after, b);
  if (unbounded && grown) add_event(EventKind::pole, {at.t, at.u, kNaN});
  if (before == Side::settled && after == Side::settled && in_view && !(unbounded && grown)) {
    Sample from = a;
    from.t = at.t;
    add_event(EventKind::jump, from, &b);
    return;
  }
  for (const auto& [which, point] : {std::pair{before, a}, std::pair{after, b}}) {
    if (which != Side::settled || !is_inside(point)) continue;
    // The end itself if it belongs to the curve, else the last number before it.
    const bool attained = is_near(at, point, reach);
    add_event(EventKind::end, attained ? at : Sample{at.t, point.u, point.v});
  }
}

void ArcTracer::add_event(EventKind kind, const Sample& at, const Sample* after) {
  for (const Event& other : out_.events) {
    // One break can appear in two neighbouring pieces.
    if (other.kind == kind && other.statement == statement_ && kind != EventKind::end &&
        std::abs(other.parameter - at.t) < 1e-11 * (arc_.to - arc_.from))
      return;
  }
  Event e;
  e.kind = kind;
  e.statement = statement_;
  e.parameter = at.t + 0.0;  // no negative zero
  e.x = arc_.x->kind == NodeKind::variable && arc_.x->variable == arc_.parameter ? e.parameter
                                                                                 : out_.window.x(at.u);
  e.y = arc_.y->kind == NodeKind::variable && arc_.y->variable == arc_.parameter ? e.parameter
                                                                                 : out_.window.y(at.v);
  e.x_after = after != nullptr ? out_.window.x(after->u) : kNaN;
  e.y_after = after != nullptr ? out_.window.y(after->v) : kNaN;
  out_.events.push_back(e);
}

}  // namespace nazori::functions
