// SPDX-License-Identifier: Apache-2.0
#include "arc_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra.h"

namespace nazori::functions {
namespace {

constexpr int kFirstPieces = 64;
constexpr int kMostDepth = 90;
// Breaks are enclosed down to this part of the range.
constexpr double kBreakPart = 0x1p-44;
// Poles without end, as of tan(1/x): after this many narrow pieces with a break the rest stays undecided.
constexpr std::int64_t kMostNarrowBreaks = 40'000;
constexpr std::size_t kMostPlaces = 1000;
// Off the middle, so that a break at a round number does not fall on a border.
constexpr double kSplit = 0.49731;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Interval narrowed(const Interval& i) { return i; }
Interval narrowed(const LongInterval& i) {
  constexpr long double kMost = std::numeric_limits<double>::max();
  const auto low = static_cast<double>(std::clamp(i.lower, -kMost, kMost));
  const auto high = static_cast<double>(std::clamp(i.upper, -kMost, kMost));
  if (i.is_empty()) return Interval::empty(i.cause);
  return {std::isinf(i.lower) ? -Rounding<double>::kInf : Rounding<double>::down(low),
          std::isinf(i.upper) ? Rounding<double>::kInf : Rounding<double>::up(high), i.decoration, i.cause};
}

Interval scaled(Interval i, double origin, double scale) {
  if (i.is_empty()) return i;
  return {(i.lower - origin) * scale, (i.upper - origin) * scale, i.decoration, i.cause};
}

}  // namespace

double simplest_between(double low, double high) {
  double scale = 1;
  for (int digits = 0; digits <= 15; ++digits, scale *= 10) {
    const double candidate = std::round(low / 2 * scale + high / 2 * scale) / scale;
    if (candidate >= low && candidate <= high) return candidate == 0 ? 0 : candidate;
  }
  return low + (high - low) / 2;
}

bool ArcTracer::Sample::exists() const { return std::isfinite(u) && std::isfinite(v); }

ArcTracer::ArcTracer(const Arc& arc, int statement, const TraceSettings& settings, Tracing& out,
                     WorkProgress& progress)
    : arc_(arc),
      statement_(statement),
      settings_(settings),
      out_(out),
      progress_(progress),
      tape_(Tape::compile(std::array{improved(arc.x), improved(arc.y)}, std::array{arc.parameter})),
      tolerance_(1.0 / (16.0 * std::max(settings.resolution, 256))),
      cell_(1.0 / settings.resolution),
      scale_{1 / (out.window.x1 - out.window.x0), 1 / (out.window.y1 - out.window.y0)},
      values_(tape_.size()),
      long_values_(tape_.can_overflow() ? tape_.size() : 0),
      duals_(tape_.size()),
      long_duals_(tape_.can_overflow() ? tape_.size() : 0),
      first_bar_(out.bars.size()) {}

ArcTracer::Sample ArcTracer::sample(double t) {
  tape_.evaluate<double>(std::array{t}, values_);
  double x = values_[tape_.output(0)];
  double y = values_[tape_.output(1)];
  if (tape_.can_overflow() && !(std::isfinite(x) && std::isfinite(y))) {
    tape_.evaluate<long double>(std::array{static_cast<long double>(t)}, long_values_);
    x = static_cast<double>(long_values_[tape_.output(0)]);
    y = static_cast<double>(long_values_[tape_.output(1)]);
  }
  return {t, out_.window.u(x), out_.window.v(y)};
}

template <class R>
ArcTracer::Box ArcTracer::enclose_with(double from, double to,
                                       std::vector<Dual<BasicInterval<R>, 1>>& registers) {
  using D = Dual<BasicInterval<R>, 1>;
  tape_.evaluate<D>(std::array{D(BasicInterval<R>(static_cast<R>(from), static_cast<R>(to)), 0)}, registers);
  const D& x = registers[tape_.output(0)];
  const D& y = registers[tape_.output(1)];
  return {scaled(narrowed(x.value), out_.window.x0, scale_[0]),
          scaled(narrowed(y.value), out_.window.y0, scale_[1]), scaled(narrowed(x.slopes[0]), 0, scale_[0]),
          scaled(narrowed(y.slopes[0]), 0, scale_[1])};
}

ArcTracer::Box ArcTracer::enclose(double from, double to) {
  Box box = enclose_with<double>(from, to, duals_);
  if (tape_.can_overflow() && has(box.cause(), Cause::overflow) && !is_outside(box))
    box = enclose_with<long double>(from, to, long_duals_);
  return box;
}

/// Whether rounding leaves the sample where it is drawn: near removable gaps, (1 - cos x)/x^2, it does not.
bool ArcTracer::is_reliable(const Sample& s) {
  if (!s.exists() || !is_inside(s)) return true;
  const Box box = enclose(s.t, s.t);
  return std::max(box.u.width(), box.v.width()) <= 4 * tolerance_;
}

/// The sample itself or the first reliable one in steps that double from `away` on.
ArcTracer::Sample ArcTracer::nearest_reliable(const Sample& from, double away) {
  Sample s = from;
  for (int i = 0; i < 32 && s.exists() && !is_reliable(s); ++i, away *= 2) s = sample(from.t + away);
  return s;
}

bool ArcTracer::run() {
  branch_.statement = statement_;
  branch_.has_parameter = true;
  if (arc_.from == arc_.to) {
    const Sample only = sample(arc_.from);
    if (only.exists() && is_inside(only)) out_.dots.push_back({statement_, {only.u, only.v}});
    return true;
  }
  Sample a = sample(arc_.from);
  const Sample first = a;
  for (int i = 0; i < kFirstPieces; ++i) {
    const double share = static_cast<double>(i + 1) / kFirstPieces;
    // Borders bent a little off round numbers, the ends kept.
    const double bent = share + 0.0137 * share * (1 - share);
    const Sample b = sample(i + 1 == kFirstPieces ? arc_.to : arc_.from + (arc_.to - arc_.from) * bent);
    if (!progress_.report(share - 1.0 / kFirstPieces)) return false;
    visit(a, b, 0);
    if (progress_.is_stopped()) return false;
    a = b;
  }
  end_branch();
  out_.undecided_cells += static_cast<std::int64_t>(std::ceil(undecided_area_ / (cell_ * cell_) - 1e-3));
  if (arc_.ends_are_real) {
    const bool closed = is_near(first, a, 4 * tolerance_);
    for (const Sample& end : {first, a}) {
      if (!closed && end.exists() && is_inside(end)) add_event(EventKind::end, end);
    }
  }
  return true;
}

bool ArcTracer::is_inside(const Sample& s) const {
  const double m = settings_.margin;
  return s.u >= -m && s.u <= 1 + m && s.v >= -m && s.v <= 1 + m;
}

bool ArcTracer::is_outside(const Box& box) const {
  const double m = settings_.margin;
  return box.u.lower > 1 + m || box.u.upper < -m || box.v.lower > 1 + m || box.v.upper < -m;
}

bool ArcTracer::is_near(const Sample& a, const Sample& b, double distance) const {
  return a.exists() && b.exists() && std::hypot(a.u - b.u, a.v - b.v) <= distance;
}

bool ArcTracer::is_straight(const Sample& a, const Sample& b, const Box& box) const {
  if (!a.exists() || !b.exists()) return false;
  if (std::max(box.u.width(), box.v.width()) < tolerance_) return true;
  if (!box.slope_u.is_bounded() || !box.slope_v.is_bounded()) return false;
  // A function with slopes in [s, S] strays from its chord by at most (b - a)(S - s)/4.
  const double quarter = (b.t - a.t) / 4;
  const double stray_u = quarter * box.slope_u.width();
  const double stray_v = quarter * box.slope_v.width();
  const double length = std::hypot(b.u - a.u, b.v - a.v);
  if (length == 0) return std::hypot(stray_u, stray_v) < tolerance_;
  return (stray_u * std::abs(b.v - a.v) + stray_v * std::abs(b.u - a.u)) / length < tolerance_;
}

void ArcTracer::visit(const Sample& a, const Sample& b, int depth) {
  const Box box = enclose(a.t, b.t);
  if (box.u.is_empty() || box.v.is_empty()) {
    end_branch();
    return;
  }
  const bool bounded = box.u.is_bounded() && box.v.is_bounded();
  if (is_outside(box) && (box.is_continuous() || bounded)) {
    end_branch();
    return;
  }
  const double narrowest =
      std::max((arc_.to - arc_.from) * kBreakPart,
               4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a.t), std::abs(b.t)));
  if (box.is_continuous() && a.exists() && b.exists()) {
    if (is_straight(a, b, box)) {
      // A chord between samples that rounding moved is straight too: narrow pieces must prove theirs.
      const bool narrow = std::min(box.u.width(), box.v.width()) < cell_ / 32;
      const bool small = std::max(box.u.width(), box.v.width()) < tolerance_;
      if (narrow && !small && !(is_reliable(a) && is_reliable(b))) {
        undecided_area_ += std::min(1.0, box.u.width()) * std::min(1.0, box.v.width());
        return;
      }
      extend(a, b);
      after_dense_ = false;
      return;
    }
    if (draw_narrow(a, b, box)) return;
    if (b.t - a.t <= narrowest) {
      extend(a, b);
      return;
    }
    split(a, b, depth);
    return;
  }
  const double piece = std::min(box.u.width(), (b.t - a.t) / (arc_.to - arc_.from));
  if (piece < cell_ / 32 && ++narrow_breaks_ > kMostNarrowBreaks) {
    end_branch();
    const double shown = std::min(1.0, box.v.upper) - std::max(0.0, box.v.lower);
    undecided_area_ += std::min(1.0, box.u.width()) * std::max(0.0, shown);
    if (out_.undecided_places.size() < kMostPlaces)
      out_.undecided_places.push_back(
          {std::clamp(box.u.middle(), 0.0, 1.0), std::clamp(box.v.middle(), 0.0, 1.0)});
    return;
  }
  if (b.t - a.t > narrowest && depth < kMostDepth) {
    split(a, b, depth);
    return;
  }
  settle_break(a, b, box);
}

