// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "nazori/functions/tape.h"
#include "nazori/functions/tracing.h"
#include "work_progress.h"

namespace nazori::functions {

/// A curve (x(p), y(p)) over a range of its parameter p.
struct Arc {
  Expression x;
  Expression y;
  Variable parameter = Variable::x;
  double from = 0;
  double to = 1;
  bool ends_are_real = false;  ///< the range belongs to the curve, not to the window
  bool from_is_open = false;   ///< the end itself does not belong to the curve
  bool to_is_open = false;

  /// How closely an excluded end is approached, as a parameter.
  [[nodiscard]] double hair() const;
  /// Whether the parameter is that of such an end, within the precision of numbers.
  [[nodiscard]] bool is_open_end(double t) const;
};

/// Follows an arc by bisecting its parameter until intervals prove each piece: outside, straight within the
/// tolerance, dense, or a break, whose kind is then determined.
class ArcTracer {
 public:
  ArcTracer(const Arc& arc, int statement, const TraceSettings& settings, Tracing& out,
            WorkProgress& progress);
  /// @return false when it was stopped.
  bool run();

 private:
  struct Sample {
    double t = 0;
    double u = 0;
    double v = 0;
    [[nodiscard]] bool exists() const;
  };
  /// Enclosures over a piece of the parameter, in plate units.
  struct Box {
    Interval u;
    Interval v;
    Interval slope_u;
    Interval slope_v;
    [[nodiscard]] bool is_continuous() const { return u.is_continuous() && v.is_continuous(); }
    [[nodiscard]] Cause cause() const { return u.cause | v.cause; }
  };
  struct PointBox {
    Interval u;
    Interval v;
  };
  enum class Side : std::uint8_t { undefined, settled, growing, wandering };

  [[nodiscard]] Sample sample(double t);
  [[nodiscard]] Box enclose(double from, double to);
  [[nodiscard]] PointBox enclose_point(double t);
  template <class R>
  [[nodiscard]] Box enclose_with(double from, double to, std::vector<Dual<BasicInterval<R>, 1>>& registers);
  void visit(const Sample& a, const Sample& b, int depth);
  [[nodiscard]] bool is_outside(const Interval& u, const Interval& v) const;
  [[nodiscard]] bool is_straight(const Sample& a, const Sample& b, const Box& box) const;
  bool settle_invisible(const Sample& a, const Sample& b, const Box& box);
  bool draw_narrow(const Sample& a, const Sample& b, const Box& box, bool may_split);
  [[nodiscard]] Interval by_mean_value(const Sample& a, const Sample& b, const Box& box, bool upright);
  void split(const Sample& a, const Sample& b, int depth);
  void settle_break(const Sample& a, const Sample& b, const Box& box);
  [[nodiscard]] Side side(const Sample& near, double away);
  [[nodiscard]] bool is_reliable(const Sample& s);
  [[nodiscard]] Sample nearest_reliable(const Sample& from, double away);
  void extend(const Sample& a, const Sample& b);
  void end_branch();
  void add_bar(PlatePoint from, PlatePoint to);
  void add_event(EventKind kind, const Sample& at, const Sample* after = nullptr);
  [[nodiscard]] bool is_near(const Sample& a, const Sample& b, double distance) const;
  [[nodiscard]] bool is_inside(const Sample& s) const;

  Arc arc_;
  int statement_;
  TraceSettings settings_;
  Tracing& out_;
  WorkProgress& progress_;
  Tape tape_;
  double tolerance_;
  double cell_;
  std::array<double, 2> scale_;
  std::vector<double> values_;
  std::vector<Interval> intervals_;
  std::vector<long double> long_values_;
  std::vector<Dual<Interval, 1>> duals_;
  std::vector<Dual<LongInterval, 1>> long_duals_;
  Branch branch_;
  std::int64_t narrow_breaks_ = 0;
  std::int64_t blunt_pieces_ = 0;
  std::size_t first_bar_ = 0;
  bool after_dense_ = false;
  double undecided_area_ = 0;  ///< in plate units
};

}  // namespace nazori::functions
