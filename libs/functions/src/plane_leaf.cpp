// SPDX-License-Identifier: Apache-2.0
// The finest boxes of the quadtree: zeros on their borders, and those hidden inside.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "plane_tracer.h"
#include "simplest_between.h"

namespace nazori::functions {
namespace {

constexpr int kNewtonSteps = 60;
constexpr std::int64_t kMostCloserLooks = 1'500'000;

int sign_of(double v) { return std::isnan(v) ? 0 : v < 0 ? -1 : 1; }
double distance(PlatePoint a, PlatePoint b) { return std::hypot(a.u - b.u, a.v - b.v); }
PlatePoint between(PlatePoint p, PlatePoint q, double share) {
  return {p.u + (q.u - p.u) * share, p.v + (q.v - p.v) * share};
}

}  // namespace

/// One zero between two points where the signs differ. Where continuity is not proven, the half with the
/// change of sign is chosen until it is; at poles and jumps it never is.
void PlaneTracer::add_root(Point p, Point q, double fp, double fq, bool continuous,
                           std::vector<Point>& roots) {
  const double first = std::min(std::abs(fp), std::abs(fq));
  double low = 0;
  double high = 1;
  for (int i = 0; i < 60 && !continuous; ++i) {
    const Point a = between(p, q, low);
    const Point b = between(p, q, high);
    const Interval f = enclose(function_, Interval(std::min(a.u, b.u), std::max(a.u, b.u)),
                               Interval(std::min(a.v, b.v), std::max(a.v, b.v)));
    if (f.is_continuous()) {
      continuous = true;
      break;
    }
    const double middle = low + (high - low) * 0.4973;
    const double fm = value(between(p, q, middle));
    if (!std::isfinite(fm)) return;
    if (sign_of(fm) == sign_of(fp)) {
      low = middle;
      fp = fm;
    } else {
      high = middle;
      fq = fm;
    }
  }
  // Not proven: accepted only where the values shrink to zero, as at removable gaps.
  if (!continuous && std::max(std::abs(fp), std::abs(fq)) > 1e-6 * first) return;
  // Illinois: the false position, with an end that is kept twice halved.
  constexpr double kExact = 1e-13;  // of the side of a box
  double x = low;
  int kept = 0;
  for (int i = 0; i < 100 && high - low > kExact; ++i) {
    const double step = fq - fp;
    x = step != 0 && std::isfinite(step) ? low - fp * (high - low) / step : (low + high) / 2;
    if (!(x > low && x < high) || i > 40) x = (low + high) / 2;
    const double fx = value(between(p, q, x));
    if (fx == 0 || std::isnan(fx)) break;
    if (sign_of(fx) == sign_of(fp)) {
      const double moved = x - low;
      low = x;
      fp = fx;
      if (kept == 1) fq /= 2;
      kept = 1;
      if (moved < kExact) break;
    } else {
      const double moved = high - x;
      high = x;
      fq = fx;
      if (kept == -1) fp /= 2;
      kept = -1;
      if (moved < kExact) break;
    }
  }
  const Point root = between(p, q, x);
  if (counts_at(root)) roots.push_back(root);
}

/// The zeros on one side of a box: a change of sign, or two where the function turns round in between.
void PlaneTracer::add_edge_roots(Point p, Point q, bool continuous, std::vector<Point>& roots) {
  double fp = value(p);
  double fq = value(q);
  if (!std::isfinite(fp) || !std::isfinite(fq)) {
    // The border of the domain crosses this side: its defined part counts.
    if (!std::isfinite(fp) && !std::isfinite(fq)) return;
    const Point inside = std::isfinite(fp) ? p : q;
    Point& outside = std::isfinite(fp) ? q : p;
    double defined = 0;
    double undefined = 1;
    for (int i = 0; i < 50; ++i) {
      const double middle = (defined + undefined) / 2;
      (std::isfinite(value(between(inside, outside, middle))) ? defined : undefined) = middle;
    }
    outside = between(inside, outside, defined);
    fp = value(p);
    fq = value(q);
    continuous = false;
  }
  if (sign_of(fp) != sign_of(fq)) {
    add_root(p, q, fp, fq, continuous, roots);
    return;
  }
  if (!continuous) return;
  const auto along = [&](Point at) {
    const Gradient g = gradient(at);
    return g.slopes[0] * (q.u - p.u) + g.slopes[1] * (q.v - p.v);
  };
  const double dp = along(p);
  // Only a turn towards zero matters.
  if (!(dp * fp < 0) || !(along(q) * fq > 0)) return;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 48; ++i) {
    const double middle = (low + high) / 2;
    const Point at = between(p, q, middle);
    const double f = value(at);
    if (sign_of(f) != sign_of(fp)) {
      add_root(p, at, fp, f, continuous, roots);
      add_root(at, q, f, fq, continuous, roots);
      return;
    }
    (along(at) * fp < 0 ? low : high) = middle;
  }
}

