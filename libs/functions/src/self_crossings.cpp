// SPDX-License-Identifier: Apache-2.0
#include "self_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "polyline_crossings.h"

namespace nazori::functions {
namespace {

class SelfCrossings {
 public:
  SelfCrossings(const Arc& arc, const OneVariable& x, const OneVariable& y, const OneVariable& slope_x,
                const OneVariable& slope_y, const Window& window)
      : arc_(arc),
        x_(x),
        y_(y),
        slope_x_(slope_x),
        slope_y_(slope_y),
        width_(window.x1 - window.x0),
        height_(window.y1 - window.y0),
        span_(arc.to - arc.from) {}

  std::vector<SelfCrossing> run(const Tracing& tracing, int statement) {
    Tracing once = only(tracing, statement, first_pass());
    for (const Meeting& m : crossings_of(once, statement, statement)) judge(m.first, m.second);
    return std::move(found_);
  }

 private:
  [[nodiscard]] double u(double t) const { return x_.value(t) / width_; }
  [[nodiscard]] double v(double t) const { return y_.value(t) / height_; }

  /// Whether both parameters lead to one place, for many pairs.
  template <class Partner>
  [[nodiscard]] bool coincides(const Partner& partner) const {
    int compared = 0;
    for (int i = 0; i < 61; ++i) {
      const double t = arc_.from + span_ * std::fmod(0.0271 + i * 0.61803398875, 1.0);
      const auto s = partner(t);
      if (!s) continue;
      const double gap = std::hypot(u(t) - u(*s), v(t) - v(*s));
      if (std::isnan(gap)) continue;
      if (!(gap < 1e-9 * (1 + std::abs(u(t)) + std::abs(v(t))))) return false;
      ++compared;
    }
    return compared > 8;
  }

  /// The range of the parameter that draws every place once.
  [[nodiscard]] std::pair<double, double> first_pass() const {
    double from = arc_.from;
    double to = arc_.to;
    for (int parts = 64; parts >= 2; --parts) {
      for (const int count : {1, 2, 3}) {
        const double step = span_ * count / parts;
        if (step > span_ * 0.76) continue;
        const auto later = [&](double t) {
          return t + step <= arc_.to ? std::optional(t + step) : std::nullopt;
        };
        if (!coincides(later)) continue;
        to = from + step;
        parts = 0;
        break;
      }
    }
    // Forth and back: the same places in the reverse order.
    for (int k = 1; k < 48; ++k) {
      const double turn = from + (to - from) * k / 48;
      const auto mirrored = [&](double t) {
        const double s = 2 * turn - t;
        return t <= to && s >= arc_.from && s <= arc_.to ? std::optional(s) : std::nullopt;
      };
      if (!coincides(mirrored)) continue;
      if (turn - from >= to - turn) {
        to = turn;
      } else {
        from = turn;
      }
      break;
    }
    return {from, to};
  }

  static Tracing only(const Tracing& all, int statement, std::pair<double, double> range) {
    Tracing some;
    some.window = all.window;
    for (const Branch& b : all.branches) {
      if (b.statement != statement || !b.has_parameter) continue;
      Branch part = b;
      part.points.clear();
      const double hair = 1e-9 * (range.second - range.first);
      for (const CurvePoint& p : b.points) {
        if (p.parameter >= range.first - hair && p.parameter <= range.second + hair) part.points.push_back(p);
      }
      part.closed = b.closed && part.points.size() == b.points.size();
      if (part.points.size() > 1) some.branches.push_back(std::move(part));
    }
    return some;
  }

  void judge(double s, double t) {
    for (int k = 0; k < 40; ++k) {
      const double det = slope_x_.value(t) * slope_y_.value(s) - slope_x_.value(s) * slope_y_.value(t);
      const double dx = x_.value(t) - x_.value(s);
      const double dy = y_.value(t) - y_.value(s);
      const double ds = (slope_x_.value(t) * dy - slope_y_.value(t) * dx) / det;
      const double dt = (slope_x_.value(s) * dy - slope_y_.value(s) * dx) / det;
      if (!std::isfinite(ds + dt)) break;
      s += ds;
      t += dt;
      if (std::abs(ds) + std::abs(dt) < 1e-15 * (1 + std::abs(s) + std::abs(t))) break;
    }
    const double hair = 1e-9 * span_;
    if (s < arc_.from - hair || s > arc_.to + hair || t < arc_.from - hair || t > arc_.to + hair) return;
    if (std::abs(s - t) < 1e-5 * span_) return;
    if (!(std::hypot(u(s) - u(t), v(s) - v(t)) < 1e-9)) return;
    const double a = slope_x_.value(s) / width_;
    const double b = slope_y_.value(s) / height_;
    const double c = slope_x_.value(t) / width_;
    const double d = slope_y_.value(t) / height_;
    // In one direction, or in the opposite one, the curve passes itself without crossing.
    if (!(std::abs(a * d - b * c) > 1e-6 * std::hypot(a, b) * std::hypot(c, d))) return;
    found_.push_back({x_.value(s), y_.value(s), std::min(s, t)});
  }

  const Arc& arc_;
  const OneVariable& x_;
  const OneVariable& y_;
  const OneVariable& slope_x_;
  const OneVariable& slope_y_;
  double width_;
  double height_;
  double span_;
  std::vector<SelfCrossing> found_;
};

}  // namespace

std::vector<SelfCrossing> self_crossings(const Arc& arc, int statement, const OneVariable& x,
                                         const OneVariable& y, const OneVariable& slope_x,
                                         const OneVariable& slope_y, const Tracing& tracing) {
  return SelfCrossings(arc, x, y, slope_x, slope_y, tracing.window).run(tracing, statement);
}

}  // namespace nazori::functions
