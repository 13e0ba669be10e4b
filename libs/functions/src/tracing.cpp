// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/tracing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "algebra.h"
#include "arc_tracer.h"
#include "arcs.h"
#include "equation.h"
#include "nazori/functions/curve_kinds.h"
#include "place_grid.h"
#include "plane_tracer.h"
#include "polar_region.h"
#include "region_tracer.h"

namespace nazori::functions {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostPlaces = 1000;

class PlotTracer {
 public:
  PlotTracer(const Plot& plot, const TraceSettings& settings, Tracing& out, WorkProgress& progress)
      : plot_(plot), settings_(settings), out_(out), progress_(progress) {
    const Window& w = out.window;
    const double m = settings.margin;
    low_ = {w.x(-m), w.y(-m)};
    high_ = {w.x(1 + m), w.y(1 + m)};
  }

  bool run() {
    const auto count = static_cast<double>(plot_.statements.size());
    for (std::size_t i = 0; i < plot_.statements.size(); ++i) {
      statement_ = static_cast<int>(i);
      low_part_ = static_cast<double>(i) / count;
      high_part_ = static_cast<double>(i + 1) / count;
      progress_.begin_part(low_part_, high_part_, "tracing");
      if (!draw(plot_.statements[i])) return false;
    }
    return true;
  }

 private:
  bool draw(const Statement& s) {
    switch (curve_kind(s.kind).drawn_by) {
      case DrawnBy::course:
        return draw_arcs(s);
      case DrawnBy::polar_equation:
        return draw_polar(s);
      case DrawnBy::equation:
        return draw_equation(s.terms[0], s.terms[1]);
      case DrawnBy::region:
        return draw_region(s);
      case DrawnBy::heights:
        return true;
    }
    return true;
  }

  bool draw_arcs(const Statement& s) {
    const std::vector<Arc> arcs = arcs_of(s, out_.window, settings_.margin);
    return std::all_of(arcs.begin(), arcs.end(), [this](const Arc& arc) { return draw(arc); });
  }

  bool draw(const Arc& arc) { return ArcTracer(arc, statement_, settings_, out_, progress_).run(); }

  bool draw_polar(const Statement& s) {
    const Expression whole = reduced(binary(NodeKind::subtract, s.terms[0], s.terms[1]));
    if (const std::vector<Arc> arcs = arcs_of(s, out_.window, settings_.margin); !arcs.empty())
      return std::all_of(arcs.begin(), arcs.end(), [this](const Arc& arc) { return draw(arc); });
    PlaneEquation e;
    e.variables = {Variable::theta, Variable::r};
    const double reach = 1.1 * std::hypot(std::max(std::abs(low_[0]), std::abs(high_[0])),
                                          std::max(std::abs(low_[1]), std::abs(high_[1])));
    e.low = {constant_value(s.from), -reach};
    e.high = {constant_value(s.to), reach};
    if (!(e.high[0] > e.low[0])) return true;
    e.whole = whole;
    e.function = over_common_denominator(whole).numerator;
    const double turns = (e.high[0] - e.low[0]) / (2 * 3.14159);
    const int cells = static_cast<int>(std::clamp(settings_.resolution * turns, 512.0, 4096.0));
    return draw(e, cells, 0.0, [&e, this](PlatePoint p) {
      const double angle = e.low[0] + p.u * (e.high[0] - e.low[0]);
      const double radius = e.low[1] + p.v * (e.high[1] - e.low[1]);
      return PlatePoint{out_.window.u(radius * std::cos(angle)), out_.window.v(radius * std::sin(angle))};
    });
  }