void PlaneTracer::settle_leaf(const Square& s, bool continuous) {
  rejected_ = false;
  if (!continuous) {
    // Between jumps a function can be zero everywhere: the box counts like its middle.
    const Interval middle = enclose(function_, Interval(s.u + s.side / 2), Interval(s.v + s.side / 2));
    if (middle.is_point() && middle.lower == 0 && middle.decoration >= Decoration::defined &&
        counts_at({s.u + s.side / 2, s.v + s.side / 2})) {
      out_->fills.push_back({Point{s.u, s.v}, Point{s.u + s.side, s.v + s.side}});
      return;
    }
  }
  const std::array<Point, 4> corners{Point{s.u, s.v}, Point{s.u + s.side, s.v},
                                     Point{s.u + s.side, s.v + s.side}, Point{s.u, s.v + s.side}};
  std::vector<Point> roots;
  for (std::size_t i = 0; i < 4; ++i) {
    // Each side is searched in the same direction from both of its boxes, so that the ends meet exactly.
    const bool forward = i < 2;
    add_edge_roots(corners[forward ? i : (i + 1) % 4], corners[forward ? (i + 1) % 4 : i], continuous, roots);
  }
  if (!roots.empty()) {
    join(s, roots);
    return;
  }
  if (find_hidden(s, continuous) || rejected_) return;
  if (look_closer(s)) return;
  if (!rejected_) out_->undecided.push_back({s.u + s.side / 2, s.v + s.side / 2});
}

/// Connects the zeros on the border of a box.
void PlaneTracer::join(const Square& s, std::vector<Point>& roots) {
  if (roots.size() == 2) {
    out_->segments.push_back({roots[0], roots[1]});
    return;
  }
  Point middle{s.u + s.side / 2, s.v + s.side / 2};
  const bool critical = find_critical(s, middle) && is_zero_at(middle);
  if (critical) {
    out_->singular.push_back(middle);
    for (const Point& r : roots) out_->segments.push_back({r, middle});
    return;
  }
  if (roots.size() == 1) {
    // The curve ends inside: its end is nearer than the side of a box.
    out_->segments.push_back({roots[0], roots[0]});
    return;
  }
  if (roots.size() == 4) {
    // Choosing the pairing with the shorter pieces keeps nearby branches separate.
    double best = std::numeric_limits<double>::infinity();
    std::size_t partner = 1;
    for (std::size_t i = 1; i < 4; ++i) {
      const std::size_t a = i == 1 ? 2 : 1;
      const std::size_t b = 6 - i - a;
      const double length = distance(roots[0], roots[i]) + distance(roots[a], roots[b]);
      if (length < best) {
        best = length;
        partner = i;
      }
    }
    const std::size_t a = partner == 1 ? 2 : 1;
    out_->segments.push_back({roots[0], roots[partner]});
    out_->segments.push_back({roots[a], roots[6 - partner - a]});
    return;
  }
  middle = {0, 0};
  for (const Point& r : roots) {
    middle.u += r.u / static_cast<double>(roots.size());
    middle.v += r.v / static_cast<double>(roots.size());
  }
  for (const Point& r : roots) out_->segments.push_back({r, middle});
}

