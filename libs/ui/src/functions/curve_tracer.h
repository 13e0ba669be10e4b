// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "functions/plotter.h"
#include "nazori/functions/tablet_curves.h"

namespace nazori::ui {

/// Where the hand is on a plot.
struct TracePlace {
  functions::PlatePoint at;
  double x = 0;  ///< in the units of the window, by the expression itself where it gives them
  double y = 0;
  int statement = 0;
  std::optional<functions::CurvePlace> on;  ///< nothing: a single point beside the curves
};

/// Walks along the curves of a drawing, step by step, as keys ask for it. Branches come in the order of their
/// statements, then from left to right, lower ones first. Thread: one.
class CurveTracer {
 public:
  /// One hundredth of the window.
  static constexpr double kStep = 0.01;

  /// Another drawing: the place stays where it was in the plane, on the nearest curve.
  void set_drawing(SharedDrawing drawing);
  /// Nothing before the first move, and where there is no curve.
  [[nodiscard]] const std::optional<TracePlace>& place() const { return place_; }

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
  const functions::PointOfInterest* next_point(Way way);
  void go_to(const functions::PointOfInterest& point);
  void go_to(double x, double y);

  /// The point of interest within half a step of the place.
  [[nodiscard]] const functions::PointOfInterest* point_here() const;
  /// dy/dx at the place; infinite where the curve is upright, nothing where it has no slope.
  [[nodiscard]] std::optional<double> slope() const;

  void drop_beacon();
  /// @return its number from 1; 0: there is none.
  int go_to_next_beacon();
  [[nodiscard]] std::size_t beacon_count() const { return beacons_.size(); }

  /// The place in the plane nearest to a point of the plate, for a hand that touches.
  [[nodiscard]] std::optional<TracePlace> nearest(functions::PlatePoint hand) const;

 private:
  struct Beacon {
    double x;
    double y;
  };

  [[nodiscard]] const functions::Tracing& tracing() const { return drawing_->picture.tracing; }
  [[nodiscard]] std::vector<std::size_t> order() const;
  [[nodiscard]] bool runs_left(std::size_t branch) const;
  [[nodiscard]] functions::CurvePlace end_of(std::size_t branch, bool last) const;
  [[nodiscard]] TracePlace described(const functions::CurvePlace& on) const;
  /// The first place, where there is none yet: the curve nearest to the middle of the window.
  bool begin();
  Step pass_end(Way way);
  /// The hand is next to a tick: exactly on it, where y is known there.
  void stand_on_tick(double x);

  SharedDrawing drawing_;
  std::optional<TracePlace> place_;
  std::ptrdiff_t point_ = -1;  ///< of interest, the last one gone to
  std::vector<Beacon> beacons_;
  std::size_t beacon_ = 0;
};

}  // namespace nazori::ui