  bool draw_equation(const Expression& left, const Expression& right) {
    EquationParts parts = split_equation(left, right, low_, high_);
    out_.undecided_cells += parts.undecided;
    for (const auto& conditions : parts.areas) {
      std::vector<Condition> tests;
      tests.reserve(conditions.size());
      for (const Expression& c : conditions) tests.push_back({c, false});
      const Expression guard = is_total(parts.whole) ? nullptr : parts.whole;
      if (!RegionTracer(tests, guard, statement_, settings_, out_, progress_).run()) return false;
    }
    for (const Arc& arc : parts.arcs) {
      if (!draw(arc)) return false;
    }
    const Window& w = out_.window;
    for (PlaneEquation& e : parts.equations) {
      e.low = {w.x0, w.y0};
      e.high = {w.x1, w.y1};
      const int cells = std::clamp(settings_.resolution, 64, 2048);
      if (!draw(e, cells, settings_.margin, [](PlatePoint p) { return p; })) return false;
    }
    return true;
  }

  template <class Map>
  bool draw(const PlaneEquation& e, int cells, double margin, const Map& to_plate) {
    PlaneSolution found;
    const bool done = PlaneTracer(e, cells, margin, progress_).run(found);
    add(found, to_plate);
    return done;
  }

  /// Adds a solution to the tracing: segments become branches, neighbouring zeros without change of sign a
  /// line.
  template <class Map>
  void add(PlaneSolution& found, const Map& to_plate) {
    std::vector<PlatePoint> lonely = link_dots(found);
    const auto lines = stitched(found.segments, found.leaf * 1e-5);
    for (const auto& line : lines) {
      Branch b;
      b.statement = statement_;
      b.points.reserve(line.size());
      for (const PlatePoint& p : line) {
        const PlatePoint q = to_plate(p);
        b.points.push_back({q.u, q.v, 0});
      }
      const auto& first = b.points.front();
      const auto& last = b.points.back();
      b.closed = b.points.size() > 3 && std::hypot(first.u - last.u, first.v - last.v) < 1e-9;
      out_.branches.push_back(std::move(b));
    }
    PlaceGrid ends(3 * found.leaf);
    for (const PlaneSolution::Segment& segment : found.segments) {
      ends.add(segment.from);
      ends.add(segment.to);
    }
    for (const PlatePoint& p : lonely) {
      const PlatePoint q = to_plate(p);
      out_.dots.push_back({statement_, q});
      if (!ends.is_any_near(p)) add_event(EventKind::isolated, q);
    }
    // Along a double curve every box looks singular: only isolated ones are points of interest.
    PlaceGrid places(8 * found.leaf);
    for (const PlatePoint& p : found.singular) places.add(p);
    for (const PlatePoint& p : found.singular) {
      if (!places.is_any_near(p, 1e-7)) add_event(EventKind::singular, to_plate(p));
    }
    for (const auto& f : found.fills) out_.fills.push_back({statement_, f[0], f[1]});
    out_.undecided_cells += static_cast<std::int64_t>(found.undecided.size());
    out_.cells = std::max(out_.cells, static_cast<std::int64_t>(1.0 / (found.leaf * found.leaf)));
    for (const PlatePoint& p : found.undecided) {
      if (out_.undecided_places.size() < kMostPlaces) out_.undecided_places.push_back(to_plate(p));
    }
  }