/// A point where the gradient vanishes, by Newton's method with the least step where it vanishes on a curve.
bool PlaneTracer::find_critical(const Square& s, Point& at) {
  const Point centre{s.u + s.side / 2, s.v + s.side / 2};
  Point p = centre;
  const double h = s.side * 1e-4;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Gradient g = gradient(p);
    const Gradient gu = gradient({p.u + h, p.v});
    const Gradient lu = gradient({p.u - h, p.v});
    const Gradient gv = gradient({p.u, p.v + h});
    const Gradient lv = gradient({p.u, p.v - h});
    const double a = (gu.slopes[0] - lu.slopes[0]) / (2 * h);
    const double b = (gu.slopes[1] - lu.slopes[1] + gv.slopes[0] - lv.slopes[0]) / (4 * h);
    const double d = (gv.slopes[1] - lv.slopes[1]) / (2 * h);
    if (!std::isfinite(a + b + d + g.slopes[0] + g.slopes[1])) return false;
    // Eigenvalues of the symmetric second derivative; the small one is ignored where it is insignificant.
    const double half = (a + d) / 2;
    const double root = std::hypot((a - d) / 2, b);
    const double angle = std::atan2(b, (a - d) / 2) / 2;
    const double most = std::abs(half) + root;
    if (most == 0) {
      at = p;
      return g.slopes[0] == 0 && g.slopes[1] == 0;
    }
    Point step;
    for (const auto& [eigenvalue, turn] :
         {std::pair{half + root, angle}, std::pair{half - root, angle + std::numbers::pi / 2}}) {
      if (std::abs(eigenvalue) < 1e-5 * most) continue;
      const double c = std::cos(turn);
      const double n = std::sin(turn);
      const double amount = -(g.slopes[0] * c + g.slopes[1] * n) / eigenvalue;
      step.u += amount * c;
      step.v += amount * n;
    }
    p.u += step.u;
    p.v += step.v;
    if (std::max(std::abs(p.u - centre.u), std::abs(p.v - centre.v)) > 0.75 * s.side) return false;
    if (std::hypot(step.u, step.v) < 1e-16 * (1 + std::hypot(p.u, p.v)) || i + 1 == kNewtonSteps ||
        std::hypot(step.u, step.v) < 1e-13 * s.side) {
      at = p;
      return true;
    }
  }
  return false;
}

/// Zeros that do not show on the border: ovals inside the box, double zeros.
bool PlaneTracer::find_hidden(const Square& s, bool continuous) {
  const std::array<Point, 4> corners{Point{s.u, s.v}, Point{s.u + s.side, s.v},
                                     Point{s.u + s.side, s.v + s.side}, Point{s.u, s.v + s.side}};
  Point p{s.u + s.side / 2, s.v + s.side / 2};
  const bool critical = find_critical(s, p);
  const bool inside = p.u >= s.u && p.u <= s.u + s.side && p.v >= s.v && p.v <= s.v + s.side;
  const double f = value(p);
  const double corner = value(corners[0]);
  if (continuous && inside && std::isfinite(f) && std::isfinite(corner) && f != 0 &&
      sign_of(f) != sign_of(corner)) {
    std::vector<Point> around;
    for (const Point& c : corners) {
      const double fc = value(c);
      if (sign_of(fc) != 0 && sign_of(fc) != sign_of(f)) add_root(p, c, f, fc, true, around);
    }
    for (std::size_t i = 0; i < around.size(); ++i)
      out_->segments.push_back({around[i], around[(i + 1) % around.size()]});
    if (!around.empty()) return true;
  }
  if (!critical || !is_zero_at(p)) return false;
  out_->dots.push_back(p);
  return true;
}