void ArcTracer::split(const Sample& a, const Sample& b, int depth) {
  const Sample middle = sample(a.t + (b.t - a.t) * kSplit);
  if (depth < 8 && !progress_.report(0)) return;
  visit(a, middle, depth + 1);
  visit(middle, b, depth + 1);
}

/// A continuous piece thinner than a cell's 32nd: what it covers is certain by the intermediate value
/// theorem.
bool ArcTracer::draw_narrow(const Sample& a, const Sample& b, const Box& box) {
  const bool upright = box.u.width() < cell_ / 32;
  const bool level = box.v.width() < cell_ / 32;
  if (!upright && !level) return false;
  const auto across = [&](const Sample& s) { return upright ? s.v : s.u; };
  double low = std::min(across(a), across(b));
  double high = std::max(across(a), across(b));
  const Interval& range = upright ? box.v : box.u;
  const double least = std::max(range.lower, -settings_.margin);
  const double most = std::min(range.upper, 1 + settings_.margin);
  // Skipped, extend() joins what lies on both sides where that is near enough.
  if (!is_reliable(a) || !is_reliable(b)) {
    undecided_area_ += (upright ? box.u.width() : box.v.width()) * std::max(0.0, most - least);
    return true;
  }
  for (const int count : {8, 64}) {
    if (low <= least + 2 * cell_ && high >= most - 2 * cell_) break;
    for (int i = 1; i < count; ++i) {
      const Sample s = sample(a.t + (b.t - a.t) * i / count);
      if (!s.exists() || !is_reliable(s)) continue;
      low = std::min(low, across(s));
      high = std::max(high, across(s));
    }
  }
  extend(a, b);
  const double covered = std::abs(across(b) - across(a));
  if (high - low > covered + tolerance_) {
    if (upright) {
      add_bar({(a.u + b.u) / 2, low}, {(a.u + b.u) / 2, high});
    } else {
      add_bar({low, (a.v + b.v) / 2}, {high, (a.v + b.v) / 2});
    }
    out_.dense = true;
    after_dense_ = true;
  }
  const double open = std::max(0.0, low - least) + std::max(0.0, most - high);
  if (open > 4 * cell_) {
    undecided_area_ += (upright ? box.u.width() : box.v.width()) * open;
    if (out_.undecided_places.size() < kMostPlaces) out_.undecided_places.push_back({a.u, a.v});
  }
  return true;
}