  /// Adds segments between dots of neighbouring boxes. @return the dots that have no neighbour.
  static std::vector<PlatePoint> link_dots(PlaneSolution& found) {
    const double pitch = 2 * found.leaf;
    // Boxes that share a corner find the same point.
    std::sort(found.dots.begin(), found.dots.end(), [](const PlatePoint& a, const PlatePoint& b) {
      return std::pair(a.u, a.v) < std::pair(b.u, b.v);
    });
    std::vector<PlatePoint> distinct;
    for (const PlatePoint& p : found.dots) {
      bool known = false;
      for (std::size_t i = distinct.size(); i-- > 0 && p.u - distinct[i].u < 1e-9 && !known;)
        known = std::abs(p.v - distinct[i].v) < 1e-9;
      if (!known) distinct.push_back(p);
    }
    found.dots = std::move(distinct);
    std::unordered_map<std::int64_t, std::vector<std::size_t>> grid;
    const auto key = [](std::int64_t i, std::int64_t j) { return i * 1'000'003 + j; };
    const auto cell = [pitch](double c) { return static_cast<std::int64_t>(std::floor(c / pitch)); };
    for (std::size_t i = 0; i < found.dots.size(); ++i)
      grid[key(cell(found.dots[i].u), cell(found.dots[i].v))].push_back(i);
    // Two dots are linked where no third is nearer to both: along a curve that gives a chain.
    std::vector<bool> linked(found.dots.size(), false);
    const auto gap = [&found](std::size_t i, std::size_t j) {
      return std::hypot(found.dots[i].u - found.dots[j].u, found.dots[i].v - found.dots[j].v);
    };
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < found.dots.size(); ++i) {
      near.clear();
      for (std::int64_t du = -1; du <= 1; ++du) {
        for (std::int64_t dv = -1; dv <= 1; ++dv) {
          const auto bucket = grid.find(key(cell(found.dots[i].u) + du, cell(found.dots[i].v) + dv));
          if (bucket == grid.end()) continue;
          for (const std::size_t j : bucket->second) {
            if (j != i && gap(i, j) <= 1.9 * found.leaf) near.push_back(j);
          }
        }
      }
      for (const std::size_t j : near) {
        const double d = gap(i, j);
        const auto blocks = [&](std::size_t k) { return k != j && gap(i, k) < d && gap(k, j) < d; };
        if (j < i || std::any_of(near.begin(), near.end(), blocks)) continue;
        linked[i] = linked[j] = true;
        found.segments.push_back({found.dots[i], found.dots[j]});
      }
    }
    std::vector<PlatePoint> lonely;
    for (std::size_t i = 0; i < found.dots.size(); ++i) {
      if (!linked[i]) lonely.push_back(found.dots[i]);
    }
    return lonely;
  }

  void add_event(EventKind kind, PlatePoint p) {
    PlaceGrid& known = kind == EventKind::isolated ? isolated_ : singular_;
    if (known.is_any_near(p)) return;
    known.add(p);
    out_.events.push_back({kind, statement_, 0, out_.window.x(p.u), out_.window.y(p.v), kNaN, kNaN});
  }

  bool draw_region(const Statement& typed) {
    const Statement s = in_the_plane(typed);
    std::vector<Condition> conditions;
    std::vector<std::size_t> owners;  // the comparison that each condition comes from
    for (std::size_t i = 0; i < s.comparisons.size(); ++i) {
      const Comparison c = s.comparisons[i];
      if (c == Comparison::both) continue;
      const bool falls = c == Comparison::greater || c == Comparison::greater_equal;
      const Expression difference = reduced(falls ? binary(NodeKind::subtract, s.terms[i], s.terms[i + 1])
                                                  : binary(NodeKind::subtract, s.terms[i + 1], s.terms[i]));
      conditions.push_back({difference, is_strict(c)});
      owners.push_back(i);
      // An equality inside a chain: both ways.
      if (c == Comparison::equal) {
        conditions.push_back({negate(difference), false});
        owners.push_back(i);
      }
    }
    for (Condition& bound : angle_bounds(typed)) conditions.push_back(std::move(bound));
    if (!RegionTracer(conditions, nullptr, statement_, settings_, out_, progress_).run()) return false;
    const std::size_t first_event = out_.events.size();
    for (std::size_t i = 0; i < s.comparisons.size(); ++i) {
      if (s.comparisons[i] == Comparison::both) continue;
      const std::size_t begin = out_.branches.size();
      const std::size_t first_dot = out_.dots.size();
      const std::size_t first_bar = out_.bars.size();
      const std::size_t first_fill = out_.fills.size();
      const bool drawn = draw_equation(s.terms[i], s.terms[i + 1]);
      if (!drawn) {
        out_.branches.resize(begin);
        out_.dots.resize(first_dot);
      }
      // A border with an area was handled with the region.
      out_.fills.resize(first_fill);
      if (!drawn) return false;
      std::vector<Condition> others;
      for (std::size_t j = 0; j < conditions.size(); ++j) {
        if (j >= owners.size() || owners[j] != i) others.push_back({conditions[j].expression, false});
      }
      const bool strict = is_strict(s.comparisons[i]);
      keep_where(others, begin, strict);
      keep_dots_where(others, first_dot, strict);
      if (strict) out_.bars.resize(first_bar);
    }
    // Events on a border are not events of a curve.
    out_.events.resize(first_event);
    return true;
  }