/// Among the points of the box, or just beside it, the x and y with the fewest decimals.
std::array<double, 2> PlaneTracer::roundest_in(const Square& s) const {
  const auto round = [&](double c, std::size_t axis) {
    const double hair = 8 * std::numeric_limits<double>::epsilon();
    const double a = equation_.low[axis] + (c - hair) * range_[axis];
    const double b = equation_.low[axis] + (c + s.side + hair) * range_[axis];
    return simplest_between(a, b);
  };
  return {round(s.u, 0), round(s.v, 1)};
}

/// Zero exactly at these numbers, also in a corner of the domain, where the function is not continuous on all
/// sides: sqrt(x) + sqrt(y) = 0.
bool PlaneTracer::is_exactly_zero(const std::array<double, 2>& at) {
  const std::array point{Interval(at[0]), Interval(at[1])};
  function_.evaluate<Interval>(point, intervals_);
  const Interval f = intervals_[function_.output(0)];
  if (f.is_empty() || f.lower != 0 || f.upper != 0 || f.decoration < Decoration::defined) return false;
  if (!has_whole_) return true;
  whole_.evaluate<Interval>(point, intervals_);
  const Interval w = intervals_[whole_.output(0)];
  return !w.is_empty() && w.decoration >= Decoration::defined;
}

/// Halves the box while zero cannot be excluded. @return true where the box is decided: nothing is left, or
/// only single points that are zero as far as can be computed.
bool PlaneTracer::look_closer(const Square& s) {
  constexpr std::size_t kMostBoxes = 40;
  constexpr std::size_t kMostBoxesAtJumps = 300;
  std::vector<Square> boxes{s};
  for (int level = 0; level < 44; ++level) {
    std::vector<Square> left;
    bool only_jumps = true;
    for (const Square& b : boxes) {
      const double h = b.side / 2;
      for (const Square& q : {Square{b.u, b.v, h}, Square{b.u + h, b.v, h}, Square{b.u, b.v + h, h},
                              Square{b.u + h, b.v + h, h}}) {
        if (++closer_looks_ > kMostCloserLooks) return false;
        const Interval f = enclose(function_, q);
        if (f.is_empty() || !f.contains(0)) continue;
        // Zero everywhere: part of an area, whose boxes count by their middles.
        if (f.is_point()) continue;
        if (has_whole_) {
          const Interval w = enclose(whole_, q);
          if (w.is_empty() || !w.contains(0)) continue;
        }
        only_jumps = only_jumps && f.decoration == Decoration::defined && has(f.cause, Cause::jump);
        left.push_back(q);
      }
    }
    if (left.empty()) return true;
    // Along a jump some boxes remain at every level: a strip without width.
    if (only_jumps && level == 5) return true;
    if (left.size() > (only_jumps ? kMostBoxesAtJumps : kMostBoxes)) return false;
    boxes = std::move(left);
    if (boxes[0].side < 1e-15) break;
  }
  bool found = false;
  for (const Square& b : boxes) {
    const Point p{b.u + b.side / 2, b.v + b.side / 2};
    const auto near = [&](const Point& d) { return distance(d, p) < 1e-9; };
    if (std::any_of(out_->dots.begin(), out_->dots.end(), near)) {
      found = true;
    } else if (is_zero_at(p)) {
      out_->dots.push_back(p);
      found = true;
    } else {
      const auto xy = roundest_in(b);
      const Point round{(xy[0] - equation_.low[0]) / range_[0], (xy[1] - equation_.low[1]) / range_[1]};
      if (!is_zero_at(round) && !is_exactly_zero(xy)) continue;
      out_->dots.push_back(round);
      found = true;
    }
  }
  return found;
}

}  // namespace nazori::functions
