// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "nazori/functions/drawing.h"

namespace nazori::functions {

/// A location on a plot.
struct PlotLocation {
  PlatePoint at;
  double x = 0;  ///< in the units of the window, by the expression itself where it gives them
  double y = 0;
  int statement = 0;
  std::optional<CurvePlace> on;  ///< nothing: a single point beside the curves
};

/// Follows the curves of a drawing step by step, as keys ask for it. Branches come in the order of their
/// statements, then from left to right, lower ones first. Thread: one.
class CurveFollower {
 public:
  /// One hundredth of the window.
  static constexpr double kStep = 0.01;

  /// Another drawing: the location stays where it was in the plane, on the nearest curve.
  void set_drawing(SharedDrawing drawing);
  /// Nothing before the first move, and where there is no curve.
  [[nodiscard]] const std::optional<PlotLocation>& location() const { return location_; }

  enum class Way { back = -1, on = 1 };
  enum class Step { done, next_branch, end };
  /// By kStep along the curve; past the end of a branch to the next one of the same curve.
  Step step(Way way);
  /// To where the curve meets the next tick of the x axis, or to its end.
  Step step_to_tick(Way way);
  void go_to_end(Way way);
  /// To another branch, at the same x where it has that.
  bool change_branch(Way way);
  /// The next point of interest in the order of the table; round.
  const PointOfInterest* next_point(Way way);
  void go_to(const PointOfInterest& point);
  void go_to(double x, double y);

  /// The point of interest within half a step of the location; of the drawing.
  [[nodiscard]] const PointOfInterest* point_here() const;
  /// dy/dx at the location; infinite where the curve is upright, nothing where it has no slope.
  [[nodiscard]] std::optional<double> slope() const;

  void drop_beacon();
  /// @return its number from 1; 0: there is none.
  int go_to_next_beacon();
  [[nodiscard]] std::size_t beacon_count() const { return beacons_.size(); }

  /// The location on a curve nearest to a point of the plate, for a hand that touches.
  [[nodiscard]] std::optional<PlotLocation> nearest(PlatePoint hand) const;

 private:
  struct Beacon {
    double x;
    double y;
  };

  [[nodiscard]] const Tracing& tracing() const { return drawing_->picture.tracing; }
  [[nodiscard]] std::vector<std::size_t> order() const;
  [[nodiscard]] bool runs_left(std::size_t branch) const;
  [[nodiscard]] CurvePlace end_of(std::size_t branch, bool last) const;
  [[nodiscard]] PlotLocation described(const CurvePlace& on) const;
  /// The first location, where there is none yet: the curve nearest to the middle of the window.
  bool begin();
  Step pass_end(Way way);
  /// The hand is next to a tick: exactly on it, where y is known there.
  void stand_on_tick(double x);

  SharedDrawing drawing_;
  std::optional<PlotLocation> location_;
  std::ptrdiff_t point_ = -1;  ///< of interest, the last one gone to
  std::vector<Beacon> beacons_;
  std::size_t beacon_ = 0;
};

}  // namespace nazori::functions