ArcTracer::Side ArcTracer::side(const Sample& near, double away) {
  if (!near.exists()) return Side::undefined;
  const Sample far = sample(near.t + 64 * away);
  if (!far.exists()) return Side::settled;
  if (is_near(near, far, 4 * tolerance_)) return Side::settled;
  const Sample farther = sample(near.t + 4096 * away);
  const double step = std::hypot(near.u - far.u, near.v - far.v);
  const bool outward = std::hypot(near.u - farther.u, near.v - farther.v) > step;
  return outward || !farther.exists() ? Side::growing : Side::wandering;
}

/// The piece is as narrow as numbers allow and still not proven continuous: says what happens there.
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
    if (is_inside(a) && (missing || has(box.cause(), Cause::pole))) {
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
    // The end itself where it belongs to the curve, else the last number before it.
    const bool attained = is_near(at, point, reach);
    add_event(EventKind::end, attained ? at : Sample{at.t, point.u, point.v});
  }
}

void ArcTracer::extend(const Sample& a, const Sample& b) {
  if (!branch_.points.empty() && branch_.points.back().parameter != a.t) {
    // Something unreliable was skipped; what was drawn beyond it already stays.
    const CurvePoint& last = branch_.points.back();
    if (last.parameter >= b.t) return;
    if (std::hypot(last.u - a.u, last.v - a.v) > cell_ / 8) end_branch();
  }
  if (branch_.points.empty()) branch_.points.push_back({a.u, a.v, a.t});
  branch_.points.push_back({b.u, b.v, b.t});
}