  /// Single points of a border that belongs to the region, x^2 + y^2 <= 0, where the other conditions hold.
  void keep_dots_where(const std::vector<Condition>& conditions, std::size_t begin, bool strict) {
    RegionTracer region(conditions, nullptr, statement_, settings_, out_, progress_);
    const auto first = out_.dots.begin() + static_cast<std::ptrdiff_t>(begin);
    out_.dots.erase(
        std::remove_if(first, out_.dots.end(), [&](const Dot& d) { return strict || !region.holds(d.at); }),
        out_.dots.end());
  }

  /// Keeps the parts of the branches from `begin` on where the conditions hold, and marks them as a border.
  void keep_where(const std::vector<Condition>& conditions, std::size_t begin, bool strict) {
    RegionTracer region(conditions, nullptr, statement_, settings_, out_, progress_);
    std::vector<Branch> kept;
    for (std::size_t b = begin; b < out_.branches.size(); ++b) {
      const Branch& whole = out_.branches[b];
      Branch piece;
      const auto finish = [&] {
        piece.statement = statement_;
        piece.boundary = true;
        piece.strict = strict;
        if (piece.points.size() > 1) kept.push_back(std::move(piece));
        piece = Branch{};
      };
      for (std::size_t i = 0; i + 1 < whole.points.size(); ++i) {
        const CurvePoint& p = whole.points[i];
        const CurvePoint& q = whole.points[i + 1];
        const int steps =
            conditions.empty() ? 1 : static_cast<int>(std::hypot(p.u - q.u, p.v - q.v) * 512) + 1;
        for (int k = 0; k < steps; ++k) {
          const double from = static_cast<double>(k) / steps;
          const double to = static_cast<double>(k + 1) / steps;
          const auto at = [&](double share) {
            return CurvePoint{p.u + (q.u - p.u) * share, p.v + (q.v - p.v) * share, 0};
          };
          const CurvePoint middle = at((from + to) / 2);
          if (!conditions.empty() && !region.holds({middle.u, middle.v})) {
            finish();
            continue;
          }
          if (piece.points.empty()) piece.points.push_back(at(from));
          piece.points.push_back(at(to));
        }
      }
      finish();
    }
    out_.branches.resize(begin);
    std::move(kept.begin(), kept.end(), std::back_inserter(out_.branches));
  }

  const Plot& plot_;
  TraceSettings settings_;
  Tracing& out_;
  WorkProgress& progress_;
  PlaceGrid isolated_{1e-6};
  PlaceGrid singular_{1e-6};
  int statement_ = 0;
  double low_part_ = 0;
  double high_part_ = 1;
  std::array<double, 2> low_{};
  std::array<double, 2> high_{};
};

}  // namespace

base::Result<Tracing> trace(const Plot& plot, const Window& window, const TraceSettings& settings,
                            const base::Progress& progress) {
  if (auto good = window.check(); !good) return tl::unexpected(std::move(good.error()));
  if (settings.resolution < TraceSettings::kFewestCells || settings.resolution > TraceSettings::kMostCells ||
      !(settings.margin >= 0 && settings.margin <= 1)) {
    return base::fail(base::Errc::bad_argument, "the resolution or the margin of the tracing is out of range",
                      "settings",
                      fmt::format("give {} to {} cells and a margin of 0 to 1", TraceSettings::kFewestCells,
                                  TraceSettings::kMostCells));
  }
  Tracing out;
  out.window = window;
  out.cells = static_cast<std::int64_t>(settings.resolution) * settings.resolution;
  WorkProgress work(progress, settings.most_milliseconds);
  if (!PlotTracer(plot, settings, out, work).run()) {
    if (!work.is_late()) return base::fail(base::Errc::cancelled, "the tracing was stopped");
    out.complete = false;
  }
  return out;
}

}  // namespace nazori::functions
