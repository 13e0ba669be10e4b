// SPDX-License-Identifier: Apache-2.0
#include "arc_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra.h"
#include "simplest_between.h"

namespace nazori::functions {
namespace {

constexpr int kFirstPieces = 64;
constexpr int kMostDepth = 90;
// Breaks are enclosed down to this share of the range.
constexpr double kBreakPart = 0x1p-44;
// For infinitely many poles, as of tan(1/x): after this many narrow pieces with a break the rest stays
// undecided.
constexpr std::int64_t kMostNarrowBreaks = 40'000;
// Maximum number of narrow pieces that are halved because their enclosure is too wide.
constexpr std::int64_t kMostBluntPieces = 30'000;
constexpr std::size_t kMostPlaces = 1000;
// Not exactly the middle, so that a break at a round number does not fall on a border.
constexpr double kSplit = 0.49731;

}  // namespace

double Arc::hair() const {
  // Twice as far away as breaks are enclosed, so that one at the end itself is not found.
  return std::max(2 * (to - from) * kBreakPart,
                  16 * std::numeric_limits<double>::epsilon() * std::max(std::abs(from), std::abs(to)));
}

bool Arc::is_open_end(double t) const {
  return (from_is_open && t <= from + 2 * hair()) || (to_is_open && t >= to - 2 * hair());
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
      intervals_(tape_.size()),
      long_values_(tape_.can_overflow() ? tape_.size() : 0),
      duals_(tape_.size()),
      long_duals_(tape_.can_overflow() ? tape_.size() : 0),
      first_bar_(out.bars.size()) {}

bool ArcTracer::run() {
  branch_.statement = statement_;
  branch_.has_parameter = true;
  if (arc_.from == arc_.to) {
    const Sample only = sample(arc_.from);
    if (only.exists() && is_inside(only)) out_.dots.push_back({statement_, {only.u, only.v}});
    return true;
  }
  const double from = arc_.from + (arc_.from_is_open ? arc_.hair() : 0);
  const double to = arc_.to - (arc_.to_is_open ? arc_.hair() : 0);
  Sample a = sample(from);
  const Sample first = a;
  for (int i = 0; i < kFirstPieces; ++i) {
    const double share = static_cast<double>(i + 1) / kFirstPieces;
    // Borders moved slightly off round numbers; the ends are kept.
    const double bent = share + 0.0137 * share * (1 - share);
    const Sample b = sample(i + 1 == kFirstPieces ? to : from + (to - from) * bent);
    if (progress_.report(share - 1.0 / kFirstPieces)) visit(a, b, 0);
    if (progress_.is_stopped()) {
      end_branch();
      return false;
    }
    a = b;
  }
  const bool last_is_drawn = !branch_.points.empty() && branch_.points.back().parameter == a.t;
  end_branch();
  undecided_area_ = std::min(1.0, undecided_area_);
  out_.undecided_cells += static_cast<std::int64_t>(std::ceil(undecided_area_ / (cell_ * cell_) - 1e-3));
  // The end of the range belongs to the curve even if it lies after a jump.
  if (arc_.ends_are_real && !last_is_drawn && a.exists() && is_inside(a))
    out_.dots.push_back({statement_, {a.u, a.v}});
  if (arc_.ends_are_real) {
    const bool closed = is_near(first, a, 4 * tolerance_);
    // Where the curve continues to an excluded end, the end itself is reported, not the last point before it.
    const auto reported_end = [this](double t, const Sample& last) {
      const Sample at = sample(t);
      return is_near(at, last, tolerance_) ? at : Sample{t, last.u, last.v};
    };
    for (const Sample& end : {reported_end(arc_.from, first), reported_end(arc_.to, a)}) {
      if (!closed && end.exists() && is_inside(end)) add_event(EventKind::end, end);
    }
  }
  return true;
}

bool ArcTracer::is_inside(const Sample& s) const {
  const double m = settings_.margin;
  return s.u >= -m && s.u <= 1 + m && s.v >= -m && s.v <= 1 + m;
}

bool ArcTracer::is_outside(const Interval& u, const Interval& v) const {
  const double m = settings_.margin;
  return u.lower > 1 + m || u.upper < -m || v.lower > 1 + m || v.upper < -m;
}

bool ArcTracer::is_near(const Sample& a, const Sample& b, double distance) const {
  return a.exists() && b.exists() && std::hypot(a.u - b.u, a.v - b.v) <= distance;
}

bool ArcTracer::is_straight(const Sample& a, const Sample& b, const Box& box) const {
  if (!a.exists() || !b.exists()) return false;
  if (std::max(box.u.width(), box.v.width()) < tolerance_) return true;
  if (!box.slope_u.is_bounded() || !box.slope_v.is_bounded()) return false;
  // A function with slopes in [s, S] deviates from its chord by at most (b - a)(S - s)/4.
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
  // Poles are only searched for y = f(x) and x = g(y); for other kinds a piece outside is finished.
  if (is_outside(box.u, box.v) && (box.is_continuous() || bounded || arc_.ends_are_real)) {
    end_branch();
    return;
  }
  const double narrowest =
      std::max((arc_.to - arc_.from) * kBreakPart,
               4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a.t), std::abs(b.t)));
  if (box.is_continuous() && a.exists() && b.exists()) {
    if (is_straight(a, b, box)) {
      // A chord between samples that rounding has moved is also straight, so narrow pieces must prove theirs.
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
    if (draw_narrow(a, b, box, b.t - a.t > 64 * narrowest)) return;
    if (b.t - a.t <= narrowest) {
      extend(a, b);
      return;
    }
    split(a, b, depth);
    return;
  }
  if (settle_invisible(a, b, box)) return;
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

/// A piece too small to be visible and without a pole need not be examined further.
bool ArcTracer::settle_invisible(const Sample& a, const Sample& b, const Box& box) {
  if (!(std::max(box.u.width(), box.v.width()) < tolerance_ / 4) || has(box.cause(), Cause::pole))
    return false;
  const double part = (b.t - a.t) / (arc_.to - arc_.from);
  if (a.exists() && b.exists() && part < 1e-6) {
    extend(a, b);
    return true;
  }
  if (a.exists() || b.exists() || part >= 1e-9) return false;
  // Undefined as far as examined: a single point can only be found at a round number.
  end_branch();
  const Sample at = sample(simplest_between(a.t, b.t));
  if (at.exists() && is_inside(at) && is_reliable(at)) {
    out_.dots.push_back({statement_, {at.u, at.v}});
    add_event(EventKind::isolated, at);
  } else {
    undecided_area_ += box.u.width() * box.v.width();
  }
  return true;
}

void ArcTracer::split(const Sample& a, const Sample& b, int depth) {
  const Sample middle = sample(a.t + (b.t - a.t) * kSplit);
  if (depth < 8 ? !progress_.report(0) : (progress_.is_stopped() || !progress_.is_in_time())) return;
  visit(a, middle, depth + 1);
  visit(middle, b, depth + 1);
}

/// A continuous piece thinner than a cell's 32nd: what it covers is certain by the intermediate value
/// theorem.
bool ArcTracer::draw_narrow(const Sample& a, const Sample& b, const Box& box, bool may_split) {
  const bool upright = box.u.width() < cell_ / 32;
  const bool level = box.v.width() < cell_ / 32;
  if (!upright && !level) return false;
  const auto across = [&](const Sample& s) { return upright ? s.v : s.u; };
  double low = std::min(across(a), across(b));
  double high = std::max(across(a), across(b));
  const Interval& whole = upright ? box.v : box.u;
  double least = std::max(whole.lower, -settings_.margin);
  double most = std::min(whole.upper, 1 + settings_.margin);
  // If it is skipped, extend() joins both sides if they are near enough.
  if (!is_reliable(a) || !is_reliable(b)) {
    undecided_area_ += (upright ? box.u.width() : box.v.width()) * std::max(0.0, most - least);
    return true;
  }
  for (const int count : {8, 64}) {
    if (low <= least + 2 * cell_ && high >= most - 2 * cell_) break;
    if (count == 64) {
      const Interval sharper = by_mean_value(a, b, box, upright);
      least = std::max(sharper.lower, -settings_.margin);
      most = std::min(sharper.upper, 1 + settings_.margin);
      if (low <= least + 2 * cell_ && high >= most - 2 * cell_) break;
      // The enclosure is wide, the curve is not dense: halves have narrower enclosures, as long as there are
      // not too many.
      const bool turns = high - low > std::abs(across(b) - across(a)) + tolerance_;
      if (!turns && may_split && ++blunt_pieces_ <= kMostBluntPieces) return false;
    }
    for (int i = 1; i < count; ++i) {
      const Sample s = sample(a.t + (b.t - a.t) * i / count);
      if (!s.exists() || !is_reliable(s)) continue;
      low = std::min(low, across(s));
      high = std::max(high, across(s));
    }
  }
  const double open = std::max(0.0, low - least) + std::max(0.0, most - high);
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
  if (open > 4 * cell_) {
    undecided_area_ += (upright ? box.u.width() : box.v.width()) * open;
    if (out_.undecided_places.size() < kMostPlaces) out_.undecided_places.push_back({a.u, a.v});
  }
  return true;
}

void ArcTracer::extend(const Sample& a, const Sample& b) {
  if (!branch_.points.empty() && branch_.points.back().parameter != a.t) {
    // An unreliable part was skipped; the part drawn after it stays.
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
  // Bars of the same quarter of a cell that overlap become one: the result covers the same.
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

}  // namespace nazori::functions
