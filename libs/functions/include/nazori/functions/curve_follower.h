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
  double x = 0;  ///< in the units of the window, computed by the expression itself where possible
  double y = 0;
  int statement = 0;
  std::optional<CurvePlace> on;  ///< nothing: a single point that is not on a curve
};

/// Follows the curves of a drawing step by step, for keys. Branches come in the order of their statements,
/// then from left to right, lower ones first. Thread: one.
class CurveFollower {
 public:
  /// One hundredth of the window.
  static constexpr double kStep = 0.01;

  /// Sets another drawing: the location stays at the same point of the plane, moved to the nearest curve.
  void set_drawing(SharedDrawing drawing);
  /// The present location; nothing before the first move, and if there is no curve.
  [[nodiscard]] const std::optional<PlotLocation>& location() const { return location_; }

  enum class Way { back = -1, on = 1 };
  enum class Step { done, next_branch, end };
  /// Moves by kStep along the curve; from the end of a branch to the next one of the same curve.
  Step step(Way way);
  /// Moves to the point of the curve at the next tick of the x axis, or to its end.
  Step step_to_tick(Way way);
  void go_to_end(Way way);
  /// Moves to another branch, at the same x if possible.
  bool change_branch(Way way);
  /// Moves to the next point of interest in the order of the table; after the last to the first.
  const PointOfInterest* next_point(Way way);
  void go_to(const PointOfInterest& point);
  void go_to(double x, double y);

  /// The point of interest within half a step of the location, among those of the drawing.
  [[nodiscard]] const PointOfInterest* point_here() const;
  /// dy/dx at the location; infinite where the curve is vertical, nothing where it has no slope.
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
  /// The first location, if there is none yet: the curve nearest to the middle of the window.
  bool begin();
  Step pass_end(Way way);
  /// Near a tick: moves exactly onto it, if y is known there.
  void stand_on_tick(double x);

  SharedDrawing drawing_;
  std::optional<PlotLocation> location_;
  std::ptrdiff_t point_ = -1;  ///< index of the point of interest visited last
  std::vector<Beacon> beacons_;
  std::size_t beacon_ = 0;
};

}  // namespace nazori::functions