void ArcTracer::end_branch() {
  if (branch_.points.size() > 1) {
    const CurvePoint& first = branch_.points.front();
    const CurvePoint& last = branch_.points.back();
    const auto same = [&first](const CurvePoint& p) {
      return std::hypot(p.u - first.u, p.v - first.v) < 1e-12;
    };
    if (std::all_of(branch_.points.begin(), branch_.points.end(), same)) {
      out_.dots.push_back({statement_, {first.u, first.v}});
      add_event(EventKind::isolated, {first.parameter, first.u, first.v});
      branch_.points.clear();
      return;
    }
    branch_.closed = branch_.points.size() > 3 && std::hypot(first.u - last.u, first.v - last.v) < tolerance_;
    out_.branches.push_back(std::move(branch_));
  }
  branch_ = Branch{};
  branch_.statement = statement_;
  branch_.has_parameter = true;
}

void ArcTracer::add_bar(PlatePoint from, PlatePoint to) {
  // Bars of the same quarter of a cell that overlap become one: what they cover is covered.
  if (out_.bars.size() > first_bar_) {
    Bar& last = out_.bars.back();
    const double quarter = cell_ / 4;
    if (from.u == to.u && last.from.u == last.to.u &&
        std::floor(last.from.u / quarter) == std::floor(from.u / quarter) && from.v <= last.to.v &&
        last.from.v <= to.v) {
      last.from.v = std::min(last.from.v, from.v);
      last.to.v = std::max(last.to.v, to.v);
      return;
    }
    if (from.v == to.v && last.from.v == last.to.v &&
        std::floor(last.from.v / quarter) == std::floor(from.v / quarter) && from.u <= last.to.u &&
        last.from.u <= to.u) {
      last.from.u = std::min(last.from.u, from.u);
      last.to.u = std::max(last.to.u, to.u);
      return;
    }
  }
  out_.bars.push_back({statement_, from, to});
}

void ArcTracer::add_event(EventKind kind, const Sample& at, const Sample* after) {
  for (const Event& other : out_.events) {
    // One break can show in two neighbouring pieces.
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
