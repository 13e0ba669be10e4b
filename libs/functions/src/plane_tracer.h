// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "nazori/functions/tape.h"
#include "nazori/functions/tracing.h"
#include "work_progress.h"

namespace nazori::functions {

/// An equation F(a, b) = 0 over a rectangle of two variables, and where it counts.
struct PlaneEquation {
  Expression function;  ///< F, mostly a factor of a numerator: without poles where that is possible
  Expression whole;     ///< the equation as typed; zeros of F where this is undefined do not count
  std::array<Variable, 2> variables{Variable::x, Variable::y};
  std::array<double, 2> low{};
  std::array<double, 2> high{};
  /// Where all of these are certainly not negative, F is zero everywhere.
  std::vector<std::vector<Expression>> areas;
};

/// The result, in unit coordinates: the rectangle is 0 to 1 in both directions.
struct PlaneSolution {
  struct Segment {
    PlatePoint from;
    PlatePoint to;
  };
  std::vector<Segment> segments;
  std::vector<PlatePoint> dots;      ///< zeros without a change of sign: double curves, single points
  std::vector<PlatePoint> singular;  ///< zeros where the gradient vanishes and branches meet
  std::vector<std::array<PlatePoint, 2>> fills;
  std::vector<PlatePoint> undecided;
  double leaf = 0;  ///< side of the finest boxes
};

/// Solves a plane equation by a quadtree of interval tests. A piece of curve is accepted where the function
/// is proven continuous and changes sign, or where a zero without change of sign is found that cannot be
/// distinguished from zero because of rounding. Boxes that are neither excluded nor proven are returned as
/// undecided.
class PlaneTracer {
 public:
  /// @param cells  finest boxes per side. @param margin  in unit coordinates.
  PlaneTracer(const PlaneEquation& equation, int cells, double margin, WorkProgress& progress);
  /// @return false when it was stopped.
  bool run(PlaneSolution& solution);

 private:
  using Point = PlatePoint;
  using Gradient = Dual<double, 2>;
  struct Square {
    double u = 0;
    double v = 0;
    double side = 0;
  };

  [[nodiscard]] double value(Point p);
  [[nodiscard]] Gradient gradient(Point p);
  [[nodiscard]] Interval enclose(const Tape& tape, Interval u, Interval v);
  [[nodiscard]] Interval enclose(const Tape& tape, const Square& s);
  [[nodiscard]] bool is_zero_at(Point p);
  [[nodiscard]] bool counts_at(Point p);
  [[nodiscard]] bool fills(const Square& s);

  void visit(const Square& s, int level);
  bool draw_graph(const Square& s, const Interval& slope_u, const Interval& slope_v, bool finest);
  void settle_leaf(const Square& s, bool continuous);
  void join(const Square& s, std::vector<Point>& roots);
  void add_edge_roots(Point p, Point q, bool continuous, std::vector<Point>& roots);
  void add_root(Point p, Point q, double fp, double fq, bool continuous, std::vector<Point>& roots);
  bool find_critical(const Square& s, Point& at);
  bool find_hidden(const Square& s, bool continuous);
  bool look_closer(const Square& s);
  [[nodiscard]] std::array<double, 2> roundest_in(const Square& s) const;
  [[nodiscard]] bool is_exactly_zero(const std::array<double, 2>& at);

  PlaneEquation equation_;
  int cells_;
  double margin_;
  WorkProgress& progress_;
  PlaneSolution* out_ = nullptr;
  Tape function_;
  Tape whole_;
  std::vector<std::vector<Tape>> areas_;
  bool has_whole_ = false;
  int finest_level_ = 0;
  double tolerance_ = 0;
  std::array<double, 2> range_{};
  std::vector<double> values_;
  std::vector<Gradient> gradients_;
  std::vector<Interval> intervals_;
  std::vector<Dual<Interval, 2>> duals_;
  std::int64_t closer_looks_ = 0;
  bool rejected_ = false;
  double done_ = 0;
};

/// Joins segments that share an end into polylines.
[[nodiscard]] std::vector<std::vector<PlatePoint>> stitched(
    const std::vector<PlaneSolution::Segment>& segments, double tolerance);

}  // namespace nazori::functions
